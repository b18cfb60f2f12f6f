#include "ask/outcome.hpp"
#include "ask/tradeoff_options.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/option_tables.hpp"
#include "cli/output_flags.hpp"
#include "cli/plot_flag.hpp"
#include "cli/reading_flags.hpp"
#include "cli/search_progress.hpp"
#include "cli/solve_flags.hpp"
#include "files/byte_source.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/sample_file.hpp"
#include "plot/tradeoff_figure.hpp"
#include "report/tradeoff_report.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <memory>

namespace mdm::cli {
namespace {

constexpr auto without_effect =
    "taken as solve takes it, without effect here: no sizes and no scale are shown";

struct TradeoffCommand {
  std::string file;
  SolveFlags flags;
  TradeoffTexts own; ///< but for those of solving
  PlotFlag plot;
  ReadingFlags reading;
  OutputFlags output;
};

std::string report(const TradeoffCommand &c, const Tradeoff &t) {
  return c.output.report([&] { return tradeoff_text(t); }, [&] { return tradeoff_json(t); },
                         [&] { return tradeoff_csv(t); });
}

/// Both curves, or what is certain of them when Ctrl-C is pressed.
Tradeoff searched(const TradeoffCommand &c, const Gradation &g, const Question &q, TradeoffOptions o) {
  SearchProgress progress(c.output.quiet);
  o.progress = progress.call();
  return in_file(c.file, [&] { return tradeoff(g, q, o); });
}

int run(const TradeoffCommand &c) {
  c.flags.check_source(c.file, c.reading.given(), "tradeoff");
  check_distinct({c.file, c.output.path(), c.plot.path()});
  c.plot.check();
  TradeoffTexts texts = c.own;
  texts.solve = c.flags;
  texts.take_kind();
  const TradeoffOptions o = texts.tradeoff_options();
  const AskedQuestion asked = texts.solve.question_of_both(band_in_file);
  refuse_sample(c.file);
  const Gradation g =
      read_gradation(read_file(c.file, max_gradation_bytes), shown_name(c.file), c.reading.reading());
  const Question q = asked.of(g);
  Output out(c.output.path());
  const Tradeoff t = searched(c, g, q, o);
  const std::unique_ptr<Output> plot = c.plot ? c.plot.drawn(tradeoff_figure(t), c.output.quiet) : nullptr;
  out.write(report(c, t));
  c.output.tell_notes_beside_csv(tradeoff_notes(t));
  if (plot)
    plot->commit();
  out.commit();
  return exit_code(outcome_of(t));
}

} // namespace

Run add_tradeoff(CLI::App &app) {
  const auto c = std::make_shared<TradeoffCommand>();
  CLI::App &command = *app.add_subcommand(
      "tradeoff",
      "The smallest N over a tolerance, over the smallest sieve that is kept, and over a size factor");
  command
      .add_option("FILE", c->file,
                  "gradation: CSV, JSON, AGS4, or another file that mdm convert reads; - for standard input")
      ->required();
  add_options(command, TradeoffTexts::options, c->own);
  c->flags.add_problem(command);
  const OptionGroup group(command, "The answer");
  add_options(command, SolveTexts::answer_options, static_cast<SolveTexts &>(c->flags));
  for (const char *const name : {"--digits", "--scale"})
    command.get_option(name)->description(without_effect);
  c->plot.add_to(command, "draw both");
  c->output.add_format(command);
  c->output.add_out(command, "write the tables");
  c->output.add_verbose(command, without_effect);
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph(
          "Each row is the smallest match for the whole question: --tolerance and --band hold in all rows, "
          "--tolerances besides them in those of the first table. With a specimen, or a volume of solids, "
          "and --particles a third table has the least size factors with which so many particles suffice. "
          "Beside --particles, --tolerance passing without a value is --kind passing."),
      {"mdm tradeoff sand.csv", "mdm tradeoff sand.csv --kind passing --tolerances 0,0.5,1,2 --plot sand.svg",
       "mdm tradeoff sand.csv --particles all --plot sand.svg",
       "mdm tradeoff sand.csv --specimen cylinder:50x100 --void-ratio 0.6 --particles 2000,20000"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
