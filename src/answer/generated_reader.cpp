#include "answer/generated_reader.hpp"

#include "text/json_member.hpp"
#include "text/json_tree.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"
#include "text/source.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

using SetJson = nlohmann::json;

constexpr std::string_view classes_header =
    "class,lower_lo,lower_hi,upper_lo,upper_hi,volume_fraction_lo,volume_fraction_hi,quantity";
constexpr const char *set_remedy = ": give what mdm generate wrote";

[[noreturn]] void refuse_member(const std::string &key) {
  throw InputError(key + " is missing or of another kind" + set_remedy);
}

std::string string_of(const SetJson &value, const std::string &key) {
  if (!value.is_string())
    refuse_member(key);
  return value.get<std::string>();
}

const SetJson &member_of(const SetJson &object, const char *key) {
  if (!object.is_object() || !object.contains(key))
    refuse_member(key);
  return object[key];
}

/// The number `p/q` or the range ["lo", "hi"].
SizeRange range_of(const SetJson &value, const std::string &key) {
  if (value.is_array() && value.size() == 2) {
    SizeRange r{parse_decimal(string_of(value[0], key)), parse_decimal(string_of(value[1], key))};
    if (r.lo < 0 || r.hi < r.lo)
      throw InputError(key + ": the first of two bounds is not above 0 or larger than the second" +
                       set_remedy);
    return r;
  }
  const std::string text = string_of(value, key);
  const std::size_t slash = text.find('/');
  const std::optional<Integer> n = parse_natural(text.substr(0, slash));
  const std::optional<Integer> d =
      slash == std::string::npos ? Integer(1) : parse_natural(text.substr(slash + 1));
  if (!n || !d || *d == 0)
    throw InputError(key + ": " + in_quotes(text) + " is no fraction" + set_remedy);
  return {ratio(*n, *d), ratio(*n, *d)};
}

StatedSet::Class class_of(const SizeRange &lower, const SizeRange &upper, const SizeRange &fraction) {
  return {lower.lo, upper.lo, fraction.lo, !lower.is_point() || !upper.is_point() || !fraction.is_point(),
          std::nullopt};
}

/// Sizes lie in their class: those that begin at its lower bound are above it.
void set_open_ends(StatedSet &set) {
  auto size = set.sizes.begin();
  Integer particles = 0;
  for (const StatedSet::Class &c : set.classes) {
    particles += c.quantity.value_or(0);
    for (Integer left = c.quantity.value_or(0); left > 0 && size != set.sizes.end(); --left, ++size)
      size->is_open = size->lo <= c.lower;
  }
  if (!set.sizes.empty() && particles != set.sizes.size())
    throw InputError(fmt::format("the classes have {} particles, and {} sizes are listed{}",
                                 to_string(particles), set.sizes.size(), set_remedy));
}

StatedSet read_json(std::string_view text) {
  const SetJson json = json_tree(text);
  if (string_of(member_of(json, "schema"), "schema") != "mdm-generate-1")
    refuse_member("schema");
  StatedSet set;
  set.id = string_of(member_of(json, "id"), "id");
  const SetJson &unit = member_of(json, "unit");
  if (!unit.is_null()) {
    const std::string written = string_of(unit, "unit");
    for (const SizeUnit u : {SizeUnit::mm, SizeUnit::um, SizeUnit::m})
      if (written == name(u))
        set.unit = u;
    if (!set.unit)
      refuse_member("unit");
  }
  set.dimension = string_of(member_of(json, "dimension"), "dimension") == "2" ? 2 : 3;
  for (const SetJson &c : member_of(json, "classes")) {
    set.classes.push_back(class_of(range_of(member_of(c, "lower"), "lower"),
                                   range_of(member_of(c, "upper"), "upper"),
                                   range_of(member_of(c, "volume_fraction"), "volume_fraction")));
    const SetJson &quantity = member_of(c, "quantity");
    if (!quantity.is_null())
      set.classes.back().quantity = parse_natural(string_of(quantity, "quantity"));
  }
  if (json.contains("sizes"))
    for (const SetJson &size : json["sizes"])
      set.sizes.push_back(range_of(size, "sizes"));
  set_open_ends(set);
  return set;
}

StatedSet read_csv(std::string_view text, const Source &source, std::string id) {
  Lines lines(text);
  lines.next();
  StatedSet set;
  set.id = std::move(id);
  std::vector<std::string> fields;
  while (lines.next()) {
    if (trimmed(lines.text()).empty())
      continue;
    constexpr std::size_t least = 8;
    if (!split_fields(lines.text(), ',', fields) || fields.size() < least)
      source.refuse(lines.number(), std::string("not a row of a class") + set_remedy);
    try {
      const auto range = [&fields](std::size_t i) {
        return SizeRange{parse_decimal(fields[i]), parse_decimal(fields[i + 1])};
      };
      set.classes.push_back(class_of(range(1), range(3), range(5)));
      set.classes.back().quantity = parse_natural(fields[7]);
    } catch (const InputError &e) {
      source.refuse(lines.number(), e.what());
    }
  }
  return set;
}

} // namespace

bool is_generated(std::string_view text) {
  return text.starts_with(classes_header) || json_schema(text) == "mdm-generate-1";
}

StatedSet read_generated(std::string_view text, const std::string &file) {
  const Source source(file);
  if (text.starts_with(classes_header))
    return read_csv(text, source, stem(file));
  try {
    return read_json(text);
  } catch (const JsonError &e) {
    source.refuse(e.line, e.what());
  } catch (const InputError &e) {
    source.refuse(1, e.what());
  }
}

Gradation set_gradation(const StatedSet &set) {
  if (set.classes.empty())
    throw InputError(std::string("the set has no classes") + set_remedy);
  Gradation::Data data;
  data.id = set.id;
  data.unit = set.unit.value_or(SizeUnit::mm);
  bool is_rounded = false;
  for (const StatedSet::Class &c : set.classes) {
    data.sizes.push_back(c.lower);
    data.masses.push_back(c.volume_fraction);
    is_rounded = is_rounded || c.is_rounded;
  }
  data.sizes.push_back(set.classes.back().upper);
  data.masses.push_back(0);
  data.notes.push_back(
      "a set of mdm generate: its volume fractions were taken as masses" +
      std::string(is_rounded ? ", and what is irrational was rounded as it is printed" : ""));
  if (!set.unit)
    data.notes.emplace_back("the set names no unit: its sizes were taken as mm");
  if (set.dimension == 2)
    data.notes.push_back("the set is one of discs, whose masses go with x^2: " + option("law") +
                         " power:2 where a law counts");
  return Gradation(std::move(data));
}

} // namespace mdm
