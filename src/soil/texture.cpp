#include "soil/texture.hpp"

#include "soil/share_limits.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace mdm {
namespace {

/// Parts of the mass, and their sum.
struct Parts {
  Real whole;
  std::array<Real, 3> each; ///< in the system's order
};

/// \throws NotAvailable where the curve does not tell, or nothing is as fine as sand
Parts parts_of(TextureSystem system, const GradingCurve &curve) {
  if (system == TextureSystem::folk) {
    const std::vector<Real> passing = shares_passing(curve, {2, ratio(1, 16)});
    return {1, {passing[1], passing[0] - passing[1], Real(1) - passing[0]}};
  }
  const bool is_shepard = system == TextureSystem::shepard;
  const Rational silt = is_shepard ? ratio(1, 16) : ratio(5, 100),
                 clay = is_shepard ? ratio(1, 256) : ratio(2, 1000);
  const std::vector<Real> passing = shares_passing(curve, {2, silt, clay});
  if (passing[0].exact() == Rational(0))
    throw NotAvailable{"nothing passes 2 mm"};
  return {passing[0], {passing[0] - passing[1], passing[1] - passing[2], passing[2]}};
}

const char *folk_name(const Parts &p) {
  const auto &[mud, sand, gravel] = p.each;
  const Real &one = p.whole;
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

const char *shepard_name(const Parts &p) {
  const auto &[all, parts] = p;
  static constexpr std::array<const char *, 3> nouns = {"sand", "silt", "clay"};
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (is_at_least(parts[i], ratio(75, 100), all))
      return nouns[i];
  if (std::all_of(parts.begin(), parts.end(),
                  [&p](const Real &part) { return is_at_least(part, ratio(20, 100), p.whole); }))
    return "sand-silt-clay";
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&p](std::size_t i, std::size_t j) { return !is_at_least(p.each[j], 1, p.each[i]); });
  static constexpr std::array<std::array<const char *, 3>, 3> names = {
      {{"sand", "silty sand", "clayey sand"},
       {"sandy silt", "silt", "clayey silt"},
       {"sandy clay", "silty clay", "clay"}}};
  return names.at(order[0]).at(order[1]);
}

const char *usda_name(const Parts &p) {
  const Real &all = p.whole;
  const auto &[sand, silt, clay] = p.each;
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

const char *name_of(TextureSystem system, const Parts &parts) {
  switch (system) {
  case TextureSystem::folk:
    return folk_name(parts);
  case TextureSystem::shepard:
    return shepard_name(parts);
  case TextureSystem::usda:
    break;
  }
  return usda_name(parts);
}

} // namespace

Available<std::array<Real, 3>> texture_parts(TextureSystem system, const GradingCurve &curve) {
  try {
    const auto &[whole, parts] = parts_of(system, curve);
    return std::array<Real, 3>{parts[0] / whole, parts[1] / whole, parts[2] / whole};
  } catch (const NotAvailable &why) {
    return why;
  }
}

Available<std::string> texture(TextureSystem system, const GradingCurve &curve) {
  try {
    return std::string(name_of(system, parts_of(system, curve)));
  } catch (const NotAvailable &why) {
    return why;
  }
}

} // namespace mdm
