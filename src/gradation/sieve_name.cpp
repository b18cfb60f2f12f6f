#include "gradation/sieve_name.hpp"

#include "text/lines.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

struct Sieve {
  std::string_view name;
  unsigned opening; ///< micrometres
};

// ASTM E11 and the Tyler series; the tables of proofs/certificate-format.md, section 5.
constexpr std::array<Sieve, 23> astm_inches = {
    {{"5", 125000},    {"4.24", 106000}, {"4", 100000},  {"3-1/2", 90000}, {"3", 75000},
     {"2-1/2", 63000}, {"2.12", 53000},  {"2", 50000},   {"1-3/4", 45000}, {"1-1/2", 37500},
     {"1-1/4", 31500}, {"1.06", 26500},  {"1", 25000},   {"7/8", 22400},   {"3/4", 19000},
     {"5/8", 16000},   {"0.530", 13200}, {"1/2", 12500}, {"7/16", 11200},  {"3/8", 9500},
     {"5/16", 8000},   {"0.265", 6700},  {"1/4", 6300}}};
constexpr std::array<Sieve, 33> astm_numbers = {
    {{"3-1/2", 5600}, {"4", 4750},  {"5", 4000},  {"6", 3350},  {"7", 2800}, {"8", 2360}, {"10", 2000},
     {"12", 1700},    {"14", 1400}, {"16", 1180}, {"18", 1000}, {"20", 850}, {"25", 710}, {"30", 600},
     {"35", 500},     {"40", 425},  {"45", 355},  {"50", 300},  {"60", 250}, {"70", 212}, {"80", 180},
     {"100", 150},    {"120", 125}, {"140", 106}, {"170", 90},  {"200", 75}, {"230", 63}, {"270", 53},
     {"325", 45},     {"400", 38},  {"450", 32},  {"500", 25},  {"635", 20}}};
constexpr std::array<Sieve, 32> tyler_numbers = {
    {{"2-1/2", 8000}, {"3", 6700}, {"3-1/2", 5600}, {"4", 4750},  {"5", 4000},  {"6", 3350},  {"7", 2800},
     {"8", 2360},     {"9", 2000}, {"10", 1700},    {"12", 1400}, {"14", 1180}, {"16", 1000}, {"20", 850},
     {"24", 710},     {"28", 600}, {"32", 500},     {"35", 425},  {"42", 355},  {"48", 300},  {"60", 250},
     {"65", 212},     {"80", 180}, {"100", 150},    {"115", 125}, {"150", 106}, {"170", 90},  {"200", 75},
     {"250", 63},     {"270", 53}, {"325", 45},     {"400", 38}}};

[[noreturn]] void refuse_name(std::string_view name) {
  throw InputError(in_quotes(name) +
                   " is no sieve: write a name such as 'No. 200', '3/8 in', 'Tyler 65 mesh', "
                   "'1.18 mm', '75 um' or 'pan'");
}

/// Removes `ending` from the end of `text` if it is there.
bool take_ending(std::string_view &text, std::string_view ending) {
  if (!text.ends_with(ending))
    return false;
  text.remove_suffix(ending.size());
  return true;
}

bool take_beginning(std::string_view &text, std::string_view beginning) {
  if (!text.starts_with(beginning))
    return false;
  text.remove_prefix(beginning.size());
  return true;
}

/// Moves the first character to `joined`: letters in lower case, the micro sign and the Greek mu as `u`.
void take_name_character(std::string_view &text, std::string &joined) {
  if (take_beginning(text, "\u00B5") || take_beginning(text, "\u03BC")) {
    joined += 'u';
    return;
  }
  joined += lower(text.front());
  text.remove_prefix(1);
}

