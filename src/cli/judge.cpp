#include "ask/option_values.hpp"
#include "ask/outcome.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/plot_flag.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_files.hpp"
#include "cli/whole_number.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/sample_file.hpp"
#include "files/sample_names.hpp"
#include "files/specification_file.hpp"
#include "judge/filter.hpp"
#include "judge/job_mix.hpp"
#include "judge/stability.hpp"
#include "plot/curves_figure.hpp"
#include "report/conformity_report.hpp"
#include "report/rule_report.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <fmt/format.h>

#include <memory>

namespace mdm::cli {
namespace {

struct JudgeCommand {
  SampleFiles files;
  std::optional<std::string> spec, job_mix, stability, base, rule, rounding;
  std::vector<std::string> limits, within;

  bool has_limits() const { return spec || job_mix; }
  bool dispersive = false, no_regrade = false;
  ReadingFlags reading;
  std::optional<unsigned> digits;
  PlotFlag plot;
  OutputFlags output;
};

void check(const JudgeCommand &c) {
  if (int{c.spec.has_value()} + int{c.job_mix.has_value()} + int{c.stability.has_value()} +
          int{c.base.has_value()} !=
      1)
    throw InputError(
        fmt::format("one of {}, {}, {} and {} says what is judged: give a file of "
                    "limits or one of {}; the gradation of a job mix; a rule of stability; or the "
                    "base that a filter is for",
                    option("spec"), option("job-mix"), option("stability"), option("filter-for"),
                    fmt::join(shipped_specifications(), ", ")));
  if (c.job_mix.has_value() != !c.within.empty())
    throw InputError(option("job-mix") + " and " + option("within") +
                     " go together: the mix, and how many points a sample may be from it");
  if (!c.has_limits() && !c.limits.empty())
    throw InputError(option("limit") + " is beside the limits of a specification: give " + option("spec") +
                     " too");
  if (!c.base && (c.rule || c.dispersive || c.no_regrade))
    throw InputError(option("rule") + ", " + option("dispersive") + " and " + option("no-regrade") +
                     " are about filters: give " + option("filter-for") + " too");
  std::vector<std::string> inputs = c.files.paths;
  for (const std::optional<std::string> &more : {c.spec, c.job_mix, c.base})
    if (more)
      inputs.push_back(*more);
  check_paths(inputs, {c.output.path(), c.plot.path()});
  c.plot.check();
}

constexpr unsigned exchanged_digits = 15, read_digits = 6;

/// The report in the form that was asked for.
template <class Report>
std::string report(const JudgeCommand &c, const Report &r, std::string (&text)(const Report &, unsigned),
                   std::string (&json)(const Report &, unsigned),
                   std::string (&csv)(const Report &, unsigned)) {
  return c.output.report([&] { return text(r, c.digits.value_or(read_digits)); },
                         [&] { return json(r, c.digits.value_or(exchanged_digits)); },
                         [&] { return csv(r, c.digits.value_or(exchanged_digits)); });
}

/// Notes of the rule or the specification, then of each sample with its name.
template <class Judgement>
std::vector<std::string> all_notes(std::vector<std::string> notes, const std::vector<Judgement> &samples) {
  for (const Judgement &s : samples)
    for (const std::string &note : s.notes)
      notes.push_back(s.id + ": " + note);
  return notes;
}

/// What was judged, by whatever it was judged.
struct Judged {
  std::string report;
  std::vector<std::string> notes;
  Compliance verdict;
  CurvesFigure figure;
};

/// A sample with its verdict. \param missed  in mm
template <class Judgement>
DrawnCurve drawn(const UnderstoodGradation &g, const Judgement &judged, std::vector<Rational> missed = {}) {
  return {fmt::format("{}: {}", judged.id, name(judged.verdict)), g.gradation, DrawnCurve::Weight::thick,
          std::move(missed)};
}

/// \pre limits are asked for
Specification limits_in(const JudgeCommand &c) {
  return c.spec ? specification_at(*c.spec)
                : job_mix_limits(any_curve(*c.job_mix, {}, c.output.quiet).gradation, c.within);
}

Judged by_specification(const JudgeCommand &c) {
  const std::optional<Rational> unit = rounding_of(c.rounding);
  std::vector<FurtherLimit> limits;
  for (const std::string &text : c.limits)
    limits.push_back(parse_further_limit(text));
  ConformityReport r{limits_in(c), {}};
  CurvesFigure figure{r.specification.id, {}, envelope_of(r.specification), {}};
  const ReadSamples read = c.files.read(c.reading, c.output.quiet);
  for (std::size_t i = 0; i < read.samples.size(); ++i)
    r.samples.push_back(
        in_file(read.files[i], [&] { return judge(read.samples[i], r.specification, unit, limits); }));
  tell_apart(r.samples, &Conformity::id, read.files);
  for (std::size_t i = 0; i < read.samples.size(); ++i)
    figure.curves.push_back(drawn(read.samples[i], r.samples[i], missed_sizes(r.samples[i])));
  return {report(c, r, conformity_text, conformity_json, conformity_csv),
          all_notes(r.specification.notes, r.samples), r.verdict(), std::move(figure)};
}

Judged by_rule(const JudgeCommand &c, const RuleReport &r, CurvesFigure figure) {
  figure.title = r.rule;
  return {report(c, r, rule_text, rule_json, rule_csv), all_notes(r.notes, r.samples), r.verdict(),
          std::move(figure)};
}

Judged by_stability(const JudgeCommand &c) {
  const std::optional<StabilityRule> rule = stability_rule(*c.stability);
  if (!rule)
    throw InputError(fmt::format("{}: {} is none of {}", option("stability"), in_quotes(*c.stability),
                                 stability_rule_names()));
  const std::optional<Rational> unit = rounding_of(c.rounding);
  RuleReport r{std::string(name(*rule)), std::string(about(*rule)), {}, {}, {}};
  CurvesFigure figure;
  const ReadSamples read = c.files.read(c.reading, c.output.quiet);
  for (std::size_t i = 0; i < read.samples.size(); ++i)
    r.samples.push_back(
        in_file(read.files[i], [&] { return judge_stability(read.samples[i], *rule, unit); }));
  tell_apart(r.samples, &RuleJudgement::id, read.files);
  for (std::size_t i = 0; i < read.samples.size(); ++i)
    figure.curves.push_back(drawn(read.samples[i], r.samples[i]));
  return by_rule(c, r, std::move(figure));
}

Judged by_filter_rule(const JudgeCommand &c) {
  if (!c.rule)
    throw InputError(option("filter-for") + ": " + option("rule") + " is missing: give one of " +
                     filter_rule_names());
  const std::optional<FilterRule> rule = filter_rule(*c.rule);
  if (!rule)
    throw InputError(
        fmt::format("{}: {} is none of {}", option("rule"), in_quotes(*c.rule), filter_rule_names()));
  const ReadSamples filters = c.files.read(c.reading, c.output.quiet);
  const UnderstoodGradation base = any_curve(*c.base, c.reading, c.output.quiet);
  RuleReport r =
      judge_filters(filters.samples, base, {*rule, c.dispersive, !c.no_regrade}, rounding_of(c.rounding));
  tell_apart(r.samples, &RuleJudgement::id, filters.files);
  CurvesFigure figure;
  figure.curves.push_back({"base: " + base.gradation.id(), base.gradation, DrawnCurve::Weight::dashed});
  for (std::size_t i = 0; i < filters.samples.size(); ++i)
    figure.curves.push_back(drawn(filters.samples[i], r.samples[i]));
  return by_rule(c, r, std::move(figure));
}

/// \pre it is asked for
std::unique_ptr<Output> drawn_plot(const JudgeCommand &c, const Judged &judged) {
  Figure figure = curves_figure(judged.figure);
  figure.remarks = judged.notes;
  return c.plot.drawn(figure, c.output.quiet);
}

int run(const JudgeCommand &c) {
  check(c);
  const Judged judged = c.has_limits() ? by_specification(c)
                        : c.stability  ? by_stability(c)
                                       : by_filter_rule(c);
  const std::unique_ptr<Output> plot = c.plot ? drawn_plot(c, judged) : nullptr;
  Output out(c.output.path());
  out.write(judged.report);
  if (plot)
    plot->commit();
  out.commit();
  c.output.tell_notes_beside_csv(judged.notes);
  return exit_code(outcome_of(judged.verdict));
}

} // namespace

Run add_judge(CLI::App &app) {
  const auto c = std::make_shared<JudgeCommand>();
  CLI::App &command = *app.add_subcommand(
      "judge", "Whether samples keep a specification, are stable, or filter a base, whatever was rounded");
  c->files.add_to(command, "SAMPLE");
  command.add_option("--spec", c->spec, specification_help())->type_name("FILE|NAME");
  command
      .add_option(
          "--limit", c->limits,
          "what the specification asks besides: FM=2.3..3.1, the fineness modulus of ASTM C125, FM-EN that "
          "of EN 12620; retained=..45%, what passes a sieve of it and stays on the next; any number of them")
      ->type_name("NAME=MIN..MAX")
      ->allow_extra_args(false);
  command
      .add_option("--job-mix", c->job_mix,
                  "in the place of a specification: the gradation that the samples are to have")
      ->type_name("MIX");
  command
      .add_option("--within", c->within,
                  "how many points what passes may be from the job mix: 5 at all of its sieves, or "
                  "4.75mm=7,0.075mm=2 at these")
      ->type_name("SIZE=POINTS,...")
      ->allow_extra_args(false);
  command
      .add_option("--stability", c->stability,
                  fmt::format("judge internal stability by a rule: {}", stability_rule_names()))
      ->type_name("RULE");
  command.add_option("--filter-for", c->base, "judge the samples as filters for this base: a gradation")
      ->type_name("BASE");
  command.add_option("--rule", c->rule, fmt::format("the rule for filters: {}", filter_rule_names()))
      ->type_name("RULE");
  command.add_flag("--dispersive", c->dispersive, "the base is a dispersive clay");
  command.add_flag("--no-regrade", c->no_regrade,
                   "take the base with its grains above 4.75 mm, which the rules leave out");
  command.add_option("--rounding", c->rounding, rounding_help())->type_name("UNIT");
  command.add_option("--digits", c->digits, "significant digits (15; in the text form 6)")
      ->type_name("D")
      ->transform(whole_number(1, 1000));
  c->plot.add_to(command, "draw the curves, with the limits");
  c->output.add_format(command);
  c->output.add_out(command);
  c->output.add_quiet(command, "no progress, and no notes beside CSV, on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph(
          "A percent in a report stands for all numbers that round to it. The verdict is pass where every "
          "curve that rounds to the report keeps the limits, fail where none does, and else hangs: then a "
          "curve on either side is shown. At a size where a sample has no sieve, what passes is "
          "interpolated, linear in log size, and decided exactly. Of several samples there is a table with a "
          "column each.") +
          "\n" +
          paragraph("--stability judges one soil: kenney-lau, H/F at all sizes; kezdi, all splits; "
                    "burenkova, d90/d60. "
                    "--filter-for judges retention and permeability, and by all rules but terzaghi fines, "
                    "largest size and "
                    "segregation. Sizes between sieves are linear in percent over log size, and compared "
                    "exactly.") +
          "\n" +
          paragraph(
              "Exit code 0: all samples pass. 1: one fails, or hangs, which is no pass. 3: 1,200 digits do "
              "not tell a percent from its limit, or it is not decided whether one curve keeps all limits "
              "together. --spec NAME has grading limits alone: what else the standard asks is judged where "
              "--limit "
              "says it."),
      {"mdm judge sand.csv --spec astm-c33-fine", "mdm judge a.csv b.csv --spec limits.csv --format csv",
       "mdm judge sand.csv --spec astm-c33-fine --limit FM=2.3..3.1 --limit retained=..45%",
       "mdm judge sand.csv --spec astm-c33-fine --plot sand.svg",
       "mdm judge base.csv --spec superpave-19 --rounding 0.1",
       "mdm judge field.csv --job-mix mix.csv --within 4.75mm=7,0.6mm=4,0.075mm=2",
       "mdm judge fill.csv --stability kenney-lau", "mdm judge sand.csv --filter-for core.csv --rule fema"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
