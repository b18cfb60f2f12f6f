#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/study_files.hpp"
#include "cli/study_size_models.hpp"
#include "files/byte_source.hpp"
#include "files/file_lines.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "papers/paper_figures.hpp"
#include "papers/paper_statements.hpp"
#include "papers/paper_tables.hpp"
#include "papers/specimens.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <atomic>
#include <memory>

namespace mdm::cli {
namespace {

struct StudyCommand {
  std::string what, paper = "arnold";
  std::vector<std::string> files;
  std::optional<std::string> out, plots;
  SizeModelFlags size_models;
  OutputFlags output;
};

/// The numbers of every gradation of the suite.
struct Survey {
  std::vector<SurveyRow> rows;
  std::vector<Convergence> runs; ///< of the subset
};

Survey survey_of(const StudyCommand &c) {
  const std::string &file = c.files.front();
  std::atomic<std::uint64_t> count = 0;
  const ProgressLine progress([&count] { return fmt::format("{} gradations", count.load()); },
                              c.output.quiet);
  Survey survey;
  FileLines lines(file);
  constexpr std::size_t at_once = 512;
  std::uint64_t number = 0;
  for (std::vector<FileLines::Line> chunk = lines.next(at_once); !chunk.empty(); chunk = lines.next(at_once))
    for (const FileLines::Line &line : chunk) {
      const std::string where = line_name(file, ++number);
      if (!line)
        throw file_error(where, FileLines::too_long("the line") + ": is it the right file?");
      if (line->find_first_not_of(" \t\r") == std::string::npos)
        continue;
      const Gradation g = read_json_gradation(*line, where, std::to_string(number));
      in_file(where, [&] {
        if (survey.rows.size() % subset_step == 0)
          survey.runs.push_back(convergence(g));
        survey.rows.push_back(mdm::survey(g));
      });
      ++count;
    }
  if (survey.rows.empty())
    throw file_error(file, "there is no gradation: give JSON Lines, one gradation a line");
  return survey;
}

std::vector<StudyFile> tables(const Survey &s) {
  return {{"table1.csv", table1_csv(s.rows)},
          {"figure1.csv", figure1_csv(s.rows)},
          {"figure2.csv", figure2_csv(s.runs)},
          {"figure3.csv", figure3_csv(s.rows)},
          {"figure4.csv", figure4_csv(s.rows)},
          {"figure5.csv", figure5_csv(s.rows)},
          {"statements.csv", statements_table(paper_statements(s.rows, s.runs))}};
}

int run_figures(const StudyCommand &c) {
  if (c.files.size() != 1)
    throw InputError("study figures takes one file, the suite: mdm study figures SUITE --out DIR");
  if (!c.out)
    throw InputError(option("out") + " is missing: name the folder for the files");
  const Survey survey = survey_of(c);
  std::vector<StudyFile> files = tables(survey);
  if (c.plots) {
    const StudyPictures pictures(*c.plots, c.output.quiet);
    files.push_back(pictures.drawn("figure1", paper_figure1(survey.rows)));
    files.push_back(pictures.drawn("figure2", paper_figure2(survey.runs)));
    files.push_back(pictures.drawn("figure3", paper_figure3(survey.rows)));
    files.push_back(pictures.drawn("figure4", paper_figure4(survey.rows)));
    files.push_back(pictures.drawn("figure5", paper_figure5(survey.rows)));
  }
  std::vector<std::string> written;
  for (const StudyFile &file : files)
    written.push_back(*c.out + "/" + file.name);
  check_paths(c.files, written);
  write_all(*c.out, files);
  return Exit::done;
}

int run_voivret(const StudyCommand &c) {
  if (!c.what.empty() || !c.files.empty())
    throw InputError(option("paper") +
                     " voivret is without WHAT and FILE: mdm study --paper voivret --out DIR");
  if (!c.out)
    throw InputError(option("out") + " is missing: name the folder for the files");
  return run_size_models(c.size_models, *c.out, c.plots, c.output.quiet);
}

int run_specimens(const StudyCommand &c) {
  if (c.files.size() != 2)
    throw InputError("study specimens takes two files: mdm study specimens GRADATION SPECIMENS");
  if (c.plots)
    throw InputError(option("plots") + ": not an option of specimens: leave it out");
  check_paths(c.files, {c.out ? *c.out + "/specimens.csv" : "-"});
  const std::string &file = c.files[0];
  const Gradation g = read_gradation(read_file(file, max_gradation_bytes), shown_name(file));
  if (g.unit() != SizeUnit::mm)
    throw file_error(file, "the specimens are in mm: give the gradation in mm");
  const std::vector<Specimen> specimens =
      read_specimens(read_file(c.files[1], max_gradation_bytes), shown_name(c.files[1]));
  const ProgressLine progress([] { return std::string("solving"); }, c.output.quiet);
  if (!c.out)
    write_output("-", specimens_text(g, specimens));
  else
    write_all(*c.out, {{"specimens.csv", specimens_csv(g, specimens)}});
  return Exit::done;
}

} // namespace

Run add_study(CLI::App &app) {
  const auto c = std::make_shared<StudyCommand>();
  CLI::App &command = *app.add_subcommand(
      "study", "The papers' tables and figures, and published specimens, with exact numbers");
  command
      .add_option("WHAT", c->what,
                  "figures (FILE: a suite, JSON Lines) or specimens (FILE: the gradation, then the table of "
                  "specimens)")
      ->check(CLI::IsMember({"figures", "specimens"}));
  command.add_option("FILE", c->files, "as WHAT says; - for standard input");
  command
      .add_option(
          "--paper", c->paper,
          "arnold: Table 1 and Figures 1 to 5 of a suite (the default); voivret: the figures on models "
          "of size distributions and packings, without WHAT and FILE; some minutes")
      ->check(CLI::IsMember({"arnold", "voivret"}));
  command
      .add_option("--out", c->out,
                  "write CSV files into the folder DIR, made if need be: table1.csv, figure1.csv, ... "
                  "(figures and voivret need it), or specimens.csv (without it shown as text)")
      ->type_name("DIR");
  command.add_option("--plots", c->plots, "draw the figures as well, as svg, png or pdf")
      ->check(CLI::IsMember({"svg", "png", "pdf"}));
  c->size_models.add_to(command);
  c->output.add_quiet(command, "no progress and no notes on standard error");
  command.footer(footer(
      paragraph(
          "The deposits of Figure 9 are kept in DIR/figure9.journal.jsonl as they are done: a study that "
          "was interrupted goes on from there when it is started again with the same command."),
      {"mdm study figures suite.jsonl --out study --plots svg", "mdm study specimens sand.csv specimens.csv",
       "mdm study --paper voivret --out models --plots svg"}));
  return [c] {
    if (c->paper == "voivret")
      return run_voivret(*c);
    if (c->size_models.is_given())
      throw InputError(option("only") + ", " + option("at-least") + ", " + option("at-most") + ", " +
                       option("seeds") + ", " + option("spans") + " and -j are of " + option("paper") +
                       " voivret: add "
                       "it or leave them out");
    if (c->what.empty())
      throw InputError("WHAT is missing: figures or specimens, or " + option("paper") +
                       " voivret; see mdm study --help");
    return c->what == "figures" ? run_figures(*c) : run_specimens(*c);
  };
}

} // namespace mdm::cli
