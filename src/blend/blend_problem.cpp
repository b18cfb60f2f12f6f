// The problem of a blend from gradations and a specification (Theorem 22). What comes in are files of
// stockpiles and limits at sieves; what goes out is what passes each sieve of each stockpile, as fractions.
// A sieve that a stockpile does not have is interpolated, linear in size, so that it is rational; below its
// finest sieve nothing is known, and a limit there is refused.

#include "gradation/shown.hpp"
#include "soil/fineness_modulus.hpp"
#include "soil/grading_curve.hpp"

#include <mdm/blend/blend_problem.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace mdm {
namespace {

std::string blend_size_text(const Rational &size) {
  return shown(size) + " mm";
}

[[noreturn]] void refuse_unknown_passing(const Gradation &g, const Rational &size) {
  throw InputError(
      fmt::format("{}: what passes {} is not known, since it lies below its finest sieve: add that "
                  "sieve to the file, or leave out the limits that need it",
                  printable(g.id()), blend_size_text(size)));
}

/// What passes a gradation, and the sizes at which it is interpolated, for one note.
class Interpolations {
public:
  explicit Interpolations(const Gradation &g) : g_(g) {}

  /// \throws InputError where it is not known
  Rational passing(const Rational &size) {
    const std::optional<PassingAt> at = passing_at(g_, size);
    if (!at)
      refuse_unknown_passing(g_, size);
    if (at->interpolated && known_.insert(size).second)
      sizes_ += (sizes_.empty() ? "" : ", ") + shown(size);
    return at->percent;
  }
  void add_note(std::vector<std::string> &notes) const {
    if (!sizes_.empty())
      notes.push_back(fmt::format("{}: what passes {} mm is interpolated between its sieves, linear in size",
                                  printable(g_.id()), sizes_));
  }

private:
  const Gradation &g_;
  std::set<Rational> known_;
  std::string sizes_;
};

void add_notes_of(const Gradation &g, std::vector<std::string> &notes) {
  for (const std::string &note : g.notes())
    notes.push_back(printable(g.id()) + ": " + note);
}

bool limits_something(const BlendSieve &sieve) {
  return sieve.least > 0 || sieve.most < 100;
}

bool is_known_everywhere(const std::vector<Gradation> &stockpiles, const Rational &size) {
  return std::all_of(stockpiles.begin(), stockpiles.end(),
                     [&size](const Gradation &g) { return passing_at(g, size).has_value(); });
}

/// The sieves above the pan at which a blend can be judged, ascending.
std::vector<BlendSieve> judged_sieves(const std::vector<Gradation> &stockpiles, const Envelope &e,
                                      std::vector<std::string> &notes) {
  std::vector<BlendSieve> sieves;
  for (std::size_t i = 0; i < e.sizes.size(); ++i) {
    BlendSieve sieve{e.sizes[i] * in_mm(e.unit), e.passing_min[i], e.passing_max[i], std::nullopt};
    if (sieve.size == 0)
      continue;
    if (sieve.least > sieve.most)
      throw InputError(
          fmt::format("{}: no blend has at least {} % and at most {} % passing {}: correct one of them",
                      printable(e.id), shown(sieve.least), shown(sieve.most), blend_size_text(sieve.size)));
    if (limits_something(sieve) || is_known_everywhere(stockpiles, sieve.size))
      sieves.push_back(std::move(sieve));
    else
      notes.push_back(
          fmt::format("{} is left out: it has no limits, and not all stockpiles tell what passes it",
                      blend_size_text(sieve.size)));
  }
  return sieves;
}

/// Says at which of its sieves the target is not counted, if there are any.
void note_uncounted(const Gradation &target, const std::vector<BlendSieve> &sieves,
                    std::vector<std::string> &notes) {
  std::vector<std::string> uncounted;
  const GradingCurve curve(target);
  for (const Rational &size : curve.sizes())
    if (size > 0 &&
        std::none_of(sieves.begin(), sieves.end(), [&size](const BlendSieve &s) { return s.size == size; }))
      uncounted.push_back(shown(size));
  if (!uncounted.empty())
    notes.push_back(
        fmt::format("the target {} is counted at the sieves of the specification alone: not at {} mm",
                    printable(target.id()), fmt::join(uncounted, ", ")));
}

/// The mean percent that passes the sieves of a modulus.
Rational mean_passing(FinenessModulus modulus, Interpolations &interpolations) {
  Rational sum = 0;
  for (const Rational &size : fineness_sieves(modulus))
    sum += interpolations.passing(size);
  return sum / fineness_sieves(modulus).size();
}

void add_moduli(std::vector<ModulusLimits> moduli, std::vector<BlendSieve> &sieves) {
  std::set<FinenessModulus> known;
  std::stable_sort(moduli.begin(), moduli.end(),
                   [](const ModulusLimits &a, const ModulusLimits &b) { return a.modulus < b.modulus; });
  for (const ModulusLimits &m : moduli) {
    const Rational largest = Rational(fineness_sieves(m.modulus).size());
    if (!known.insert(m.modulus).second)
      throw InputError(fmt::format("{} is limited twice: give its limits once", name(m.modulus)));
    if (m.least.value_or(0) > largest || m.most.value_or(0) < 0)
      throw InputError(
          fmt::format("{} is from 0 to {}: no blend keeps these limits", name(m.modulus), shown(largest)));
    // The more passes, the less is the modulus.
    BlendSieve sieve{0, 0, 100, std::nullopt, m.modulus};
    if (m.most)
      sieve.least = std::max<Rational>(0, mean_of_modulus(m.modulus, *m.most));
    if (m.least)
      sieve.most = std::min<Rational>(100, mean_of_modulus(m.modulus, *m.least));
    if (limits_something(sieve))
      sieves.push_back(std::move(sieve));
  }
}

/// `FM at most 3.1, which is at least 790/11 % passing on the mean of its sieves`.
std::string modulus_in_words(const BlendSieve &sieve, bool is_upper) {
  const Rational mean = is_upper ? sieve.most : sieve.least;
  return fmt::format("{} at {} {}, which is at {} {} % passing on the mean of its sieves",
                     name(*sieve.modulus), is_upper ? "least" : "most",
                     shown(modulus_of_mean(*sieve.modulus, mean)), is_upper ? "most" : "least",
                     to_string(mean));
}

/// `coarseness factor at most 75, which is at least 25 % passing 9.5 mm less 0.75 times what passes 2.36 mm`.
std::string coarseness_in_words(const BlendSieve &sieve, bool is_upper) {
  return fmt::format(
      "coarseness factor at {} {}, which is at {} {} % passing 9.5 mm less {} times what passes "
      "2.36 mm",
      is_upper ? "least" : "most", shown(*sieve.coarseness), is_upper ? "most" : "least",
      shown(is_upper ? sieve.most : sieve.least), shown(Rational(*sieve.coarseness / 100)));
}

} // namespace

