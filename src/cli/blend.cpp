#include "ask/option_values.hpp"
#include "blend/blend_certificate.hpp"
#include "blend/blended_gradation.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_file.hpp"
#include "files/byte_source.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "gradation/csv_reader.hpp"
#include "report/blend_report.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace mdm::cli {
namespace {

struct BlendCommand {
  using Text = std::optional<std::string>;
  std::vector<std::string> files;
  std::string specification;
  Text target, step, minimise, at_most, all, relax, blended, proof, node_limit, time_limit;
  std::vector<std::string> costs, shares;
  ReadingFlags reading;
  OutputFlags output;
};

/// The parts of a text between commas.
std::vector<std::string> between_commas(const std::vector<std::string> &texts) {
  std::vector<std::string> parts;
  for (const std::string &text : texts)
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t to = std::min(text.find(',', from), text.size());
      parts.emplace_back(trimmed(std::string_view(text).substr(from, to - from)));
      from = to + 1;
    }
  return parts;
}

/// The stockpile of `NAME=VALUE`, and the value.
std::pair<Stockpile *, std::string> of_stockpile(const std::string &option, const std::string &text,
                                                 BlendProblem &p) {
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos)
    throw InputError(option + ": " + in_quotes(text) + " is no value of a stockpile: write NAME=VALUE");
  const std::string name = text.substr(0, sign);
  std::vector<std::string> names;
  for (Stockpile &s : p.stockpiles) {
    if (s.name == name)
      return {&s, text.substr(sign + 1)};
    names.push_back(in_quotes(s.name));
  }
  throw InputError(fmt::format("{}: there is no stockpile {}; there are {}", option, in_quotes(name),
                               fmt::join(names, ", ")));
}

void take_costs(const std::vector<std::string> &texts, BlendProblem &p) {
  if (texts.empty())
    return;
  std::vector<const Stockpile *> known;
  for (const std::string &text : between_commas(texts)) {
    const auto [stockpile, value] = of_stockpile("--cost", text, p);
    if (std::find(known.begin(), known.end(), stockpile) != known.end())
      throw InputError("--cost: " + in_quotes(stockpile->name) + " has two costs: give one");
    known.push_back(stockpile);
    stockpile->cost = not_negative("cost", value);
  }
  for (const Stockpile &s : p.stockpiles)
    if (std::find(known.begin(), known.end(), &s) == known.end())
      throw InputError("--cost: the cost of " + in_quotes(s.name) + " is missing: add " + printable(s.name) +
                       "=COST");
}

/// `10..40%`, `..40%`, `10..` or `25%`.
void take_share(const std::string &text, BlendProblem &p) {
  const auto [stockpile, value] = of_stockpile("--share", text, p);
  const std::size_t dots = value.find("..");
  const std::string from = value.substr(0, dots);
  const std::string to = dots == std::string::npos ? from : value.substr(dots + 2);
  if (from.empty() && (to.empty() || to == "%"))
    throw InputError("--share: " + in_quotes(text) + " limits nothing: write 10..40%, 10.. or ..40%");
  if (!from.empty())
    stockpile->least = std::max(stockpile->least, Rational(percent_of("share", from) / 100));
  if (!to.empty() && to != "%")
    stockpile->most = std::min(stockpile->most, Rational(percent_of("share", to) / 100));
  if (stockpile->least > stockpile->most)
    throw InputError("--share: " + in_quotes(text) +
                     ": no share is from the first to the second number: exchange them");
}

/// A number and the letters behind it: `5kg`.
NamedMass mass_in(const std::string &text) {
  const std::string_view all = trimmed(text);
  const auto letter = std::find_if(all.begin(), all.end(), [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '%';
  });
  const auto digits = static_cast<std::size_t>(letter - all.begin());
  return {positive("step", std::string(trimmed(all.substr(0, digits)))), std::string(all.substr(digits))};
}

