#include "packing/disc_sizes.hpp"

#include "text/json_member.hpp"
#include "text/json_tree.hpp"
#include "text/lines.hpp"
#include "text/source.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

namespace mdm {
namespace {

/// Digits of a size; 10^18 is below 2^63.
constexpr unsigned most_digits = 18;
constexpr std::string_view csv_begins = "class,size_lo";

/// A positive decimal, as an enclosure of itself.
Enclosure enclosed(const Rational &size) {
  Enclosure e;
  const std::string text = to_decimal(size);
  const std::size_t point = text.find('.');
  e.places = point == std::string::npos ? 0 : static_cast<unsigned>(text.size() - point - 1);
  e.hi = e.lo = floor(Rational(size * Rational(power_of_ten(e.places))));
  return e;
}

/// \throws InputError if that is no fraction
Rational fraction(const std::string &n, const std::string &d) {
  const std::optional<Integer> p = parse_natural(n), q = parse_natural(d);
  if (!p || !q || *q == 0)
    throw InputError("a size of " + in_quotes(n + "/" + d) + ": it is no fraction of whole numbers");
  return ratio(*p, *q);
}

/// `["lo", "hi"]`, or `"p/q"` to the digits that enclosures have.
Enclosure enclosed_json(const nlohmann::json &size) {
  constexpr unsigned digits = 15;
  if (size.is_array())
    return enclosed(parse_decimal(size.at(1).get<std::string>()));
  const std::string text = size.get<std::string>();
  const std::size_t slash = text.find('/');
  const Rational r = slash == std::string::npos ? parse_decimal(text)
                                                : fraction(text.substr(0, slash), text.substr(slash + 1));
  if (r <= 0)
    throw InputError("a size of " + in_quotes(text) + ": sizes must be above 0");
  return enclose_root(numerator(r), denominator(r), 1, digits);
}

/// The unit that a header class,size_lo,size_hi names, empty where it names none; nothing of another line.
std::optional<std::string> unit_of_header(std::string_view line) {
  for (const std::string unit : {"", "mm", "um", "m", "in"}) {
    const std::string ending = unit.empty() ? "" : "_" + unit;
    if (line == "class,size_lo" + ending + ",size_hi" + ending)
      return unit;
  }
  return std::nullopt;
}

/// Rows of class, size_lo and size_hi.
DiscSizes sizes_of_csv(std::string_view csv, std::string_view file) {
  const Source source(file);
  source.check_text(csv, csv.size());
  DiscSizes sizes;
  Lines lines(csv);
  std::vector<std::string> fields;
  lines.next();
  const std::optional<std::string> unit = unit_of_header(lines.text());
  if (!unit)
    source.refuse(1, "more columns than class,size_lo,size_hi: write the sizes with mdm generate --sizes");
  sizes.unit = *unit;
  while (lines.next()) {
    if (trimmed(lines.text()).empty())
      continue;
    if (!split_fields(lines.text(), ',', fields) || fields.size() != 3)
      source.refuse(lines.number(), "not three fields: write class,size_lo,size_hi");
    try {
      const Rational low = parse_decimal(fields[1]), high = parse_decimal(fields[2]);
      if (low <= 0 || high < low)
        throw InputError("sizes must be above 0, and size_lo at most size_hi");
      sizes.add(enclosed(high));
    } catch (const InputError &e) {
      source.refuse(lines.number(), e.what());
    }
  }
  if (sizes.sizes.empty())
    source.refuse(lines.number(), "no size in the file: give at least one row");
  return sizes;
}

/// The sizes of `mdm-generate-1`: each an enclosure, or a fraction.
DiscSizes sizes_of_json(std::string_view json, std::string_view file) {
  const std::string name = printable(file);
  DiscSizes sizes;
  try {
    const nlohmann::json set = json_tree(json);
    if (!set.is_object() || set.value("schema", "") != "mdm-generate-1" || !set.contains("sizes") ||
        !set["sizes"].is_array())
      throw InputError("no sizes of a set: write it with mdm generate --sizes --format json");
    if (set.value("dimension", "") != "2")
      throw InputError("the set is one of spheres: write it with mdm generate --dimension 2");
    if (set.contains("unit") && !set["unit"].is_null())
      sizes.unit = set["unit"].get<std::string>();
    for (const nlohmann::json &size : set["sizes"])
      sizes.add(enclosed_json(size));
  } catch (const nlohmann::json::exception &) {
    throw InputError(name + ": a field is not what mdm-generate-1 says: write it with mdm generate");
  } catch (const InputError &e) {
    throw InputError(name + ": " + e.what());
  }
  if (sizes.sizes.empty())
    throw InputError(name + ": no size in the file: give at least one");
  return sizes;
}

} // namespace

void DiscSizes::add(const Enclosure &diameter, std::uint64_t count) {
  Integer digits = diameter.hi;
  unsigned places = diameter.places;
  while (places > 0 && digits >= power_of_ten(most_digits)) {
    digits = ceil_div(digits, 10);
    --places;
  }
  if (digits <= 0 || digits >= power_of_ten(most_digits))
    throw InputError("a disc of size " + in_quotes(diameter.upper_text()) +
                     ": sizes are above 0 and below 10^18: take another unit");
  if (count > most_discs - sizes.size())
    throw InputError("more than 10^7 discs: ask for fewer");
  sizes.insert(sizes.end(), count, {static_cast<std::uint64_t>(digits), places});
}

std::int64_t DiscSizes::radius(const DiscSize &diameter, unsigned places) {
  const Integer digits(diameter.digits);
  const Integer r = places >= diameter.places ? ceil_div(digits * power_of_ten(places - diameter.places), 2)
                                              : ceil_div(digits, 2 * power_of_ten(diameter.places - places));
  if (r >= Integer(1) << 52)
    throw InputError("a disc of 2^52 units of the lattice: the sizes are not those of the packing");
  return static_cast<std::int64_t>(r);
}

bool has_disc_sizes(std::string_view text) {
  return text.starts_with(csv_begins) || json_schema(text) == "mdm-generate-1";
}

DiscSizes read_disc_sizes(std::string_view text, std::string_view file) {
  return text.starts_with(csv_begins) ? sizes_of_csv(text, file) : sizes_of_json(text, file);
}

} // namespace mdm