Rational modulus_of_mean(FinenessModulus modulus, const Rational &mean) {
  return Rational(fineness_sieves(modulus).size()) * (1 - mean / 100);
}

Rational mean_of_modulus(FinenessModulus modulus, const Rational &value) {
  return 100 * (1 - value / Rational(fineness_sieves(modulus).size()));
}

std::string_view name(BlendAim aim) {
  switch (aim) {
  case BlendAim::none:
    return "none";
  case BlendAim::cost:
    return "cost";
  case BlendAim::deviation:
    return "deviation";
  case BlendAim::max_deviation:
    return "max-deviation";
  case BlendAim::squares:
    return "squares";
  default:
    return "widening";
  }
}

bool aims_at_target(BlendAim aim) {
  return aim == BlendAim::deviation || aim == BlendAim::max_deviation || aim == BlendAim::squares;
}

std::optional<BlendAim> blend_aim_named(std::string_view text) {
  for (const BlendAim aim :
       {BlendAim::none, BlendAim::cost, BlendAim::deviation, BlendAim::max_deviation, BlendAim::squares})
    if (text == name(aim))
      return aim;
  return std::nullopt;
}

Rational value_of(const BlendLimit &limit, const BlendProblem &problem) {
  switch (limit.kind) {
  case BlendLimit::Kind::passing:
    return limit.is_upper ? problem.sieves[limit.index].most : problem.sieves[limit.index].least;
  case BlendLimit::Kind::target:
    return problem.sieves[limit.index].target.value();
  case BlendLimit::Kind::share:
    return limit.is_upper ? problem.stockpiles[limit.index].most : problem.stockpiles[limit.index].least;
  default:
    return 1;
  }
}

std::string in_words(const BlendLimit &limit, const BlendProblem &problem) {
  if (limit.kind == BlendLimit::Kind::sum)
    return "shares that sum to 100 %";
  const bool is_share = limit.kind == BlendLimit::Kind::share;
  if (!is_share && problem.sieves[limit.index].modulus)
    return modulus_in_words(problem.sieves[limit.index], limit.is_upper);
  if (!is_share && problem.sieves[limit.index].coarseness)
    return coarseness_in_words(problem.sieves[limit.index], limit.is_upper);
  const Rational percent = is_share ? Rational(100 * value_of(limit, problem)) : value_of(limit, problem);
  return fmt::format("{} {} % {}", limit.is_upper ? "at most" : "at least", shown(percent),
                     is_share ? "of " + printable(problem.stockpiles[limit.index].name)
                              : "passing " + blend_size_text(problem.sieves[limit.index].size));
}