/// `1%`, `0.5` or `5kg of 1000kg`. \return the mass of a blend, if there is one
std::optional<NamedMass> take_step(const std::string &text, BlendProblem &p) {
  const std::size_t of = text.find(" of ");
  const NamedMass step = mass_in(text.substr(0, of));
  const NamedMass whole = of == std::string::npos ? NamedMass{100, "%"} : mass_in(text.substr(of + 4));
  const bool is_percent = of == std::string::npos && (step.unit.empty() || step.unit == "%");
  if (!is_percent && (of == std::string::npos || step.unit != whole.unit || step.unit == "%"))
    throw InputError("--step: " + in_quotes(text) + " is no step: write 1%, 0.5% or 5kg of 1000kg");
  const Rational steps = whole.value / step.value;
  if (denominator(steps) != 1 || steps > most_blend_steps)
    throw InputError(
        fmt::format("--step: {}: the whole is {} steps: it is to be a whole number of them, at most {}",
                    in_quotes(text), approximate(steps, 6), most_blend_steps));
  p.steps = numerator(steps).convert_to<std::uint64_t>();
  return is_percent ? std::nullopt : std::optional<NamedMass>(whole);
}

/// What is asked for, or what the options that are given have a use for.
BlendAim aim_of(const BlendCommand &c) {
  if (!c.minimise) {
    if (!c.costs.empty() && c.target)
      throw InputError(
          "--cost and --target are both given: say by --minimise what a blend is to have least of");
    return !c.costs.empty() ? BlendAim::cost : c.target ? BlendAim::deviation : BlendAim::none;
  }
  for (const BlendAim aim : {BlendAim::none, BlendAim::cost, BlendAim::deviation, BlendAim::max_deviation})
    if (*c.minimise == name(aim)) {
      if (aim == BlendAim::cost && c.costs.empty())
        throw InputError("--minimise cost: it needs --cost");
      if ((aim == BlendAim::deviation || aim == BlendAim::max_deviation) && !c.target)
        throw InputError("--minimise " + *c.minimise + ": it needs --target");
      return aim;
    }
  throw InputError("--minimise: " + in_quotes(*c.minimise) +
                   " is none of cost, deviation, max-deviation and none");
}

/// The sieve whose limits alone may be widened.
std::size_t relaxed_sieve(const std::string &text, const BlendProblem &p, SizeUnit unit) {
  const Rational size = length("relax", text).in(unit)*in_mm(unit);
  std::vector<std::string> sizes;
  for (const std::size_t s : limited_sieves(p)) {
    if (p.sieves[s].size == size)
      return s;
    sizes.push_back(to_decimal(p.sieves[s].size));
  }
  throw InputError(fmt::format("--relax: {} is no sieve with limits; there are {} mm", in_quotes(text),
                               fmt::join(sizes, ", ")));
}

BlendOptions search_options(const BlendCommand &c) {
  constexpr unsigned most_blends = 1'000'000;
  BlendOptions o;
  if (c.all)
    o.best = small_natural("all", *c.all, 1, most_blends);
  if (c.node_limit)
    o.node_limit = natural64("node-limit", *c.node_limit);
  if (c.time_limit)
    o.deadline = std::chrono::steady_clock::now() + duration("time-limit", *c.time_limit);
  return o;
}

/// The gradation of the best blend, where it is to be written and there is one.
std::optional<std::string> blended_file(const BlendCommand &c, const std::vector<Gradation> &stockpiles,
                                        const BlendProblem &p, const BlendAnswer &a) {
  if (!c.blended || a.best.empty())
    return std::nullopt;
  std::vector<Rational> sieves;
  for (const BlendSieve &s : p.sieves)
    sieves.push_back(s.size);
  const Gradation g = blended_gradation(stockpiles, a.best.front().shares, sieves, "blend");
  return c.blended->ends_with(".json") ? gradation_json(g) : gradation_csv(g);
}

void write_beside(const std::optional<std::string> &path, const std::optional<std::string> &content) {
  if (!path || !content)
    return;
  Output file(*path);
  file.write(*content);
  file.commit();
}

