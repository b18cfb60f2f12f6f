#include "answer/answer_sample.hpp"

#include "gradation/shown.hpp"
#include "number/common_denominator.hpp"
#include "particles/particle_format.hpp"
#include "text/option_name.hpp"

#include <mdm/number/interval.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// The factor of the class of g between the two bounds.
Rational factor(const Gradation &g, const std::string &material, const RootSize &lower,
                const RootSize &upper) {
  if (!g.has_factors())
    return 1;
  for (std::size_t j = 0; j < g.classes(); ++j)
    if (g.is_class(j) && g.material(j) == material && compare(g.opening(j), lower) == 0 &&
        compare(g.opening(j + 1), upper) == 0)
      return g.factor(j);
  throw InputError(fmt::format("the answer's class ({}, {}] is none of the gradation, whose classes have "
                               "factors: give the gradation that was solved",
                               shown(lower), shown(upper)));
}

/// Sign of the mass of particles of these sizes less that of as many with f(x)^p = `powered` each, where p is
/// a multiple of b: enclosed more and more closely, and where they are equal decided by fractions (Theorem 16
/// (f)).
int compare_masses(const std::vector<Rational> &sizes, const MassLaw &law, const Rational &powered,
                   unsigned p) {
  const auto are_equal = [&] {
    std::vector<Rational> ratios;
    for (const Rational &x : sizes) {
      const std::optional<Rational> r = exact_root(Rational(power(law.powered(x), p / law.b) / powered), p);
      if (!r)
        return false;
      ratios.push_back(*r);
    }
    return sum(ratios) == sizes.size();
  };
  constexpr unsigned first_bits = 128;
  for (unsigned bits = first_bits;; bits *= 2) {
    std::vector<Rational> least;
    std::size_t rounded = 0; // down, by 2^-bits at most
    for (const Rational &x : sizes) {
      const Interval mass = root(law.powered(x), law.b, bits);
      least.push_back(mass.lo);
      if (!mass.is_point())
        ++rounded;
    }
    const Rational lo = sum(least), hi = lo + ratio(rounded, Integer(1) << bits);
    const Interval one = root(powered, p, bits);
    if (lo > one.hi * sizes.size())
      return 1;
    if (hi < one.lo * sizes.size())
      return -1;
    if (bits == first_bits && are_equal())
      return 0;
  }
}

/// The mistake in a class's spread; nothing if its sizes are one a particle, in the class, and around its
/// mass (Theorem 16 (e)). \param powered f(x)^p of a particle if all had one size
std::string spread_objection(const AnswerSample::Class &c, const MassLaw &law, const Rational &powered,
                             unsigned p) {
  if (c.quantity != c.sizes.size())
    return fmt::format("{} sizes are listed for its {} particles", c.sizes.size(), to_string(c.quantity));
  std::vector<Rational> low, high;
  bool at_lower = false; // the openings below are open: a size is more than a lower bound at them
  for (const auto &[lo, hi] : c.sizes) {
    const int above_lower = compare(RootSize{lo}, c.lower);
    if (above_lower < 0 || (above_lower == 0 && lo == hi) || compare(RootSize{hi}, c.upper) > 0)
      return "a size is not in it";
    at_lower = at_lower || above_lower == 0;
    low.push_back(lo);
    high.push_back(hi);
  }
  const int least = compare_masses(low, law, powered, p);
  if (least > 0 || (least == 0 && at_lower) || compare_masses(high, law, powered, p) < 0)
    return "its sizes do not have its mass together";
  return "";
}

/// \throws InputError if g has an opening inside a class of the answer that is spread
void check_classes(const Gradation &g, const RootSize &lower, const RootSize &upper) {
  for (std::size_t j = 0; j <= g.classes(); ++j)
    if (compare(lower, g.opening(j)) < 0 && compare(g.opening(j), upper) < 0)
      throw InputError(
          fmt::format("the answer is a spread over ({}, {}], and the gradation has a sieve of {} "
                      "there: give the gradation that was solved",
                      shown(lower), shown(upper), shown(g.opening(j))));
}