std::optional<PassingAt> passing_at(const Gradation &g, const Rational &size) {
  const GradingCurve curve(g);
  const std::vector<Rational> &sizes = curve.sizes(), &shares = curve.shares();
  const auto i = static_cast<std::size_t>(std::lower_bound(sizes.begin(), sizes.end(), size) - sizes.begin());
  if (i == sizes.size())
    return PassingAt{100};
  if (sizes[i] == size)
    return PassingAt{100 * shares[i]};
  if (i == 0)
    return PassingAt{0};
  if (shares[i - 1] == shares[i])
    return PassingAt{100 * shares[i]};
  if (sizes[i - 1] == 0)
    return std::nullopt;
  const Rational position = (size - sizes[i - 1]) / (sizes[i] - sizes[i - 1]);
  return PassingAt{100 * (shares[i - 1] + position * curve.mass(i - 1)), true};
}

BlendProblem blend_problem(const std::vector<Gradation> &stockpiles, const Envelope &specification,
                           const std::optional<Gradation> &target, const std::vector<ModulusLimits> &moduli,
                           const std::optional<CoarsenessLimits> &coarseness) {
  BlendProblem problem;
  problem.sieves = judged_sieves(stockpiles, specification, problem.notes);
  if (!problem.sieves.empty())
    add_moduli(moduli, problem.sieves);
  if (problem.sieves.empty())
    throw InputError(printable(specification.id) +
                     ": no sieve of this specification limits anything: give one with a limit above 0 or "
                     "below 100");
  problem.notes.insert(problem.notes.begin(), specification.notes.begin(), specification.notes.end());
  std::set<std::string> names;
  for (const Gradation &g : stockpiles) {
    if (!names.insert(g.id()).second)
      throw InputError(fmt::format(
          "two stockpiles have the name {}: give their files, or the ids in them, different names",
          in_quotes(g.id())));
    add_notes_of(g, problem.notes);
    Stockpile stockpile;
    stockpile.name = g.id();
    Interpolations interpolations(g);
    for (const BlendSieve &sieve : problem.sieves)
      stockpile.passing.push_back(sieve.modulus ? mean_passing(*sieve.modulus, interpolations)
                                                : interpolations.passing(sieve.size));
    if (coarseness)
      stockpile.coarse =
          CoarsePassing{interpolations.passing(ratio(95, 10)), interpolations.passing(ratio(236, 100))};
    interpolations.add_note(problem.notes);
    problem.stockpiles.push_back(std::move(stockpile));
  }
  if (target) {
    add_notes_of(*target, problem.notes);
    note_uncounted(*target, problem.sieves, problem.notes);
    Interpolations interpolations(*target);
    for (BlendSieve &sieve : problem.sieves)
      if (!sieve.modulus)
        sieve.target = interpolations.passing(sieve.size);
    interpolations.add_note(problem.notes);
  }
  if (coarseness)
    limit_coarseness(problem, *coarseness);
  return problem;
}

void limit_coarseness(BlendProblem &problem, const CoarsenessLimits &limits) {
  const auto add = [&problem](const Rational &c, const Rational &least, const Rational &most) {
    problem.sieves.push_back({0, least, most, std::nullopt, std::nullopt, c});
    for (Stockpile &s : problem.stockpiles)
      s.passing.push_back(s.coarse->at_9_5_mm - c / 100 * s.coarse->at_2_36_mm);
  };
  // 100 (100 - a) >= c (100 - b), with a and b that pass 9.5 and 2.36 mm, is a - c / 100 b <= 100 - c.
  if (limits.least == 0 && limits.most == 100)
    return;
  if (limits.least > 0)
    add(limits.least, -100, 100 - limits.least);
  if (limits.most < 100)
    add(limits.most, 100 - limits.most, 100);
  problem.coarseness = limits;
}

std::optional<Rational> coarseness_factor(const BlendProblem &problem, const std::vector<Rational> &shares) {
  Rational coarse = 0, all = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    coarse += shares[i] * (100 - problem.stockpiles[i].coarse->at_9_5_mm);
    all += shares[i] * (100 - problem.stockpiles[i].coarse->at_2_36_mm);
  }
  return all == 0 ? std::nullopt : std::optional<Rational>(100 * coarse / all);
}

std::vector<std::size_t> limited_sieves(const BlendProblem &problem) {
  std::vector<std::size_t> limited;
  for (std::size_t s = 0; s < problem.sieves.size(); ++s)
    if (problem.sieves[s].is_sieve() && limits_something(problem.sieves[s]))
      limited.push_back(s);
  return limited;
}

std::vector<BlendLimit> limits_of(const BlendProblem &problem) {
  std::vector<BlendLimit> limits;
  for (std::size_t s = problem.sieves.size(); s-- > 0;) {
    if (problem.sieves[s].least > 0)
      limits.push_back({BlendLimit::Kind::passing, s, false});
    if (problem.sieves[s].most < 100)
      limits.push_back({BlendLimit::Kind::passing, s, true});
  }
  for (std::size_t i = 0; i < problem.stockpiles.size(); ++i) {
    if (problem.stockpiles[i].least > 0)
      limits.push_back({BlendLimit::Kind::share, i, false});
    if (problem.stockpiles[i].most < 1)
      limits.push_back({BlendLimit::Kind::share, i, true});
  }
  return limits;
}

} // namespace mdm
