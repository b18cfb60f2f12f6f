#include "ask/option_values.hpp"

#include "number/typed_number.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>
#include <limits>

namespace mdm {
namespace {

/// Digits beyond this are of no use, and cost.
constexpr unsigned most_digits = 1000;

constexpr std::size_t most_numbers = 1000;

std::vector<std::string> parts_between(const std::string &text, char separator) {
  std::vector<std::string> all;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(separator, from), text.size());
    all.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return all;
}

std::vector<Rational> number_steps(const std::string &name, const std::vector<std::string> &words) {
  const Rational from = positive(name, words[0]), to = positive(name, words[1]),
                 step = positive(name, words[2]);
  if (to < from)
    throw InputError(option(name) + ": " + in_quotes(words[0] + ":" + words[1]) +
                     " has its end before its start");
  if ((to - from) / step >= Rational(most_numbers))
    throw InputError(option(name) + ": more than 1000 numbers: take a larger step");
  std::vector<Rational> numbers;
  for (Rational at = from; at <= to; at += step)
    numbers.push_back(at);
  return numbers;
}

} // namespace

Rational number(const std::string &name, const std::string &text) {
  return named(name, text, parse_typed_decimal);
}

Integer natural(const std::string &name, const std::string &text, const Integer &least) {
  const std::optional<Integer> n = parse_typed_natural(text);
  if (!n || *n < least)
    throw InputError(option(name) + ": " + in_quotes(text) + " is not a whole number from " +
                     to_string(least) + " on (at most 1000 digits, exponents up to 400)");
  return *n;
}

std::uint64_t natural64(const std::string &name, const std::string &text) {
  const Integer n = natural(name, text, 0);
  const Integer most = std::numeric_limits<std::uint64_t>::max();
  return n > most ? std::numeric_limits<std::uint64_t>::max() : static_cast<std::uint64_t>(n);
}

std::uint64_t seed64(const std::string &name, const std::string &text) {
  const Integer n = natural(name, text, 0);
  if (n > std::numeric_limits<std::uint64_t>::max())
    throw InputError(option(name) + ": at most 18446744073709551615 (64 bits)");
  return static_cast<std::uint64_t>(n);
}

Rational positive(const std::string &name, const std::string &text) {
  const Rational r = number(name, text);
  if (r <= 0)
    throw InputError(option(name) + ": " + in_quotes(text) + " is not positive: write a number above 0");
  return r;
}

Rational not_negative(const std::string &name, const std::string &text) {
  const Rational r = number(name, text);
  if (r < 0)
    throw InputError(option(name) + ": " + in_quotes(text) + " is negative: write a number from 0 on");
  return r;
}

std::chrono::milliseconds duration(const std::string &name, const std::string &text) {
  const Rational seconds = not_negative(name, text);
  const Integer thirty_years = 1'000'000'000'000;
  const Integer milliseconds = std::min(floor(Rational(seconds * 1000)), thirty_years);
  return std::chrono::milliseconds(static_cast<std::int64_t>(milliseconds));
}

unsigned small_natural(const std::string &name, const std::string &text, unsigned least, unsigned most) {
  const Integer n = natural(name, text, least);
  if (n > most)
    throw InputError(option(name) + ": " + in_quotes(text) + " is above " + std::to_string(most) +
                     ": write a number up to that");
  return static_cast<unsigned>(n);
}

Rational percent_of(const std::string &name, const std::string &text) {
  const Rational percent = not_negative(name, text.ends_with('%') ? text.substr(0, text.size() - 1) : text);
  if (percent > 100)
    throw InputError(option(name) + ": " + in_quotes(text) + " is above 100%: write a part of the whole");
  return percent;
}

unsigned digits_of(const std::string &name, const std::string &text) {
  return small_natural(name, text, 1, most_digits);
}

Length length(const std::string &name, const std::string &text) {
  return named(name, text, parse_length);
}

std::vector<Rational> box_sides(const std::string &name, const std::string &text, SizeUnit unit) {
  std::vector<Rational> sides;
  for (const Length &side : named(name, text, parse_lengths))
    sides.push_back(side.in(unit));
  if (sides.size() < 2 || sides.size() > 3)
    throw InputError(option(name) + ": " + in_quotes(text) +
                     " is neither AxB nor AxBxC: write for example 50x50");
  return sides;
}

std::vector<Rational> number_list(const std::string &name, const std::string &text) {
  const std::vector<std::string> words = parts_between(text, ':');
  if (words.size() == 3)
    return number_steps(name, words);
  if (words.size() != 1)
    throw InputError(option(name) + ": " + in_quotes(text) + " is not a list: write 1,2,5 or FROM:TO:STEP");
  std::vector<Rational> numbers;
  for (const std::string &word : parts_between(text, ','))
    numbers.push_back(positive(name, word));
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

SizeUnit size_unit_of(const std::string &name, const std::string &text) {
  const std::optional<SizeUnit> unit = parse_size_unit(text);
  if (!unit)
    throw InputError(option(name) + ": " + in_quotes(text) + " is unknown: use mm, um, m or in");
  return *unit;
}

} // namespace mdm
