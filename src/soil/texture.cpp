#include "soil/texture.hpp"

#include <algorithm>
#include <array>

namespace mdm {
namespace {

/// a >= factor b. \throws NotAvailable where no precision tells
bool is_at_least(const Real &a, const Rational &factor, const Real &b) {
  const Order order = compare(a, Real(factor) * b);
  if (order == Order::undecided)
    throw NotAvailable{"1,200 digits do not tell a share from a limit", true};
  return order != Order::less;
}

/// TextureShares of the mass.
struct TextureShares {
  Real coarser, sand, silt, clay;
};

/// The shares of sand up to 2 mm, and of silt and clay up to these sizes in mm.
/// \throws NotAvailable where the curve does not tell, or nothing is as fine as sand
TextureShares shares_of(const GradingCurve &curve, const Rational &silt, const Rational &clay) {
  std::array<Real, 3> passing = {Real(0), Real(0), Real(0)};
  const std::array<Rational, 3> sizes = {2, silt, clay};
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const Available<Real> share = curve.passing(sizes[i]);
    if (!share)
      throw share.why();
    passing[i] = *share;
  }
  if (passing[0].exact() == Rational(0))
    throw NotAvailable{"nothing passes 2 mm"};
  return {Real(1) - passing[0], passing[0] - passing[1], passing[1] - passing[2], passing[2]};
}

/// What decide() says, or why it says nothing.
template <class Decide>
Available<std::string> decided(Decide decide) {
  try {
    return std::string(decide());
  } catch (const NotAvailable &why) {
    return why;
  }
}

const char *folk_name(const Real &gravel, const Real &sand, const Real &mud) {
  const Real one(1);
  if (is_at_least(gravel, ratio(80, 100), one))
    return "gravel";
  const int sandiness = is_at_least(sand, 9, mud)             ? 3
                        : is_at_least(sand, 1, mud)           ? 2
                        : is_at_least(Real(9) * sand, 1, mud) ? 1
                                                              : 0;
  const bool slightly = is_at_least(gravel, ratio(1, 10000), one);
  if (is_at_least(gravel, ratio(30, 100), one))
    return sandiness == 3 ? "sandy gravel" : sandiness == 2 ? "muddy sandy gravel" : "muddy gravel";
  if (is_at_least(gravel, ratio(5, 100), one))
    return sandiness == 3 ? "gravelly sand" : sandiness == 2 ? "gravelly muddy sand" : "gravelly mud";
  static constexpr std::array<const char *, 4> names = {"mud", "sandy mud", "muddy sand", "sand"};
  static constexpr std::array<const char *, 4> with_gravel = {
      "slightly gravelly mud", "slightly gravelly sandy mud", "slightly gravelly muddy sand",
      "slightly gravelly sand"};
  return (slightly ? with_gravel : names).at(static_cast<std::size_t>(sandiness));
}

const char *shepard_name(const TextureShares &s) {
  const std::array<const Real *, 3> parts = {&s.sand, &s.silt, &s.clay};
  const Real all = Real(1) - s.coarser;
  static constexpr std::array<const char *, 3> nouns = {"sand", "silt", "clay"};
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (is_at_least(*parts[i], ratio(75, 100), all))
      return nouns[i];
  if (std::all_of(parts.begin(), parts.end(),
                  [&](const Real *part) { return is_at_least(*part, ratio(20, 100), all); }))
    return "sand-silt-clay";
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return !is_at_least(*parts[j], 1, *parts[i]); });
  static constexpr std::array<std::array<const char *, 3>, 3> names = {
      {{"sand", "silty sand", "clayey sand"},
       {"sandy silt", "silt", "clayey silt"},
       {"sandy clay", "silty clay", "clay"}}};
  return names.at(order[0]).at(order[1]);
}

const char *usda_name(const TextureShares &s) {
  const auto &[coarser, sand, silt, clay] = s;
  const Real all = Real(1) - coarser;
  const auto at_least = [&all](const Real &part, unsigned percent) {
    return is_at_least(part, ratio(percent, 100), all);
  };
  const auto above = [&all](const Real &part, unsigned percent) {
    return !is_at_least(Real(ratio(percent, 100)) * all, 1, part);
  };
  if (!at_least(silt + Real(ratio(3, 2)) * clay, 15))
    return "sand";
  if (!at_least(silt + Real(2) * clay, 30))
    return "loamy sand";
  if (at_least(clay, 40))
    return above(sand, 45) ? "sandy clay" : at_least(silt, 40) ? "silty clay" : "clay";
  if (at_least(clay, 35) && above(sand, 45))
    return "sandy clay";
  if (at_least(clay, 27))
    return above(sand, 45) ? "sandy clay loam" : above(sand, 20) ? "clay loam" : "silty clay loam";
  if (at_least(clay, 20) && !at_least(silt, 28) && above(sand, 45))
    return "sandy clay loam";
  if (at_least(silt, 80) && !at_least(clay, 12))
    return "silt";
  if (at_least(silt, 50))
    return "silt loam";
  if (at_least(clay, 7) && at_least(silt, 28) && !above(sand, 52))
    return "loam";
  return "sandy loam";
}

} // namespace

Available<std::string> folk_texture(const GradingCurve &curve) {
  return decided([&] {
    const Available<Real> to_gravel = curve.passing(2), to_sand = curve.passing(ratio(1, 16));
    if (!to_gravel || !to_sand)
      throw(to_gravel ? to_sand : to_gravel).why();
    return folk_name(Real(1) - *to_gravel, *to_gravel - *to_sand, *to_sand);
  });
}

Available<std::string> shepard_texture(const GradingCurve &curve) {
  return decided([&] { return shepard_name(shares_of(curve, ratio(1, 16), ratio(1, 256))); });
}

Available<std::string> usda_texture(const GradingCurve &curve) {
  return decided([&] { return usda_name(shares_of(curve, ratio(5, 100), ratio(2, 1000))); });
}

} // namespace mdm
