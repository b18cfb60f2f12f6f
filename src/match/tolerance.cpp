#include "match/widest_tolerance.hpp"
#include "number/common_denominator.hpp"
#include "number/typed_number.hpp"

#include <mdm/match/tolerance.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

using Kind = AskedTolerance::Kind;

struct Named {
  std::string_view name;
  Kind kind;
};
constexpr std::array<Named, 3> of_percent = {
    {{"retained:", Kind::retained}, {"passing:", Kind::passing}, {"total:", Kind::total}}};
constexpr std::array<Named, 4> of_words = {{{"retained:file", Kind::retained_file},
                                            {"passing:file", Kind::passing_file},
                                            {"laboratory", Kind::laboratory},
                                            {"rounding", Kind::rounding}}};

/// |share - middle| <= width, cut to what shares can be.
ShareBounds around(const Rational &middle, const Rational &width) {
  return {std::max(Rational(0), Rational(middle - width)), std::min(Rational(1), Rational(middle + width))};
}

void narrow(ShareBounds &bounds, const ShareBounds &by) {
  bounds.lo = std::max(bounds.lo, by.lo);
  bounds.hi = std::min(bounds.hi, by.hi);
}

/// The least decimal e of 6 places with e >= 0.05 sqrt(X (100 - X)), that is e^2 >= X (100 - X) / 400.
Rational reproducibility(const Rational &passing) {
  const Rational x = passing * 100;
  constexpr unsigned places = 6;
  const Rational square = x * (100 - x) / 400 * Rational(power_of_ten(2 * places));
  const Integer below = floor_root(floor(square), 2);
  return ratio(Rational(below * below) == square ? below : Integer(below + 1), power_of_ten(places));
}

/// Tolerances on what passes, of all sieves but the first.
void narrow_passing(Tolerance &tolerance, const Gradation &g, const std::vector<Rational> &percent) {
  const std::vector<Rational> passing = accumulated(shares(g));
  tolerance.passing.resize(g.classes());
  for (std::size_t j = 0; j + 1 < g.classes(); ++j)
    narrow(tolerance.passing[j], around(passing[j], Rational(percent[j] / 100)));
}

void narrow_retained(Tolerance &tolerance, const Gradation &g, const std::vector<Rational> &percent) {
  const std::vector<Rational> retained = shares(g);
  tolerance.retained.resize(g.classes());
  for (std::size_t j = 0; j < g.classes(); ++j)
    narrow(tolerance.retained[j], around(retained[j], Rational(percent[j] / 100)));
}

const std::vector<Rational> &file_tolerances(const Gradation &g) {
  if (g.tolerances().empty())
    throw InputError("the file has no column tolerance_percent: add one (in JSON tolerances_percent), or "
                     "give the tolerance in percent");
  return g.tolerances();
}

void narrow_to_envelope(Tolerance &tolerance, const Gradation &g, const Envelope &envelope,
                        const Rational &size_factor) {
  tolerance.passing.resize(g.classes());
  const Rational scale = in_mm(envelope.unit) / in_mm(g.unit()) * size_factor;
  for (std::size_t i = 0; i < envelope.sizes.size(); ++i) {
    const Rational x = envelope.sizes[i] * scale;
    const std::string sieve =
        fmt::format("the band's sieve {} {}", to_decimal(envelope.sizes[i]), name(envelope.unit));
    const Rational powered = power(x, g.root());
    const std::vector<Rational> &openings = g.powers();
    if (powered <= openings.front()) {
      if (envelope.passing_min[i] > 0)
        throw InputError(sieve + " lets something pass, where the gradation has no finer class: add a row "
                                 "'pan' (in JSON the size 0)");
      continue;
    }
    const auto found = std::lower_bound(openings.begin(), openings.end(), powered);
    if (found != openings.end() && *found != powered)
      throw InputError(sieve + " is no sieve of the gradation: add a row for it, or leave it out of "
                               "the band");
    const std::size_t j =
        found == openings.end() ? g.classes() - 1 : static_cast<std::size_t>(found - openings.begin()) - 1;
    narrow(tolerance.passing[j],
           {Rational(envelope.passing_min[i] / 100), Rational(envelope.passing_max[i] / 100)});
  }
}

/// A row of several materials that begins no class has no share.
void narrow_to_classes(Tolerance &tolerance, const Gradation &g) {
  tolerance.retained.resize(g.classes());
  for (std::size_t j = 0; j < g.classes(); ++j)
    if (!g.is_class(j))
      tolerance.retained[j] = {0, 0};
}

/// The number in a text; nothing if it is none.
std::optional<Rational> decimal_in(std::string_view text) {
  try {
    return parse_typed_decimal(text);
  } catch (const InputError &) {
    return std::nullopt;
  }
}

} // namespace

