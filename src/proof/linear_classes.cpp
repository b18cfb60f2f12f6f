#include "proof/linear_classes.hpp"

#include "number/common_denominator.hpp"

#include <mdm/text/error.hpp>

namespace mdm {
namespace {

/// (n / unit)^(1/p).
Rational root_of(const Integer &n, const Integer &unit, const Problem &problem, std::string_view form) {
  if (const std::optional<Rational> root = exact_root(ratio(n, unit), problem.scale_power()))
    return *root;
  throw InputError(std::string(form) + ": the mass law x^(" + problem.law().exponent() +
                   ") is irrational at a sieve, and this form has rational numbers only" +
                   (problem.root() > 1 ? ": " + std::string(convert_remedy) : ""));
}

} // namespace

std::vector<LinearClass> linear_classes(const Problem &problem, std::string_view form) {
  // In units of the first upper mass: only ratios count, and need be rational.
  const Integer &unit = problem.classes().front().F;
  std::vector<Rational> ends;
  for (const ProblemClass &c : problem.classes())
    for (const Integer *end : {&c.f, &c.F})
      ends.push_back(root_of(*end, unit, problem, form));
  const std::vector<Integer> cleared = CommonDenominator(ends).numerators;
  std::vector<LinearClass> classes;
  for (std::size_t j = 0; j < problem.classes().size(); ++j) {
    const ProblemClass &c = problem.classes()[j];
    classes.push_back(
        {c.index, cleared[2 * j], cleared[2 * j + 1], floor_root(c.mass, problem.scale_power()), c.floor});
  }
  return classes;
}

} // namespace mdm
