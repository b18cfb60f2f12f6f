#include "soil/fractions.hpp"

#include <mdm/number/decimal.hpp>

#include <algorithm>
#include <array>
#include <set>

namespace mdm {
namespace {

/// A band of a classification: above < x <= up_to in mm, or no end.
struct Band {
  const char *name;
  bool main;
  const char *above;
  const char *up_to;
};

constexpr std::array<Band, 10> uscs_bands = {{{"boulders", true, "300", nullptr},
                                              {"cobbles", true, "75", "300"},
                                              {"gravel", true, "4.75", "75"},
                                              {"coarse gravel", false, "19", "75"},
                                              {"fine gravel", false, "4.75", "19"},
                                              {"sand", true, "0.075", "4.75"},
                                              {"coarse sand", false, "2", "4.75"},
                                              {"medium sand", false, "0.425", "2"},
                                              {"fine sand", false, "0.075", "0.425"},
                                              {"fines", true, "0", "0.075"}}};

constexpr std::array<Band, 16> iso_14688_bands = {{{"large boulders", true, "630", nullptr},
                                                   {"boulders", true, "200", "630"},
                                                   {"cobbles", true, "63", "200"},
                                                   {"gravel", true, "2", "63"},
                                                   {"coarse gravel", false, "20", "63"},
                                                   {"medium gravel", false, "6.3", "20"},
                                                   {"fine gravel", false, "2", "6.3"},
                                                   {"sand", true, "0.063", "2"},
                                                   {"coarse sand", false, "0.63", "2"},
                                                   {"medium sand", false, "0.2", "0.63"},
                                                   {"fine sand", false, "0.063", "0.2"},
                                                   {"silt", true, "0.002", "0.063"},
                                                   {"coarse silt", false, "0.02", "0.063"},
                                                   {"medium silt", false, "0.0063", "0.02"},
                                                   {"fine silt", false, "0.002", "0.0063"},
                                                   {"clay", true, "0", "0.002"}}};

constexpr std::array<Band, 14> wentworth_bands = {{{"gravel", true, "2", nullptr},
                                                   {"boulders", false, "256", nullptr},
                                                   {"cobbles", false, "64", "256"},
                                                   {"pebbles", false, "4", "64"},
                                                   {"granules", false, "2", "4"},
                                                   {"sand", true, "0.0625", "2"},
                                                   {"very coarse sand", false, "1", "2"},
                                                   {"coarse sand", false, "0.5", "1"},
                                                   {"medium sand", false, "0.25", "0.5"},
                                                   {"fine sand", false, "0.125", "0.25"},
                                                   {"very fine sand", false, "0.0625", "0.125"},
                                                   {"mud", true, "0", "0.0625"},
                                                   {"silt", false, "0.00390625", "0.0625"},
                                                   {"clay", false, "0", "0.00390625"}}};

template <class Bands>
std::vector<Fraction> fractions(const GradingCurve &curve, const Bands &bands) {
  std::vector<Fraction> result;
  for (const Band &band : bands) {
    const Rational above = parse_decimal(band.above);
    const std::optional<Rational> up_to =
        band.up_to == nullptr ? std::nullopt : std::optional(parse_decimal(band.up_to));
    result.push_back({band.name, band.main, above, up_to, share_between(curve, above, up_to)});
  }
  return result;
}

} // namespace

Available<Real> share_between(const GradingCurve &curve, const Rational &above,
                              const std::optional<Rational> &up_to) {
  const Available<Real> finer = curve.passing(above);
  const Available<Real> passed = up_to ? curve.passing(*up_to) : Real(1);
  if (!passed)
    return passed.why();
  return finer ? Available<Real>(*passed - *finer) : finer.why();
}

std::vector<Fraction> uscs_fractions(const GradingCurve &curve) {
  return fractions(curve, uscs_bands);
}

std::vector<Fraction> iso_14688_fractions(const GradingCurve &curve) {
  return fractions(curve, iso_14688_bands);
}

std::vector<Fraction> wentworth_fractions(const GradingCurve &curve) {
  return fractions(curve, wentworth_bands);
}

std::vector<Rational> interpolated_bounds(const GradingCurve &curve, const std::vector<Fraction> &fractions) {
  std::set<Rational, std::greater<>> bounds;
  for (const Fraction &f : fractions)
    for (const std::optional<Rational> &bound : {std::optional(f.above), f.up_to})
      if (bound && curve.interpolates(*bound) && curve.passing(*bound))
        bounds.insert(*bound);
  return {bounds.begin(), bounds.end()};
}

} // namespace mdm
