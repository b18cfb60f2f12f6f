#include "ask/blend.hpp"

#include "ask/option_values.hpp"
#include "blend/blend_vipr.hpp"
#include "blend/blended_gradation.hpp"
#include "gradation/shown.hpp"
#include "judge/further_limits.hpp"
#include "text/lines.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

namespace mdm {
namespace {

/// The stockpile of `NAME=VALUE`, and the value.
std::pair<std::size_t, std::string> of_stockpile(const char *of, const std::string &text,
                                                 const BlendProblem &p) {
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos)
    throw InputError(option(of) + ": " + in_quotes(text) + " is no value of a stockpile: write NAME=VALUE");
  const std::string name = text.substr(0, sign);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < p.stockpiles.size(); ++i) {
    if (p.stockpiles[i].name == name)
      return {i, text.substr(sign + 1)};
    names.push_back(in_quotes(p.stockpiles[i].name));
  }
  throw InputError(fmt::format("{}: there is no stockpile {}; there are {}", option(of), in_quotes(name),
                               fmt::join(names, ", ")));
}

/// All parts between the commas of texts, without the spaces around them.
std::vector<std::string> parts_of(const std::vector<std::string> &texts) {
  std::vector<std::string> parts;
  for (const std::string &text : texts)
    for (const std::string &part : between_commas(text))
      parts.emplace_back(trimmed(part));
  return parts;
}

/// The values of `NAME=VALUE,...`, one a stockpile.
std::vector<Rational> values_of(const char *of, const std::vector<std::string> &texts, const BlendProblem &p,
                                Rational (*number)(const std::string &, const std::string &)) {
  std::vector<std::optional<Rational>> known(p.stockpiles.size());
  for (const std::string &text : parts_of(texts)) {
    const auto [i, value] = of_stockpile(of, text, p);
    if (known[i])
      throw InputError(
          fmt::format("{}: {} has two values: give one", option(of), in_quotes(p.stockpiles[i].name)));
    known[i] = number(of, value);
  }
  std::vector<Rational> values;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const std::string &name = p.stockpiles[i].name;
    if (!known[i])
      throw InputError(fmt::format("{}: the {} of {} is missing: add {}=VALUE", option(of), of,
                                   in_quotes(name), printable(name)));
    values.push_back(*known[i]);
  }
  return values;
}

void take_costs(const std::vector<std::string> &texts, BlendProblem &p) {
  if (texts.empty())
    return;
  const std::vector<Rational> costs = values_of("cost", texts, p, not_negative);
  for (std::size_t i = 0; i < costs.size(); ++i)
    p.stockpiles[i].cost = costs[i];
}

/// `10..40%`, `..40%`, `10..` or `25%`.
void take_share(const std::string &text, BlendProblem &p) {
  const auto [i, value] = of_stockpile("share", text, p);
  Stockpile &stockpile = p.stockpiles[i];
  const std::size_t dots = value.find("..");
  const std::string from = value.substr(0, dots);
  const std::string to = dots == std::string::npos ? from : value.substr(dots + 2);
  if (from.empty() && (to.empty() || to == "%"))
    throw InputError(option("share") + ": " + in_quotes(text) +
                     " limits nothing: write 10..40%, 10.. or ..40%");
  if (!from.empty())
    stockpile.least = std::max(stockpile.least, Rational(percent_of("share", from) / 100));
  if (!to.empty() && to != "%")
    stockpile.most = std::min(stockpile.most, Rational(percent_of("share", to) / 100));
  if (stockpile.least > stockpile.most)
    throw InputError(
        fmt::format("{}: {}: no share of {} is from {} to {} %: give its limits once, the lesser first",
                    option("share"), in_quotes(text), printable(stockpile.name), shown(100 * stockpile.least),
                    shown(100 * stockpile.most)));
}

/// Where an exponent, as `e-1`, ends that begins at `at`; there is none: `at`.
std::size_t end_of_exponent(std::string_view all, std::size_t at) {
  constexpr std::string_view digits = "0123456789";
  if (all.substr(at, 1) != "e" && all.substr(at, 1) != "E")
    return at;
  const std::size_t sign = all.find_first_of("+-", at) == at + 1 ? 1 : 0;
  const std::size_t first = at + 1 + sign;
  return all.find_first_of(digits, first) == first
             ? std::min(all.find_first_not_of(digits, first), all.size())
             : at;
}

