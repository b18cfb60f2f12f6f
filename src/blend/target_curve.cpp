// A curve at a size is a fraction of powers d^q with a rational q = n / m: each is the m-th root of a
// rational number. Where that is rational it is exact; else it lies between two neighbours of as many
// decimals as one likes, so that the percent lies between two fractions. As soon as both round to the same
// number, that is it. They do so in the end: the percent would have to be exactly half a unit of the last
// place, a fraction, and 1 and irrational real roots of fractions are linearly dependent only where two of
// them are multiples of each other (Besicovitch 1940), which then makes the percent 0 or 100.

#include "blend/target_curve.hpp"

#include "gradation/length.hpp"
#include "text/lines.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/number/interval.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <array>
#include <optional>
#include <set>

namespace mdm {
namespace {

constexpr std::array<std::string_view, 4> words = {"power45", "fuller", "andreasen", "bolomey"};

/// The m-th root where it is an integer.
std::optional<Integer> exact_root(const Integer &n, unsigned m) {
  const Integer root = floor_root(n, m);
  return power(root, m) == n ? std::optional(root) : std::nullopt;
}

/// r^q for 0 <= r <= 1: exact where it is a fraction, else bounds that are 10^-places apart.
Interval power_between(const Rational &r, const Rational &q, unsigned places) {
  const auto n = static_cast<unsigned>(numerator(q)), m = static_cast<unsigned>(denominator(q));
  const Rational radicand = power(r, n);
  const std::optional<Integer> top = exact_root(numerator(radicand), m),
                               bottom = exact_root(denominator(radicand), m);
  if (top && bottom)
    return Rational(ratio(*top, *bottom));
  const Integer unit = power_of_ten(places);
  const Integer low = floor_root(floor(Rational(radicand * power(unit, m))), m);
  return {ratio(low, unit), ratio(Integer(low + 1), unit)};
}

/// Rounds to target_places, halves up.
Rational rounded(const Rational &percent) {
  const Integer unit = power_of_ten(target_places);
  return ratio(floor(Rational(percent * unit + ratio(1, 2))), unit);
}

std::string_view next_part(std::string_view &text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string_view part = trimmed(text.substr(0, comma));
  text.remove_prefix(std::min(comma + 1, text.size()));
  return part;
}

Rational length_in_mm(std::string_view text) {
  return parse_length(text).in(SizeUnit::mm);
}

/// What is asked of an exponent: small numbers, as roots are taken by it.
Rational exponent_of(std::string_view text) {
  const Rational q = parse_decimal(text);
  constexpr unsigned most_denominator = 1000;
  if (q <= 0 || q > 10 || denominator(q) > most_denominator)
    throw InputError("q is a number above 0, up to 10, of at most 3 decimals");
  return q;
}

/// \return the name of what the part sets
std::string_view set_part(TargetCurve &curve, std::string_view word, std::string_view part) {
  const std::size_t equals = part.find('=');
  const std::string_view key = trimmed(part.substr(0, equals));
  const std::string_view value = equals == std::string_view::npos ? "" : trimmed(part.substr(equals + 1));
  if (word == "andreasen" && key == "q")
    curve.exponent = exponent_of(value);
  else if (word == "andreasen" && key == "dmin")
    curve.smallest = length_in_mm(value);
  else if (word == "bolomey" && key == "a")
    curve.start = parse_decimal(value);
  else
    throw InputError(in_quotes(part) + " is not of " + std::string(word));
  return key;
}

} // namespace

bool names_target_curve(std::string_view text) {
  const std::size_t colon = text.find(':');
  return colon != std::string_view::npos &&
         std::find(words.begin(), words.end(), text.substr(0, colon)) != words.end();
}

TargetCurve parse_target_curve(std::string_view text) {
  const std::string_view word = text.substr(0, text.find(':'));
  std::string_view rest = text.substr(std::min(word.size() + 1, text.size()));
  TargetCurve curve;
  curve.exponent = word == "power45" ? ratio(9, 20) : word == "andreasen" ? Rational(0) : ratio(1, 2);
  try {
    curve.largest = length_in_mm(next_part(rest));
    std::set<std::string_view> given;
    while (!rest.empty())
      if (const std::string_view key = set_part(curve, word, next_part(rest)); !given.insert(key).second)
        throw InputError(in_quotes(key) + " has two values: give one");
    if (word == "bolomey" && given.empty())
      throw InputError("a is missing");
    if (curve.exponent == 0)
      throw InputError("q is missing");
    if (curve.smallest >= curve.largest)
      throw InputError("dmin is not below the largest size");
    if (curve.start < 0 || curve.start >= 100)
      throw InputError("a is a percent from 0 to less than 100");
  } catch (const InputError &e) {
    throw InputError(in_quotes(text) + ": " + e.what() +
                     ": write power45:19mm, fuller:31.5mm, andreasen:16mm,q=0.25,dmin=0.063mm or "
                     "bolomey:31.5mm,a=10");
  }
  return curve;
}

Rational TargetCurve::passing(const Rational &size) const {
  if (size >= largest)
    return 100;
  if (size <= smallest)
    return 0;
  for (unsigned places = 2 * target_places;; places *= 2) {
    const Interval at = power_between(Rational(size / largest), exponent, places);
    const Interval from = power_between(Rational(smallest / largest), exponent, places);
    if (from.hi >= 1)
      continue;
    // (t - s) / (1 - s) rises with t and falls with s.
    const auto percent = [this](const Rational &t, const Rational &s) {
      return rounded(Rational(start + (100 - start) * (t - s) / (1 - s)));
    };
    const Rational low = percent(at.lo, from.hi), high = percent(at.hi, from.lo);
    if (low == high)
      return low;
  }
}

Gradation gradation_of(const TargetCurve &curve, const Envelope &specification, const std::string &name) {
  std::set<Rational> sizes = {0, curve.largest};
  for (const Rational &size : specification.sizes)
    sizes.insert(Rational(size * in_mm(specification.unit)));
  Gradation::Data data;
  data.id = name;
  data.sizes.assign(sizes.begin(), sizes.end());
  Rational before = 0;
  for (std::size_t j = 1; j < data.sizes.size(); ++j) {
    const Rational passing = curve.passing(data.sizes[j]);
    data.masses.push_back(passing - before);
    before = passing;
  }
  data.masses.emplace_back(0);
  data.notes = {
      fmt::format("what passes is computed and rounded to {} decimals of a percent; what is said of the "
                  "best blend, and its proof, are of these numbers",
                  target_places)};
  return Gradation(std::move(data));
}

} // namespace mdm
