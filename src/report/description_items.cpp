#include "report/description_items.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

DescriptionItem item(std::string key, std::string name, const char *unit, const std::optional<Real> &value) {
  return {std::move(key), std::move(name), unit,
          value ? std::optional(RealRange{*value, *value}) : std::nullopt};
}

DescriptionItem item(std::string key, std::string name, const char *unit, const Available<Real> &value) {
  return item(std::move(key), std::move(name), unit, value ? std::optional(*value) : std::nullopt);
}

DescriptionItem item(std::string key, std::string name, const char *unit,
                     const Available<PowerProduct> &value) {
  return item(std::move(key), std::move(name), unit, value ? std::optional(value->real()) : std::nullopt);
}

DescriptionItem item(std::string key, std::string name, const char *unit, const Available<RealRange> &value) {
  return {std::move(key), std::move(name), unit, value ? std::optional(*value) : std::nullopt, true};
}

std::optional<Real> over_d50(const SoilDescription &d) {
  return d.d50 ? std::optional((d.d_max / *d.d50).real()) : std::nullopt;
}

/// A decimal of so many significant digits below y > 0, or above it.
std::string outward(const Real &y, unsigned digits, bool upwards) {
  const Enclosure e = enclose(y, digits);
  const Rational end = upwards ? e.upper() : e.lower();
  Rational unit = 1; // of the last digit
  for (const Rational most(power_of_ten(digits)); end / unit >= most;)
    unit *= 10;
  for (const Rational least(power_of_ten(digits - 1)); end / unit < least;)
    unit /= 10;
  const Rational units = end / unit;
  return to_decimal(Rational(upwards ? ceil(units) : floor(units)) * unit);
}

enum class Diameters { usual, all };

std::vector<DescriptionItem> items(const SoilDescription &d, Diameters which) {
  std::vector<DescriptionItem> all = {item("D10", "D10", "mm", d.d10), item("D30", "D30", "mm", d.d30),
                                      item("D50", "D50", "mm", d.d50), item("D60", "D60", "mm", d.d60)};
  if (which == Diameters::all)
    for (const DiameterAt &at : d.diameters)
      all.push_back(item_of(at));
  all.push_back(item("Cu", "C_u", "", d.c_u));
  all.push_back(item("Cc", "C_c", "", d.c_c));
  all.push_back(item("span", "span", "", d.span));
  all.push_back(item("D32", "D[3,2]", "mm", d.surface_mean));
  all.push_back(item("D43", "D[4,3]", "mm", d.volume_mean));
  all.push_back(item("FM", "FM", "", d.fineness_modulus));
  all.push_back(item("FM_EN", "FM EN", "", d.en_fineness_modulus));
  all.push_back(item("kHazen", "k_H", "m/s", d.hazen));
  if (d.kozeny_carman)
    all.push_back(item("kKozenyCarman", "k_KC", "m/s", *d.kozeny_carman));
  all.push_back(item("IGS", "I_GS", "", d.i_gs));
  all.push_back(item("IC", "I_C", "", d.i_c));
  all.push_back(item("phi1", "phi_1", "", std::optional(Real(d.phi_1))));
  all.push_back(item("zeta1", "zeta_1", "", std::optional(d.zeta_1.real())));
  all.push_back(item("dmax", "", "mm", std::optional(d.d_max.real())));
  all.push_back(item("dmaxD50", "", "", over_d50(d)));
  return all;
}

} // namespace

std::vector<DescriptionItem> usual_items(const SoilDescription &d) {
  return items(d, Diameters::usual);
}

std::vector<DescriptionItem> items_of(const SoilDescription &d) {
  return items(d, Diameters::all);
}

DescriptionItem item_of(const DiameterAt &at) {
  const std::string name = "D" + to_decimal(at.percent);
  return item(name, name, "mm", at.size);
}

std::optional<std::pair<std::string, std::string>> bounds_of(const DescriptionItem &i, unsigned digits) {
  if (!i.value)
    return std::nullopt;
  const Enclosure lower = enclose(i.value->lo, digits);
  const Enclosure upper = i.is_range ? enclose(i.value->hi, digits) : lower;
  return std::pair(lower.lower_text(), upper.upper_text());
}

std::string shown_item(const DescriptionItem &i, unsigned digits) {
  if (!i.value)
    return "";
  if (!i.is_range)
    return rounded(i.value->lo, digits);
  return outward(i.value->lo, digits, false) + " to " + outward(i.value->hi, digits, true);
}

std::string group_index(const SoilDescription &d) {
  return d.aashto && d.aashto->index ? to_string(*d.aashto->index) : "";
}

std::string aashto_symbol(const SoilDescription &d) {
  if (!d.aashto)
    return "";
  return d.aashto->index ? fmt::format("{} ({})", d.aashto->symbol, group_index(d)) : d.aashto->symbol;
}

} // namespace mdm