/// A number and the letters behind it: `5kg`.
NamedMass mass_in(const std::string &text) {
  const std::string_view all = trimmed(text);
  const auto letter = std::find_if(all.begin(), all.end(), [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '%';
  });
  const std::size_t digits = end_of_exponent(all, static_cast<std::size_t>(letter - all.begin()));
  return {positive("step", std::string(trimmed(all.substr(0, digits)))),
          std::string(trimmed(all.substr(digits)))};
}

/// `1%`, `0.5` or `5kg of 1000kg`. \return the mass of a blend, if there is one
std::optional<NamedMass> take_step(const std::string &text, BlendProblem &p) {
  const std::size_t of = text.find(" of ");
  const NamedMass step = mass_in(text.substr(0, of));
  const NamedMass whole = of == std::string::npos ? NamedMass{100, "%"} : mass_in(text.substr(of + 4));
  const bool is_percent = of == std::string::npos && (step.unit.empty() || step.unit == "%");
  if (!is_percent && (of == std::string::npos || step.unit != whole.unit || step.unit == "%"))
    throw InputError(option("step") + ": " + in_quotes(text) +
                     " is no step: write 1%, 0.5% or 5kg of 1000kg");
  const Rational steps = whole.value / step.value;
  if (denominator(steps) != 1 || steps > most_blend_steps)
    throw InputError(
        fmt::format("{}: {}: the whole is {} steps: it is to be a whole number of them, at most {}",
                    option("step"), in_quotes(text), approximate(steps, 6), most_blend_steps));
  p.steps = numerator(steps).convert_to<std::uint64_t>();
  return is_percent ? std::nullopt : std::optional<NamedMass>(whole);
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
  throw InputError(fmt::format("{}: {} is no sieve with limits; there are {} mm", option("relax"),
                               in_quotes(text), fmt::join(sizes, ", ")));
}

BaileySieves bailey_of(const std::string &text) {
  const Rational size = length("bailey", text).in(SizeUnit::mm);
  std::vector<std::string> sizes;
  for (const BaileySieves &sieves : bailey_sieves()) {
    if (sieves.nominal == size)
      return sieves;
    sizes.push_back(to_decimal(sieves.nominal));
  }
  throw InputError(fmt::format("{}: {} is no nominal maximum size of the method; there are {} mm",
                               option("bailey"), in_quotes(text), fmt::join(sizes, ", ")));
}

/// What --limit asks of a blend.
struct LimitsOfBlend {
  std::vector<ModulusLimits> moduli;
  std::optional<CoarsenessLimits> coarseness;
};

CoarsenessLimits coarseness_of(const NamedLimits &limits, const std::string &text) {
  const CoarsenessLimits coarseness{limits.least.value_or(0), limits.most.value_or(100)};
  if (coarseness.least > 100 || coarseness.most < 0)
    throw InputError(option("limit") + ": " + in_quotes(text) +
                     ": CF is from 0 to 100: no blend keeps these limits");
  return {std::max(coarseness.least, Rational(0)), std::min(coarseness.most, Rational(100))};
}

LimitsOfBlend limits_of(const std::vector<std::string> &texts) {
  constexpr const char *forms = "FM=2.3..3.1, FM-EN=2.4..3.0 or CF=45..75";
  LimitsOfBlend all;
  for (const std::string &text : texts) {
    const NamedLimits limits = parse_named_limits(text, forms);
    if (const std::optional<FinenessModulus> modulus = fineness_modulus_named(limits.name)) {
      all.moduli.push_back({*modulus, limits.least, limits.most});
      continue;
    }
    if (limits.name != "CF")
      throw InputError(
          option("limit") + ": " + in_quotes(text) +
          (limits.name == "retained" ? " is for mdm judge: a blend takes " : " is no limit: write ") + forms);
    if (all.coarseness)
      throw InputError("CF is limited twice: give its limits once");
    all.coarseness = coarseness_of(limits, text);
  }
  return all;
}

BlendProblem problem_of(const BlendTexts &asked, const std::vector<Gradation> &stockpiles,
                        const Envelope &specification, const std::optional<Gradation> &target) {
  const LimitsOfBlend limits = limits_of(asked.limits);
  return blend_problem(stockpiles, specification, target, limits.moduli, limits.coarseness);
}

