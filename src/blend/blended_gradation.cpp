#include "blend/blended_gradation.hpp"

#include "gradation/material_gradation.hpp"
#include "gradation/shown.hpp"
#include "number/common_denominator.hpp"
#include "soil/grading_curve.hpp"

#include <mdm/blend/blend_problem.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
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

void refuse_factors(const Gradation &stockpile) {
  if (stockpile.has_factors())
    throw InputError(
        printable(stockpile.id()) +
        ": it has a column factor, and a class of a blend has no single factor: leave the column "
        "out to blend masses");
}

void check_material_name(const std::string &name) {
  constexpr std::size_t most_bytes = 100;
  if (name.empty() || name.size() > most_bytes)
    throw InputError(in_quotes(name) +
                     " is no name of a material, which has 1 to 100 bytes: rename the file");
}

} // namespace

Gradation blended_materials(const std::vector<Gradation> &stockpiles, const std::vector<Rational> &shares,
                            const std::vector<Rational> &densities, const std::string &id) {
  std::vector<std::size_t> order;
  std::vector<Rational> masses; // of all, so that one multiple makes them decimals
  for (std::size_t i = 0; i < stockpiles.size(); ++i)
    if (shares[i] != 0)
      order.push_back(i);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return stockpiles[a].id() < stockpiles[b].id(); });
  for (const std::size_t i : order) {
    const Gradation &g = stockpiles[i];
    refuse_factors(g);
    check_material_name(g.id());
    const Rational total = std::accumulate(g.masses().begin(), g.masses().end(), Rational(0));
    for (const Rational &mass : g.masses())
      masses.push_back(100 * shares[i] * mass / total);
  }
  masses = as_decimals(std::move(masses));
  std::vector<Material> parts;
  auto next = masses.begin();
  for (const std::size_t i : order) {
    const Gradation &g = stockpiles[i];
    Gradation::Data data;
    for (const Rational &size : g.sizes())
      data.sizes.push_back(size * in_mm(g.unit()));
    data.masses.assign(next, next + static_cast<std::ptrdiff_t>(data.sizes.size()));
    next += static_cast<std::ptrdiff_t>(data.sizes.size());
    data.factors.assign(data.sizes.size(), densities[i]);
    parts.push_back({g.id(), Gradation(std::move(data))});
  }
  return joined(std::move(parts), id);
}

Gradation blended_gradation(const std::vector<Gradation> &stockpiles, const std::vector<Rational> &shares,
                            const std::vector<Rational> &sieves, const std::string &id) {
  for (std::size_t i = 0; i < stockpiles.size(); ++i)
    if (shares[i] != 0)
      refuse_factors(stockpiles[i]);
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