/// The one spelling of a sieve's name. White space between two digits becomes `-`, all other is removed; an
/// inch at the end becomes `in`.
std::string normal_form(std::string_view name) {
  std::string text;
  for (bool gap = false; !name.empty();) {
    if (is_blank(name.front())) {
      gap = true;
      name.remove_prefix(1);
      continue;
    }
    if (gap && !text.empty() && is_digit(text.back()) && is_digit(name.front()))
      text += '-';
    take_name_character(name, text);
    gap = false;
  }
  std::string_view stem = text;
  for (const std::string_view inch : {"\"", "inches", "inch", "in."})
    if (take_ending(stem, inch))
      return std::string(stem) + "in";
  return text;
}

template <std::size_t n>
Rational opening(const std::array<Sieve, n> &table, std::string_view number, std::string_view name) {
  const auto found =
      std::find_if(table.begin(), table.end(), [number](const Sieve &s) { return s.name == number; });
  if (found == table.end())
    refuse_name(name);
  return ratio(found->opening, 1000);
}

/// Adds the openings of a table, which descend, in mm.
template <std::size_t n>
void add_openings(const std::array<Sieve, n> &table, std::vector<Rational> &openings) {
  for (auto sieve = table.rbegin(); sieve != table.rend(); ++sieve)
    openings.push_back(ratio(sieve->opening, 1000));
}

/// The number that a name such as `1-1/2` or `0.530` is.
Rational named_inches(std::string_view name) {
  const std::size_t slash = name.find('/');
  if (slash == std::string_view::npos)
    return parse_decimal(name);
  const std::size_t dash = name.find('-');
  const std::size_t from = dash == std::string_view::npos ? 0 : dash + 1;
  return (from == 0 ? Rational(0) : parse_decimal(name.substr(0, dash))) +
         parse_decimal(name.substr(from, slash - from)) / parse_decimal(name.substr(slash + 1));
}

/// A number of `unit` mm.
Rational metric(std::string_view number, const Rational &unit, char point, std::string_view name) {
  try {
    const Rational size = parse_decimal(number, point);
    if (size >= 0)
      return size * unit;
  } catch (const InputError &) { // the name as it was written says more
  }
  refuse_name(name);
}

} // namespace

Rational sieve_opening(std::string_view name, char point) {
  if (is_pan(name))
    return 0;
  const std::string text = normal_form(name);
  std::string_view rest = text;
  if (take_ending(rest, "mm"))
    return metric(rest, 1, point, name);
  if (take_ending(rest, "um"))
    return metric(rest, ratio(1, 1000), point, name);
  if (take_ending(rest, "m"))
    return metric(rest, 1000, point, name);
  if (take_beginning(rest, "tyler")) {
    take_ending(rest, "mesh");
    return opening(tyler_numbers, rest, name);
  }
  if (take_beginning(rest, "no.") || take_beginning(rest, "no") || take_beginning(rest, "#"))
    return opening(astm_numbers, rest, name);
  if (take_ending(rest, "in"))
    return opening(astm_inches, rest, name);
  refuse_name(name);
}

std::optional<std::string> astm_sieve_name(const Rational &opening) {
  const auto is_it = [&opening](const Sieve &s) { return opening * 1000 == s.opening; };
  const auto number = std::find_if(astm_numbers.begin(), astm_numbers.end(), is_it);
  if (number != astm_numbers.end())
    return "No. " + std::string(number->name);
  const auto inches = std::find_if(astm_inches.begin(), astm_inches.end(), is_it);
  if (inches != astm_inches.end())
    return std::string(inches->name) + " in";
  return std::nullopt;
}

std::optional<std::string> astm_inch_name(const Rational &inches) {
  const auto found = std::find_if(astm_inches.begin(), astm_inches.end(),
                                  [&inches](const Sieve &s) { return named_inches(s.name) == inches; });
  return found == astm_inches.end() ? std::nullopt : std::optional(std::string(found->name) + " in");
}

std::vector<Rational> astm_openings() {
  std::vector<Rational> openings;
  add_openings(astm_numbers, openings);
  add_openings(astm_inches, openings);
  return openings;
}

std::vector<Rational> tyler_openings() {
  std::vector<Rational> openings;
  add_openings(tyler_numbers, openings);
  return openings;
}

} // namespace mdm