/// The certificate, where it is to be written and the search came to its end.
std::optional<std::string> proof_of(const BlendCommand &c, const BlendProblem &p, const BlendAnswer &a) {
  using Known = BlendAnswer::Status;
  return c.proof && (a.status == Known::optimal || a.status == Known::none)
             ? std::optional<std::string>(blend_certificate(p, a))
             : std::nullopt;
}

/// The gradation of a stockpile; where there is to be a proof, of a file that mdm-check reads as it is.
Gradation stockpile_in(const std::string &file, const BlendCommand &c) {
  UnderstoodGradation g = any_gradation(file, c.reading, c.output.quiet);
  if (c.proof && (!g.is_canonical || c.reading.is_given()))
    throw InputError("--proof: mdm-check does not read " + shown_name(file) +
                     " as it was read: let mdm convert write it, and give that");
  return std::move(g.gradation);
}

/// The same of the specification.
Envelope specification_in(const BlendCommand &c) {
  const std::string content = read_file(c.specification, max_gradation_bytes);
  Envelope e = read_envelope(content, shown_name(c.specification));
  if (c.proof && (!is_canonical_csv(content) || e.passing_max.back() != 100))
    throw InputError(
        "--proof: mdm-check does not read " + shown_name(c.specification) +
        ": give size_mm,passing_min_percent,passing_max_percent, with a largest sieve that lets 100 "
        "percent pass");
  return e;
}

int exit_of(BlendAnswer::Status status) {
  switch (status) {
  case BlendAnswer::Status::optimal:
    return Exit::done;
  case BlendAnswer::Status::none:
    return Exit::negative;
  default:
    return Exit::limited;
  }
}

void check_files(const BlendCommand &c) {
  std::vector<std::string> paths = c.files;
  paths.push_back(c.specification);
  if (c.target)
    paths.push_back(*c.target);
  if (std::count(paths.begin(), paths.end(), "-") > 1)
    throw InputError("standard input can be one file alone: give the others by name");
  if (c.proof == "-")
    throw InputError("--proof needs a file: standard output has the report");
  if (c.blended == "-")
    throw InputError("--blended needs a file: standard output has the report");
  for (const std::string &path : paths) // the target may be a stockpile
    check_distinct({path, c.output.path(), c.blended.value_or("-"), c.proof.value_or("-")});
}

int run(const BlendCommand &c) {
  check_files(c);
  const BlendAim aim = aim_of(c);
  std::vector<Gradation> stockpiles;
  for (const std::string &file : c.files)
    stockpiles.push_back(stockpile_in(file, c));
  const Envelope specification = specification_in(c);
  std::optional<Gradation> target;
  if (c.target)
    target = any_gradation(*c.target, {}, c.output.quiet).gradation;
  BlendProblem p = blend_problem(stockpiles, specification, target);
  p.aim = aim;
  take_costs(c.costs, p);
  for (const std::string &share : between_commas(c.shares))
    take_share(share, p);
  const std::optional<NamedMass> mass = c.step ? take_step(*c.step, p) : std::nullopt;
  if (c.at_most)
    p.at_most = small_natural("at-most-stockpiles", *c.at_most, 1, 1'000'000);
  BlendOptions o = search_options(c);
  if (c.relax)
    o.relaxed = relaxed_sieve(*c.relax, p, specification.unit);
  Output out(c.output.path());
  const BlendAnswer a = solve_blend(p, o);
  const std::optional<std::string> blended = blended_file(c, stockpiles, p, a);
  const BlendReport r{p, a, specification.id, mass,
                      o.relaxed ? std::optional<Rational>(p.sieves[*o.relaxed].size) : std::nullopt};
  out.write(c.output.report([&] { return blend_text(r); }, [&] { return blend_json(r); },
                            [&] { return blend_csv(r); }));
  c.output.tell_notes_beside_csv(p.notes);
  write_beside(c.blended, blended);
  write_beside(c.proof, proof_of(c, p, a));
  out.commit();
  return exit_of(a.status);
}

