#include "ask/published.hpp"

#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/solve_flags.hpp"
#include "files/byte_source.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "files/sample_file.hpp"
#include "files/sample_proof_files.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <memory>

namespace mdm::cli {
namespace {

struct PublishedCommand {
  PublishedTexts asked;
  std::string file;
  std::optional<std::string> proof;
  ReadingFlags reading;
  OutputFlags output;
};

int run(const PublishedCommand &c) {
  check_distinct({c.file, c.output.path()});
  const PublishedRun algorithm(c.asked);
  refuse_sample(c.file);
  if (c.proof)
    SampleProofFiles::check(*c.proof, {c.file, c.output.path()});
  const UnderstoodGradation read =
      understand_gradation(read_file(c.file, max_gradation_bytes), shown_name(c.file), c.reading.reading());
  ProgressLine progress([] { return std::string("running the algorithm"); }, c.output.quiet);
  PublishedReport report = in_file(c.file, [&] { return algorithm.report(read.gradation); });
  Output out(c.output.path());
  std::optional<SampleProofFiles> files;
  if (c.proof) {
    files.emplace(*c.proof, c.file, read, std::nullopt);
    in_file(c.file, [&] {
      const std::optional<CertifiedSample> made = algorithm.certified(report, files->begin());
      files->write(made ? made->text : "",
                   made ? "" : "its sample has no particles, or an irrational law leaves it open",
                   report.notes);
    });
  }
  out.write(c.output.report([&] { return published_text(report); }, [&] { return published_json(report); },
                            [&] { return published_csv(report); }));
  if (files)
    files->commit();
  out.commit();
  c.output.tell_notes_beside_csv(report.notes);
  // CSV has no place for the least match.
  if (!c.output.is_csv() && !report.least.is_point())
    return Exit::limited;
  return exit_code(outcome_of(report));
}

} // namespace

Run add_published(CLI::App &app) {
  const auto c = std::make_shared<PublishedCommand>();
  CLI::App &command = *app.add_subcommand(
      "published", "The algorithms of Arnold's paper as published, beside the smallest match");
  command
      .add_option("ALGORITHM", c->asked.algorithm,
                  "rounded (Eq. 18), fixed-size (FS) or spanned-integer (SI)")
      ->required()
      ->check(CLI::IsMember({"rounded", "fixed-size", "spanned-integer"}));
  command
      .add_option("FILE", c->file,
                  "gradation: CSV, JSON, AGS4, or another file that mdm convert reads; - for standard input")
      ->required();
  add_gradation_options(command, c->asked.gradation);
  add_options(command, PublishedTexts::options, c->asked);
  command
      .add_option("--proof", c->proof,
                  "write a certificate of the sample for mdm-check FILE OUT.sample.csv OUT: its shares and "
                  "errors, and "
                  "whether it matches (fixed-size: within --tolerance), and the sample beside it")
      ->type_name("OUT");
  c->output.add_format(command, "text, json, or csv (the iterations)");
  c->output.add_out(command);
  c->output.add_quiet(command, "no progress on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph("Exit code 3: the smallest match was not found within some seconds; the report has bounds."),
      {"mdm published rounded sand.csv", "mdm published fixed-size sand.csv --format csv",
       "mdm published spanned-integer sand.csv --start 0.5 --increments 1"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
