#include "blend/blended_gradation.hpp"

#include "gradation/shown.hpp"
#include "number/common_denominator.hpp"
#include "soil/grading_curve.hpp"

#include <mdm/blend/blend_problem.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace mdm {
namespace {

/// What passes a size of the blend; nothing where a stockpile does not tell.
std::optional<PassingAt> blended_passing(const std::vector<Gradation> &stockpiles,
                                         const std::vector<Rational> &shares, const Rational &size) {
  PassingAt blended{0};
  for (std::size_t i = 0; i < stockpiles.size(); ++i) {
    if (shares[i] == 0)
      continue;
    const std::optional<PassingAt> at = passing_at(stockpiles[i], size);
    if (!at)
      return std::nullopt;
    blended.percent += shares[i] * at->percent;
    blended.interpolated = blended.interpolated || at->interpolated;
  }
  return blended;
}

/// Sieves of the blend.
struct BlendedSieves {
  std::vector<Rational> sizes; ///< ascending, with the pan where something passes the finest one
  std::set<Rational>
      interpolated; ///< sieves of a stockpile at which another is interpolated: they are left out
};

BlendedSieves blended_sieves(const std::vector<Gradation> &stockpiles, const std::vector<Rational> &shares,
                             const std::vector<Rational> &asked) {
  std::set<Rational> sizes(asked.begin(), asked.end()), interpolated;
  for (std::size_t i = 0; i < stockpiles.size(); ++i) {
    if (shares[i] == 0)
      continue;
    const GradingCurve curve(stockpiles[i]);
    for (const Rational &size : curve.sizes()) {
      const std::optional<PassingAt> at = blended_passing(stockpiles, shares, size);
      if (at && !at->interpolated)
        sizes.insert(size);
      else if (size > 0 && sizes.count(size) == 0)
        interpolated.insert(size);
    }
  }
  sizes.erase(Rational(0));
  if (blended_passing(stockpiles, shares, *sizes.begin())->percent > 0)
    sizes.insert(Rational(0));
  return {{sizes.begin(), sizes.end()}, std::move(interpolated)};
}

std::string left_out_note(const std::set<Rational> &sieves) {
  std::vector<std::string> texts;
  for (const Rational &size : sieves)
    texts.push_back(shown(size));
  return fmt::format(
      "Left out of the blend's gradation are sieves at which a stockpile is interpolated, or not known: "
      "{} mm.",
      fmt::join(texts, ", "));
}

/// Where a mass is no decimal, whole multiples of all.
std::vector<Rational> as_decimals(std::vector<Rational> masses) {
  if (std::all_of(masses.begin(), masses.end(),
                  [](const Rational &m) { return exact_decimal(m).has_value(); }))
    return masses;
  const CommonDenominator cleared(masses);
  return {cleared.numerators.begin(), cleared.numerators.end()};
}

} // namespace

Gradation blended_gradation(const std::vector<Gradation> &stockpiles, const std::vector<Rational> &shares,
                            const std::vector<Rational> &sieves, const std::string &id) {
  for (std::size_t i = 0; i < stockpiles.size(); ++i)
    if (shares[i] != 0 && stockpiles[i].has_factors())
      throw InputError(
          printable(stockpiles[i].id()) +
          ": it has a column factor, and a class of a blend has no single factor: leave the column "
          "out to blend masses");
  Gradation::Data data;
  data.id = id;
  BlendedSieves all = blended_sieves(stockpiles, shares, sieves);
  data.sizes = std::move(all.sizes);
  if (!all.interpolated.empty())
    data.notes.push_back(left_out_note(all.interpolated));
  std::vector<Rational> retained;
  Rational passed = 100;
  for (std::size_t i = data.sizes.size(); i-- > 0;) {
    const Rational passing = blended_passing(stockpiles, shares, data.sizes[i])->percent;
    retained.push_back(passed - passing);
    passed = passing;
  }
  std::reverse(retained.begin(), retained.end());
  data.masses = as_decimals(std::move(retained));
  return Gradation(std::move(data));
}

} // namespace mdm
