#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/option_values.hpp"
#include "cli/output_flags.hpp"
#include "cli/picture.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_file.hpp"
#include "cli/search_progress.hpp"
#include "cli/solve_flags.hpp"
#include "plot/tradeoff_figure.hpp"
#include "report/tradeoff_report.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <memory>

namespace mdm::cli {
namespace {

struct TradeoffCommand {
  using Text = std::optional<std::string>;
  std::string file;
  GradationFlags flags;
  std::string kind = "retained";
  std::string tolerances = "0,0.1,0.2,0.5,1,2,5";
  Text min_per_class, max_steps, node_limit, time_limit;
  Text plot;
  ReadingFlags reading;
  OutputFlags output;
};

/// `0,0.5,1` with or without percent signs.
std::vector<AskedTolerance> tolerances(const TradeoffCommand &c) {
  std::vector<AskedTolerance> all;
  for (std::size_t from = 0; from <= c.tolerances.size();) {
    const std::size_t to = std::min(c.tolerances.find(',', from), c.tolerances.size());
    std::string one(trimmed(std::string_view(c.tolerances).substr(from, to - from)));
    if (!one.ends_with('%'))
      one += '%';
    all.push_back(named("--tolerances", c.kind + ":" + one, parse_tolerance));
    from = to + 1;
  }
  return all;
}

TradeoffOptions options(const TradeoffCommand &c) {
  TradeoffOptions o;
  for (const AskedTolerance &t : tolerances(c)) {
    o.kind = t.kind;
    o.tolerances.push_back(t.percent);
  }
  if (c.max_steps)
    o.limits.max_steps = natural64("--max-steps", *c.max_steps);
  if (c.node_limit)
    o.limits.node_limit = natural64("--node-limit", *c.node_limit);
  if (c.time_limit)
    o.time_limit = duration("--time-limit", *c.time_limit);
  return o;
}

Question question(const TradeoffCommand &c) {
  Question q = c.flags.question();
  if (c.min_per_class)
    q.min_per_class = natural("--min-per-class", *c.min_per_class, 0);
  return q;
}

std::string report(const TradeoffCommand &c, const Tradeoff &t) {
  return c.output.report([&] { return tradeoff_text(t); }, [&] { return tradeoff_json(t); },
                         [&] { return tradeoff_csv(t); });
}

bool is_complete(const std::vector<TradeoffRow> &rows) {
  return std::all_of(rows.begin(), rows.end(), [](const TradeoffRow &row) { return row.is_optimal(); });
}

/// Both curves, or what is certain of them when Ctrl-C is pressed.
Tradeoff searched(const TradeoffCommand &c, const Gradation &g, const Question &q, TradeoffOptions o) {
  SearchProgress progress(c.output.quiet);
  o.progress = progress.call();
  return in_file(c.file, [&] { return tradeoff(g, q, o); });
}

int run(const TradeoffCommand &c) {
  if (c.plot == "-")
    throw InputError("--plot needs a file: standard output has the tables");
  check_distinct({c.file, c.output.path(), c.plot.value_or("-")});
  const std::optional<Picture> picture = c.plot ? picture_at(*c.plot) : std::nullopt;
  if (c.plot && !picture)
    throw InputError("--plot: " + printable(*c.plot) + ": let OUT end in .svg, .png or .pdf");
  const TradeoffOptions o = options(c);
  const Question q = question(c);
  refuse_sample(c.file);
  const Gradation g =
      read_gradation(read_file(c.file, max_gradation_bytes), shown_name(c.file), c.reading.reading());
  Output out(c.output.path());
  const Tradeoff t = searched(c, g, q, o);
  std::unique_ptr<Output> plot;
  if (picture) {
    plot = std::make_unique<Output>(*c.plot);
    const Figure figure = tradeoff_figure(t);
    plot->write(run_gnuplot(gnuplot_script(figure, *picture)));
    if (!c.output.quiet)
      tell_escapes(figure);
  }
  out.write(report(c, t));
  c.output.tell_notes_beside_csv(t.gradation.notes());
  if (plot)
    plot->commit();
  out.commit();
  return is_complete(t.by_tolerance) && is_complete(t.by_sieve) ? Exit::done : Exit::limited;
}

} // namespace

Run add_tradeoff(CLI::App &app) {
  const auto c = std::make_shared<TradeoffCommand>();
  CLI::App &command = *app.add_subcommand(
      "tradeoff", "The smallest N over a tolerance, and over the smallest sieve that is kept");
  command
      .add_option("FILE", c->file,
                  "gradation: CSV, JSON, AGS4, or another file that mdm convert reads; - for standard input")
      ->required();
  command
      .add_option("--kind", c->kind,
                  "what the tolerances are of: retained (percent in each class), passing (percent passing "
                  "each sieve) or total (the sum of all deviations of percent retained)")
      ->check(CLI::IsMember({"retained", "passing", "total"}));
  command
      .add_option("--tolerances", c->tolerances,
                  "tolerances in percentage points (0,0.1,0.2,0.5,1,2,5); 0 is the exact match")
      ->type_name("LIST");
  command.add_option("--min-per-class", c->min_per_class, "at least R particles in every class with mass")
      ->type_name("R");
  c->flags.add_to(command);
  command
      .add_option("--max-steps", c->max_steps, "stop an exact match after so many steps (67108864; exit 3)")
      ->type_name("N");
  command
      .add_option("--node-limit", c->node_limit,
                  "stop a match within a tolerance after so many nodes (exit 3)")
      ->type_name("N");
  command.add_option("--time-limit", c->time_limit, "stop each match after so many seconds (exit 3)")
      ->type_name("S");
  command.add_option("--plot", c->plot, "draw both into OUT.svg, .png or .pdf (needs gnuplot)")
      ->type_name("OUT");
  c->output.add_format(command);
  c->output.add_out(command, "write the tables");
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer("", {"mdm tradeoff sand.csv",
                             "mdm tradeoff sand.csv --kind passing --tolerances 0,0.5,1,2 --plot sand.svg",
                             "mdm tradeoff sand.csv --min-per-class 10 --format csv -o sand-tradeoff.csv"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