/// True if the best blend is known, and a limit came before others that were asked for.
bool is_cut(const BlendAnswer &answer, const BlendOptions &options) {
  return answer.status == BlendAnswer::Status::optimal && !answer.is_all && answer.best.size() < options.best;
}

} // namespace

const std::vector<OptionRow<BlendTexts>> BlendTexts::question_options = {
    {"minimise", "WHAT", OptionKind::text,
     "what a blend is to have least of: cost, deviation (the sum of the distances from the target), "
     "max-deviation (the largest of them), squares (the sum of their squares) or none; without it cost where "
     "there is --cost, deviation "
     "where there is --target",
     &BlendTexts::minimise},
    {"cost", "NAME=COST,...", OptionKind::texts,
     "the cost of a unit of mass of each stockpile, as A=12.5,B=9", &BlendTexts::costs},
    {"target", "CURVE", OptionKind::file,
     "the curve that is wished for, at the sieves of the specification: a gradation, or power45:19mm, "
     "fuller:31.5mm, "
     "andreasen:16mm,q=0.25,dmin=0.063mm or bolomey:31.5mm,a=10, whose lengths are the largest size and the "
     "smallest (0 where dmin is left out)",
     &BlendTexts::target},
    {"step", "STEP", OptionKind::text,
     "shares are whole numbers of steps: 1% (without this option), 0.5%, or masses as '5kg of 1000kg'",
     &BlendTexts::step},
    {"share", "NAME=SHARE,...", OptionKind::texts,
     "limits of a stockpile's share: A=10..40%, A=10.., A=..40%, or A=25%", &BlendTexts::shares},
    {"limit", "NAME=MIN..MAX", OptionKind::texts,
     "limits of the blend's fineness modulus, FM=2.3..3.1 of ASTM C125 or FM-EN=2.4..3.0 of EN 12620, or of "
     "its coarseness factor, CF=45..75: of what stays on 2.36 mm the percent that stays on 9.5 mm; either "
     "end "
     "may be left out",
     &BlendTexts::limits},
    {"at-most-stockpiles", "N", OptionKind::number, "so many stockpiles at most have a share",
     &BlendTexts::at_most}};

const std::vector<OptionRow<BlendTexts>> BlendTexts::answer_options = {
    {"all", "N", OptionKind::number, "the N best blends", &BlendTexts::all},
    {"relax", "SIZE", OptionKind::number,
     "where there is no blend, by how much the limits of the sieve SIZE alone must be widened; without "
     "it all limits by the same",
     &BlendTexts::relax},
    {"bailey", "SIZE", OptionKind::text,
     "report the ratios of the Bailey method, CA, FAc and FAf, for this nominal maximum particle size: "
     "37.5mm, "
     "25mm, 19mm, 12.5mm, 9.5mm or 4.75mm",
     &BlendTexts::bailey}};

const std::vector<OptionRow<BlendTexts>> BlendTexts::limit_options = {
    {"node-limit", "N", OptionKind::number,
     "stop after so many splits of the search, 1000000 without it (exit 3)", &BlendTexts::node_limit},
    {"time-limit", "S", OptionKind::seconds, "stop after so many seconds (exit 3)", &BlendTexts::time_limit}};

BlendAim BlendTexts::aim() const {
  if (!minimise) {
    if (!costs.empty() && target)
      throw InputError(option("cost") + " and " + option("target") + " are both given: say by " +
                       option("minimise") + " what a blend is to have least of");
    return !costs.empty() ? BlendAim::cost : target ? BlendAim::deviation : BlendAim::none;
  }
  const std::optional<BlendAim> aim = blend_aim_named(*minimise);
  if (!aim)
    throw InputError(option("minimise") + ": " + in_quotes(*minimise) +
                     " is none of cost, deviation, max-deviation, squares and none");
  if (aim == BlendAim::cost && costs.empty())
    throw InputError(option("minimise") + " cost: it needs " + option("cost"));
  if (aims_at_target(*aim) && !target)
    throw InputError(option("minimise") + " " + *minimise + ": it needs " + option("target"));
  return *aim;
}

