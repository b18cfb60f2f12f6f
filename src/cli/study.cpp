#include "commands.hpp"
#include "files.hpp"
#include "picture.hpp"
#include "progress.hpp"

#include <mdm/error.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/study/paper_figures.hpp>
#include <mdm/study/paper_tables.hpp>
#include <mdm/study/specimens.hpp>

#include <fmt/core.h>

#include <atomic>
#include <memory>

namespace mdm::cli {
namespace {

struct StudyCommand {
  std::string what;
  std::vector<std::string> files;
  std::optional<std::string> out, plots;
  bool quiet = false;
};

/// A file of the study, complete in memory before any is written.
struct StudyFile {
  std::string name, text;
};

/// What is known of every gradation of the suite.
struct Survey {
  std::vector<SurveyRow> rows;
  std::vector<Convergence> runs; ///< of the subset
};

Survey survey_of(const StudyCommand &c) {
  const std::string &file = c.files.front();
  std::atomic<std::uint64_t> count = 0;
  const Progress progress([&count] { return fmt::format("{} gradations", count.load()); }, c.quiet);
  Survey survey;
  Lines lines(file);
  constexpr std::size_t at_once = 512;
  std::uint64_t number = 0;
  for (std::vector<Lines::Line> chunk = lines.next(at_once); !chunk.empty(); chunk = lines.next(at_once))
    for (const Lines::Line &line : chunk) {
      const std::string where = shown_name(file) + ":" + std::to_string(++number);
      if (!line)
        throw InputError(printable(where) + ": the line has more than 64 MiB: is it the right file?");
      if (line->find_first_not_of(" \t\r") == std::string::npos)
        continue;
      const Gradation g = read_json_gradation(*line, where, std::to_string(number));
      try {
        if (survey.rows.size() % subset_step == 0)
          survey.runs.push_back(convergence(g));
        survey.rows.push_back(mdm::survey(g));
      } catch (const InputError &e) {
        throw InputError(printable(where) + ": " + e.what());
      }
      ++count;
    }
  if (survey.rows.empty())
    throw InputError(printable(shown_name(file)) +
                     ": there is no gradation: give JSON Lines, one gradation a line");
  return survey;
}

std::vector<StudyFile> tables(const Survey &s) {
  return {{"table1.csv", table1_csv(s.rows)},   {"figure1.csv", figure1_csv(s.rows)},
          {"figure2.csv", figure2_csv(s.runs)}, {"figure3.csv", figure3_csv(s.rows)},
          {"figure4.csv", figure4_csv(s.rows)}, {"figure5.csv", figure5_csv(s.rows)}};
}

std::vector<StudyFile> pictures(const Survey &s, const std::string &format, bool quiet) {
  const Figure figures[] = {paper_figure1(s.rows), paper_figure2(s.runs), paper_figure3(s.rows),
                            paper_figure4(s.rows), paper_figure5(s.rows)};
  const Picture picture = format == "png" ? Picture::png : format == "pdf" ? Picture::pdf : Picture::svg;
  std::vector<StudyFile> files;
  for (const Figure &figure : figures) {
    files.push_back(
        {fmt::format("figure{}.{}", files.size() + 1, format), run_gnuplot(gnuplot_script(figure, picture))});
    if (!quiet)
      tell_escapes(figure);
  }
  return files;
}

void write_all(const std::string &folder, const std::vector<StudyFile> &files) {
  make_folder(folder);
  std::vector<std::unique_ptr<Output>> outputs;
  for (const StudyFile &file : files) {
    outputs.push_back(std::make_unique<Output>(folder + "/" + file.name));
    outputs.back()->write(file.text);
  }
  for (const std::unique_ptr<Output> &output : outputs)
    output->commit();
}

int run_figures(const StudyCommand &c) {
  if (c.files.size() != 1)
    throw InputError("study figures takes one file, the suite: mdm study figures SUITE --out DIR");
  if (!c.out)
    throw InputError("--out is missing: name the folder for the files");
  const Survey survey = survey_of(c);
  std::vector<StudyFile> files = tables(survey);
  if (c.plots) {
    std::vector<StudyFile> drawn = pictures(survey, *c.plots, c.quiet);
    std::move(drawn.begin(), drawn.end(), std::back_inserter(files));
  }
  write_all(*c.out, files);
  return Exit::done;
}

int run_specimens(const StudyCommand &c) {
  if (c.files.size() != 2)
    throw InputError("study specimens takes two files: mdm study specimens GRADATION SPECIMENS");
  if (c.plots)
    throw InputError("--plots: not an option of specimens: leave it out");
  check_distinct(c.files);
  const std::string &file = c.files[0];
  const Gradation g = read_gradation(read_file(file, max_gradation_bytes), shown_name(file));
  if (g.unit() != SizeUnit::mm)
    throw InputError(printable(shown_name(file)) + ": the specimens are in mm: give the gradation in mm");
  const std::vector<Specimen> specimens =
      read_specimens(read_file(c.files[1], max_gradation_bytes), shown_name(c.files[1]));
  const Progress progress([] { return std::string("solving"); }, c.quiet);
  if (!c.out) {
    Output out("-");
    out.write(specimens_text(g, specimens));
    out.commit();
  } else {
    write_all(*c.out, {{"specimens.csv", specimens_csv(g, specimens)}});
  }
  return Exit::done;
}

} // namespace

Run add_study(CLI::App &app) {
  const auto c = std::make_shared<StudyCommand>();
  CLI::App &command = *app.add_subcommand(
      "study", "The paper's Table 1 and Figures 1 to 5 of a suite, and published specimens, with exact N");
  command
      .add_option("WHAT", c->what,
                  "figures (FILE: a suite, JSON Lines) or specimens (FILE: the gradation, then the table of "
                  "specimens)")
      ->required()
      ->check(CLI::IsMember({"figures", "specimens"}));
  command.add_option("FILE", c->files, "as WHAT says; - for standard input")->required();
  command
      .add_option("--out", c->out,
                  "write CSV files into the folder DIR, made if need be: table1.csv, figure1.csv to "
                  "figure5.csv, or specimens.csv (else shown as text)")
      ->type_name("DIR");
  command.add_option("--plots", c->plots, "figures: draw them as well, as svg, png or pdf (needs gnuplot)")
      ->check(CLI::IsMember({"svg", "png", "pdf"}));
  command.add_flag("--quiet", c->quiet, "no progress and no notes on standard error");
  command.footer("Example: mdm study figures suite.jsonl --out study --plots svg");
  return [c] { return c->what == "figures" ? run_figures(*c) : run_specimens(*c); };
}

} // namespace mdm::cli