void add_question(CLI::App &command, BlendCommand &c) {
  const OptionGroup group(command, "The question");
  command
      .add_option("--spec", c.specification,
                  "the limits: CSV with passing_min_percent,passing_max_percent, or another envelope")
      ->type_name("SPEC")
      ->required();
  command
      .add_option(
          "--minimise", c.minimise,
          "what a blend is to have least of: cost, deviation (the sum of the distances from the target), "
          "max-deviation (the largest of them) or none; without it cost where there is --cost, deviation "
          "where there is --target")
      ->type_name("WHAT");
  command.add_option("--cost", c.costs, "the cost of a unit of mass of each stockpile, as A=12.5,B=9")
      ->type_name("NAME=COST,...");
  command.add_option("--target", c.target, "the curve that is wished for: a gradation")->type_name("CURVE");
  command
      .add_option(
          "--step", c.step,
          "shares are whole numbers of steps: 1% (without this option), 0.5%, or masses as '5kg of 1000kg'")
      ->type_name("STEP");
  command
      .add_option("--share", c.shares, "limits of a stockpile's share: A=10..40%, A=10.., A=..40%, or A=25%")
      ->type_name("NAME=SHARE,...");
  command.add_option("--at-most-stockpiles", c.at_most, "so many stockpiles at most have a share")
      ->type_name("N");
}

void add_answer(CLI::App &command, BlendCommand &c) {
  const OptionGroup group(command, "The answer");
  command.add_option("--all", c.all, "the N best blends")->type_name("N");
  command
      .add_option(
          "--relax", c.relax,
          "where there is no blend, by how much the limits of the sieve SIZE alone must be widened; without "
          "it all limits by the same")
      ->type_name("SIZE");
  command.add_option("--blended", c.blended, "write the gradation of the best blend to OUT (CSV, or .json)")
      ->type_name("OUT");
  command
      .add_option("--proof", c.proof,
                  "write a proof of the best blend, or that there is none, for mdm-check SPEC FILE... OUT")
      ->type_name("OUT");
  command
      .add_option("--node-limit", c.node_limit, "stop after so many splits of the search (1000000; exit 3)")
      ->type_name("N");
  command.add_option("--time-limit", c.time_limit, "stop after so many seconds (exit 3)")->type_name("S");
}

} // namespace

Run add_blend(CLI::App &app) {
  const auto c = std::make_shared<BlendCommand>();
  CLI::App &command =
      *app.add_subcommand("blend", "The best mix of stockpiles within a specification, or why there is none");
  command
      .add_option(
          "FILE", c->files,
          "gradations of the stockpiles, any that mdm convert reads; their names are those of the files")
      ->required();
  add_question(command, *c);
  add_answer(command, *c);
  c->output.add_format(command);
  c->output.add_out(command);
  c->output.add_quiet(command, "no progress and no notes on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph(
          "Shares are of the mass. All numbers are exact: the blend is the best of all in steps, and keeps "
          "every "
          "limit as it is written. Of blends that are equally good that one comes first of which the first "
          "stockpile has the smaller share, then the second, and so on. What passes a sieve that a stockpile "
          "does "
          "not have is interpolated between its sieves, linear in size, with a note; below its finest sieve "
          "it is "
          "not known. A price is what a point more room at a limit saves, near the best real shares.") +
          "\n" +
          paragraph("Exit code 1: there is no blend. The report says which limits contradict each other, and "
                    "by how "
                    "much they must be widened."),
      {"mdm blend sand.csv gravel.csv dust.csv --spec limits.csv",
       "mdm blend A.csv B.csv C.csv --spec limits.csv --cost A=7,B=10.82,C=9.5 --share C=5..30%",
       "mdm blend A.csv B.csv --spec limits.csv --target curve.csv --step '5kg of 1000kg' "
       "--blended m.csv"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