AskedTolerance parse_tolerance(std::string_view text) {
  if (text == "file")
    return {Kind::retained_file, 0};
  for (const Named &named : of_words)
    if (text == named.name)
      return {named.kind, 0};
  AskedTolerance asked; // without a word it is of what is retained
  std::string_view number = text;
  for (const Named &named : of_percent)
    if (text.starts_with(named.name)) {
      asked.kind = named.kind;
      number.remove_prefix(named.name.size());
    }
  if (number.ends_with('%'))
    number.remove_suffix(1);
  const std::optional<Rational> percent = decimal_in(number);
  if (!percent)
    throw InputError(in_quotes(text) +
                     " is no tolerance: write retained:1%, passing:0.5%, total:1%, retained:file, "
                     "passing:file, laboratory or rounding");
  const Rational widest = widest_tolerance(asked.kind);
  if (*percent < 0 || *percent > widest)
    throw InputError(in_quotes(text) + " is not between 0 and " + to_decimal(widest) + " percentage points");
  asked.percent = *percent;
  return asked;
}

std::string to_string(const AskedTolerance &asked) {
  for (const Named &named : of_words)
    if (asked.kind == named.kind)
      return std::string(named.name);
  for (const Named &named : of_percent)
    if (asked.kind == named.kind)
      return std::string(named.name) + to_decimal(asked.percent) + "%";
  return {};
}

std::vector<Rational> passing_tolerances(const Gradation &g, AskedTolerance::Kind kind) {
  if (kind == Kind::rounding) {
    if (g.roundings().empty())
      throw InputError("rounding needs what passes as the laboratory wrote it: a file with passing_percent, "
                       "passing_fraction or cumulative_retained_percent, or AGS4");
    return {std::next(g.roundings().begin()), std::prev(g.roundings().end())};
  }
  std::vector<Rational> percent = accumulated(shares(g));
  percent.pop_back();
  std::transform(percent.begin(), percent.end(), percent.begin(), reproducibility);
  return percent;
}

Tolerance tolerance_of(const Gradation &g, const std::vector<AskedTolerance> &asked,
                       const std::optional<Envelope> &envelope, const Rational &size_factor) {
  Tolerance tolerance;
  for (const AskedTolerance &a : asked) {
    if (!g.materials().empty() && a.kind != Kind::retained && a.kind != Kind::total)
      throw InputError("tolerance " + to_string(a) +
                       " has no meaning for several materials: use retained:E% or total:E%");
    const std::vector<Rational> everywhere(g.classes(), a.percent);
    switch (a.kind) {
    case Kind::retained:
      narrow_retained(tolerance, g, everywhere);
      break;
    case Kind::passing:
      narrow_passing(tolerance, g, everywhere);
      break;
    case Kind::total:
      tolerance.total = std::min(tolerance.total.value_or(Rational(2)), Rational(a.percent / 100));
      break;
    case Kind::retained_file:
      narrow_retained(tolerance, g, file_tolerances(g));
      break;
    case Kind::passing_file:
      narrow_passing(tolerance, g, {std::next(file_tolerances(g).begin()), g.tolerances().end()});
      break;
    default:
      narrow_passing(tolerance, g, passing_tolerances(g, a.kind));
    }
  }
  if (envelope)
    narrow_to_envelope(tolerance, g, *envelope, size_factor);
  if (!g.materials().empty())
    narrow_to_classes(tolerance, g);
  return tolerance;
}

Gradation middle_of(const Envelope &envelope) {
  if (envelope.passing_max.back() != 100)
    throw InputError(fmt::format(
        "the band lets at most {} percent pass its largest sieve, {} {}: add a larger sieve "
        "that lets 100 pass",
        to_decimal(envelope.passing_max.back()), to_decimal(envelope.sizes.back()), name(envelope.unit)));
  const std::size_t n = envelope.sizes.size();
  // The narrowest bounds of a curve that does not fall: lo'_i = max of lo up to i, hi'_i = min of hi from i
  // on.
  std::vector<Rational> lo = envelope.passing_min, hi = envelope.passing_max;
  for (std::size_t i = 1; i < n; ++i)
    lo[i] = std::max(lo[i], lo[i - 1]);
  for (std::size_t i = n - 1; i-- > 0;)
    hi[i] = std::min(hi[i], hi[i + 1]);
  const bool contradicts = contradiction(envelope).has_value();
  std::vector<Rational> passing(n);
  for (std::size_t i = 0; i + 1 < n; ++i)
    passing[i] = contradicts ? lo[i] : Rational((lo[i] + hi[i]) / 2);
  passing.back() = 100;
  if (envelope.sizes.front() == 0)
    passing.front() = 0;
  Gradation::Data data;
  data.id = envelope.id;
  data.unit = envelope.unit;
  data.sizes = envelope.sizes;
  if (passing.front() > 0 && data.sizes.front() > 0) {
    data.sizes.insert(data.sizes.begin(), Rational(0));
    passing.insert(passing.begin(), Rational(0));
  }
  for (std::size_t i = 0; i + 1 < passing.size(); ++i)
    data.masses.push_back(passing[i + 1] - passing[i]);
  data.masses.emplace_back(0);
  data.notes = envelope.notes;
  data.notes.emplace_back("No gradation was given: the target is the middle of the band.");
  return Gradation(std::move(data));
}

std::vector<Rational> shares(const Gradation &g) {
  const Rational all = sum(g.masses());
  std::vector<Rational> result;
  for (std::size_t j = 0; j < g.classes(); ++j)
    result.push_back(g.mass(j) / all);
  return result;
}

std::vector<Rational> accumulated(std::vector<Rational> shares) {
  for (std::size_t j = 1; j < shares.size(); ++j)
    shares[j] += shares[j - 1];
  return shares;
}

} // namespace mdm
