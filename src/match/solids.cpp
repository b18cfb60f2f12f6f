#include "gradation/length.hpp"
#include "number/pi.hpp"
#include "number/typed_number.hpp"

#include <mdm/match/solids.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <vector>

namespace mdm {
namespace {

std::vector<Rational> lengths(std::string_view text, SizeUnit unit) {
  std::vector<Rational> values;
  for (const Length &length : parse_lengths(text))
    values.push_back(length.in(unit));
  return values;
}

} // namespace

Solids parse_specimen(std::string_view shape, std::string_view void_ratio, SizeUnit unit) {
  const Rational e = parse_typed_decimal(void_ratio);
  if (e < 0)
    throw InputError("the void ratio " + in_quotes(void_ratio) + " is negative");
  const std::size_t colon = shape.find(':');
  const std::string_view kind = shape.substr(0, colon);
  if (colon != std::string_view::npos && (kind == "cylinder" || kind == "box")) {
    const std::vector<Rational> l = lengths(shape.substr(colon + 1), unit);
    if (kind == "cylinder" && l.size() == 2)
      return Cylinder{l[0], l[1], e};
    if (kind == "box" && l.size() == 3)
      return Box{l[0], l[1], l[2], e};
  }
  throw InputError(
      "specimen " + in_quotes(shape) +
      " is neither cylinder:DxH nor box:AxBxC, such as cylinder:50x24.4 or cylinder:50mmx24.4mm");
}

std::optional<Rational> narrowest(const Solids &solids) {
  if (const Cylinder *c = std::get_if<Cylinder>(&solids))
    return std::min(c->diameter, c->height);
  if (const Box *b = std::get_if<Box>(&solids))
    return std::min({b->a, b->b, b->c});
  return std::nullopt;
}

Interval start_scale(const Solids &solids, const Rational &weight, unsigned pi_places) {
  if (const Cylinder *c = std::get_if<Cylinder>(&solids)) {
    const Rational s = 3 * c->diameter * c->diameter * c->height / (2 * (1 + c->void_ratio) * weight);
    return {s, s};
  }
  Rational volume;
  if (const Box *box = std::get_if<Box>(&solids))
    volume = box->a * box->b * box->c / (1 + box->void_ratio);
  else
    volume = std::get<SolidsVolume>(solids).volume;
  const Enclosure pi = enclose_pi(pi_places);
  const Rational six_v = 6 * volume / weight;
  return {six_v / pi.upper(), six_v / pi.lower()};
}

} // namespace mdm
