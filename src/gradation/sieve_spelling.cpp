#include "gradation/sieve_spelling.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/cells.hpp"
#include "gradation/plain_spelling.hpp"
#include "gradation/shown.hpp"
#include "gradation/sieve_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

// A fraction sign behind a digit is a part of its number; the blank makes two of them.
constexpr std::array characters = {
    Spelling{"½", " 1/2"},    Spelling{"¼", " 1/4"},    Spelling{"¾", " 3/4"},   Spelling{"⅛", " 1/8"},
    Spelling{"⅜", " 3/8"},    Spelling{"⅝", " 5/8"},    Spelling{"⅞", " 7/8"},   Spelling{"\u2044", "/"},
    Spelling{"\u201D", "\""}, Spelling{"\u2033", "\""}, Spelling{"\u00A0", " "}, Spelling{"\u202F", " "},
    Spelling{"\u2009", " "},  Spelling{"N°", "No. "},   Spelling{"Nº", "No. "},  Spelling{"n°", "No. "},
    Spelling{"№", "No. "},    Spelling{"\u2011", "-"},  Spelling{"\u2010", "-"},
};

bool drop_beginning(std::string_view &text, std::string_view beginning) {
  if (!text.starts_with(beginning))
    return false;
  text = without_spaces(text.substr(beginning.size()));
  return true;
}

bool drop_ending(std::string_view &text, std::string_view ending) {
  if (!text.ends_with(ending))
    return false;
  text = without_spaces(text.substr(0, text.size() - ending.size()));
  return true;
}

/// The names of series whose numbers are those of ASTM E11.
void take_series(std::string_view &text) {
  for (const std::string_view before : {"u.s. ", "us ", "astm ", "u.s.", "sieve "})
    drop_beginning(text, before);
  for (const std::string_view behind : {" sieve", " u.s.", " us", " astm"})
    drop_ending(text, behind);
}

/// `3/8`, `1-1/2`, `1.5` or `.75`: inches of a name.
std::optional<Rational> inches(std::string_view text, char point) {
  const auto number = [point](std::string_view part) -> std::optional<Rational> {
    try {
      return parse_decimal(part, point);
    } catch (const InputError &) { // the name as it was written says more
      return std::nullopt;
    }
  };
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos)
    return number(text);
  const std::size_t gap = std::min(text.find_first_of(" -"), text.size());
  const std::optional<Rational> inches = gap < slash ? number(text.substr(0, gap)) : Rational(0);
  const std::size_t from = gap < slash ? text.find_first_not_of(" -", gap) : 0;
  const std::optional<Rational> above = number(without_spaces(text.substr(from, slash - from))),
                                below = number(without_spaces(text.substr(slash + 1)));
  if (!inches || !above || !below || *below == 0)
    return std::nullopt;
  return *inches + *above / *below;
}

/// The number before a unit of inches.
std::optional<std::string_view> before_inches(std::string_view text) {
  for (const std::string_view unit : {"\"", "''", "inches", "inch", "in.", "in"})
    if (drop_ending(text, unit)) {
      drop_ending(text, "-");
      return text;
    }
  return std::nullopt;
}

/// Opening in mm of a name without brackets.
Rational one_name(std::string_view written, char point) {
  const std::string plain = spelled_plainly(written, characters);
  std::string_view text = without_spaces(plain);
  take_series(text);
  if (const std::optional<std::string_view> number = before_inches(text)) {
    const std::optional<Rational> size = inches(*number, point);
    const std::optional<std::string> name = size ? astm_inch_name(*size) : std::nullopt;
    if (name)
      return sieve_opening(*name);
  } else if (const std::optional<NumberCell> metric = number_cell(text);
             metric && metric->unit == ColumnUnit::um) {
    return sieve_opening(std::string(metric->digits) + " um", point);
  } else if (metric && metric->unit == ColumnUnit::mm) {
    return sieve_opening(std::string(metric->digits) + " mm", point);
  } else if (drop_beginning(text, "nr.") || drop_beginning(text, "nr ")) {
    return sieve_opening("No. " + std::string(text));
  }
  try {
    return sieve_opening(text, point);
  } catch (const InputError &) {
    return sieve_opening(written, point); // refuses it as it was written
  }
}

/// True for openings that the next sieves of a series do not share: older standards differ from the names of
/// today by up to 1.6 percent, the next sieves by 12 or more.
bool are_close(const Rational &a, const Rational &b) {
  constexpr int most_percent = 3;
  const Rational difference = a > b ? Rational(a - b) : Rational(b - a);
  return difference * 100 <= std::max<Rational>(a, b) * most_percent;
}

/// Opening in mm of a name, or of a number alone beside a sieve of `near` mm: in mm or um, whichever is
/// close.
Rational name_or_number(std::string_view name, const std::optional<Rational> &near, char point) {
  const std::optional<NumberCell> number = number_cell(name);
  if (!near || !number || number->unit != ColumnUnit::none)
    return one_name(name, point);
  const Rational size = parse_decimal(number->digits, point);
  return are_close(size, *near) || !are_close(size / 1000, *near) ? size : Rational(size / 1000);
}

bool is_number(std::string_view name) {
  const std::optional<NumberCell> number = number_cell(name);
  return number && number->unit == ColumnUnit::none;
}

bool is_metric_name(std::string_view name) {
  const std::optional<NumberCell> number = number_cell(spelled_plainly(name, characters));
  return number && number->unit != ColumnUnit::inch;
}

/// A name with another in brackets behind it, `4.75 mm (No. 4)`, or behind a slash with spaces.
std::optional<std::array<std::string_view, 2>> two_names(std::string_view name) {
  if (const std::size_t open = name.find('('); open != std::string_view::npos && name.ends_with(')'))
    return std::array{without_spaces(name.substr(0, open)),
                      without_spaces(name.substr(open + 1, name.size() - open - 2))};
  if (const std::size_t slash = name.find(" / ");
      slash != std::string_view::npos &&
      number_cell(name.substr(0, slash)).has_value() != number_cell(name.substr(slash + 3)).has_value())
    return std::array{without_spaces(name.substr(0, slash)), without_spaces(name.substr(slash + 3))};
  return std::nullopt;
}

} // namespace

Rational spelled_sieve_opening(std::string_view name, char point) {
  const auto names = two_names(name);
  if (!names)
    return one_name(name, point);
  const auto [first, second] = *names;
  const std::optional<Rational> sure =
      is_number(first) ? std::nullopt : std::optional(one_name(first, point));
  const Rational b = name_or_number(second, sure, point), a = sure ? *sure : name_or_number(first, b, point);
  if (!are_close(a, b))
    throw InputError(fmt::format("the names in {} are of two sieves, {} mm and {} mm: correct one of them",
                                 in_quotes(name), shown(a), shown(b)));
  return is_metric_name(second) && !is_metric_name(first) ? b : a;
}

} // namespace mdm