/// The size in a unit that is 1 / factor of its own.
RootSize in_unit(const RootSize &x, const Rational &factor) {
  return {x.power * power(factor, x.degree), x.degree};
}

} // namespace

void check_power(const AnswerSample &answer, const MassLaw &law) {
  if (answer.scale_power % law.b != 0 || answer.scale_power / law.b != answer.size_power)
    throw InputError(fmt::format("the answer was made with a law x^(a/{}), not x^({}): say which with {}",
                                 answer.scale_power / answer.size_power,
                                 law.is_power() ? law.exponent() : "a/1", option("law")));
}

AnswerDescription describe_answer(const AnswerSample &answer, Gradation g, const MassLaw &law,
                                  const Rational &snap) {
  const unsigned p = answer.scale_power;
  check_power(answer, law);
  const unsigned degree = law.a * (p / law.b);
  const Rational unit = in_mm(answer.unit) / in_mm(g.unit());
  const Rational scale = answer.scale * power(unit, degree); // with sizes in the unit of g
  AnswerDescription result{Description(std::move(g), {law, snap, scale, p}), {}, {}, {}};
  Integer particles = 0;
  const bool is_power = law.is_power();
  std::vector<std::size_t> wrong; // classes whose size is not in its enclosure
  for (const AnswerSample::Class &c : answer.classes) {
    const RootSize lower = in_unit(c.lower, unit), upper = in_unit(c.upper, unit);
    const Rational mass =
        c.mass / (factor(result.description.gradation(), c.material, lower, upper) * c.quantity);
    particles += c.quantity;
    if (!is_power) {
      const Rational one = answer.scale * mass, lo = c.size_lo * unit; // f(x)
      if (!c.sizes.empty())
        throw InputError("the answer is a spread, which is one under a law that is a power: leave out " +
                         option("law"));
      if (one < law.powered(lo) || one > law.powered(Rational(c.size_hi * unit)))
        wrong.push_back(c.number);
      result.description.add_of_mass(one, lo, c.quantity);
      result.particles.emplace_back(RootSize{lo}, c.quantity);
      continue;
    }
    const RootSize size{scale * power(mass, p), degree}; // x^(a d)
    if (compare(size, RootSize{c.size_lo * unit}) < 0 || compare(size, RootSize{c.size_hi * unit}) > 0)
      wrong.push_back(c.number);
    if (!c.sizes.empty()) {
      check_classes(result.description.gradation(), lower, upper);
      const std::string objection = spread_objection(c, law, Rational(size.power / power(unit, degree)), p);
      if (!objection.empty())
        result.objections.push_back(fmt::format("class {} of the answer: {}", c.number, objection));
    }
    if (result.description.gradation().materials().empty())
      result.description.add(size, c.quantity);
    else
      result.description.add_of(c.material, size, c.quantity);
    result.particles.emplace_back(size, c.quantity);
  }
  if (!wrong.empty())
    result.objections.push_back(
        fmt::format("scale, mass and quantity do not give the size in class {}{} of the answer with the law "
                    "{}",
                    wrong.front(), wrong.size() > 1 ? fmt::format(" and {} more", wrong.size() - 1) : "",
                    law.formula(result.description.gradation().unit())));
  result.is_spread = std::any_of(answer.classes.begin(), answer.classes.end(),
                                 [](const auto &c) { return !c.sizes.empty(); });
  if (result.is_spread)
    result.notes.emplace_back("The answer is a spread: the particles of a class are judged by their mass "
                              "together, and condition 3 is that of particles of one size with this mass.");
  if (particles != answer.particles)
    result.notes.push_back(fmt::format("The answer says that it has {} particles; its classes have {}.",
                                       to_string(answer.particles), to_string(particles)));
  return result;
}

} // namespace mdm