BlendOptions BlendTexts::search() const {
  constexpr unsigned most_blends = 1'000'000;
  BlendOptions o;
  if (all)
    o.best = small_natural("all", *all, 1, most_blends);
  if (node_limit)
    o.node_limit = natural64("node-limit", *node_limit);
  if (time_limit)
    o.deadline = std::chrono::steady_clock::now() + duration("time-limit", *time_limit);
  return o;
}

Blending::Blending(const BlendTexts &asked, std::vector<Gradation> stockpiles, const Envelope &specification,
                   const std::optional<Gradation> &target)
    : stockpiles_(std::move(stockpiles)), specification_(specification.id),
      problem_(problem_of(asked, stockpiles_, specification, target)) {
  problem_.aim = asked.aim();
  take_costs(asked.costs, problem_);
  for (const std::string &share : parts_of(asked.shares))
    take_share(share, problem_);
  if (asked.step)
    mass_ = take_step(*asked.step, problem_);
  if (asked.at_most)
    problem_.at_most = small_natural("at-most-stockpiles", *asked.at_most, 1, 1'000'000);
  options_ = asked.search();
  if (asked.bailey)
    bailey_ = bailey_of(*asked.bailey);
  if (asked.relax)
    options_.relaxed = relaxed_sieve(*asked.relax, problem_, specification.unit);
}

BlendReport Blending::report() const {
  BlendReport report{problem_, answer_, specification_, mass_};
  if (options_.relaxed)
    report.relaxed = problem_.sieves[*options_.relaxed].size;
  report.bailey = bailey();
  return report;
}

std::optional<BaileyReport> Blending::bailey() const {
  if (!bailey_ || answer_.best.empty())
    return std::nullopt;
  BaileyReport report{*bailey_, {}};
  const std::array<Rational, 4> sieves = {bailey_->half, bailey_->primary, bailey_->secondary,
                                          bailey_->tertiary};
  for (std::size_t i = 0; i < stockpiles_.size(); ++i) {
    const Rational &share = answer_.best.front().shares[i];
    for (std::size_t s = 0; s < sieves.size() && share != 0; ++s) {
      const std::optional<PassingAt> at = passing_at(stockpiles_[i], sieves[s]);
      if (!at)
        throw InputError(
            fmt::format("{}: {} does not tell what passes {} mm, which lies below its finest sieve",
                        option("bailey"), printable(stockpiles_[i].id()), to_decimal(sieves[s])));
      report.passing[s] += share * at->percent;
      report.is_interpolated = report.is_interpolated || at->interpolated;
    }
  }
  return report;
}

std::optional<Gradation> Blending::blended() const {
  if (answer_.best.empty())
    return std::nullopt;
  std::vector<Rational> sieves;
  for (const BlendSieve &s : problem_.sieves)
    if (s.is_sieve())
      sieves.push_back(s.size);
  return blended_gradation(stockpiles_, answer_.best.front().shares, sieves, "blend");
}

std::optional<Gradation> Blending::blended_with(const std::vector<std::string> &texts) const {
  const std::vector<Rational> densities = values_of("density", texts, problem_, positive);
  if (answer_.best.empty())
    return std::nullopt;
  return blended_materials(stockpiles_, answer_.best.front().shares, densities, "blend");
}

BlendAnswer find_blends(BlendProblem &problem, const BlendOptions &options) {
  BlendAnswer answer = solve_blend(problem, options);
  if (is_cut(answer, options))
    problem.notes.push_back(
        fmt::format("the search ended after the {} best of the {} blends that were asked for",
                    answer.best.size(), options.best));
  return answer;
}

Outcome outcome_of(const BlendAnswer &answer, const BlendOptions &options) {
  return is_cut(answer, options) ? Outcome::limited : outcome_of(answer);
}

void Blending::search(std::function<bool()> go_on) {
  options_.go_on = std::move(go_on);
  answer_ = find_blends(problem_, options_);
}

std::optional<std::string> Blending::proof() const {
  return has_ended() ? std::optional<std::string>(blend_certificate(problem_, answer_)) : std::nullopt;
}

std::optional<std::string> Blending::vipr() const {
  return has_ended() ? std::optional<std::string>(blend_vipr(problem_, answer_)) : std::nullopt;
}

} // namespace mdm
