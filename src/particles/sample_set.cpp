#include "particles/sample_set.hpp"

#include "gradation/shown.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/number/enclosure.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// A size as a number of a file, with the greatest error of the mass of it.
WrittenNumber number_in(const SizeRange &x, const ParticleSetOptions &options, Rational &mass_error) {
  constexpr unsigned cube = 3;
  const Rational middle = (x.lo + x.hi) / 2;
  // Around a size that is known its mass sets the limits.
  const Rational lower = x.is_point() ? Rational(0) : x.lo, upper = x.is_point() ? Rational(2 * x.hi) : x.hi;
  SizeToWrite size{power(middle, cube), cube, lower, upper, options.most_mass_error};
  std::optional<WrittenNumber> n = shortest_number(size);
  if (!n) { // the range is narrower than doubles are apart
    size.lower = 0;
    size.upper = 2 * x.hi;
    n = shortest_number(size);
  }
  if (!n)
    throw InputError(fmt::format("a particle of {} {}: no double has its mass within {} of the exact one: "
                                 "allow a larger {}, or take another {}",
                                 shown(x.hi), name(options.unit), approximate(options.most_mass_error, 3),
                                 option("mass-error"), option("unit")));
  mass_error = std::max({mass_error, size.error(n->decimal()), size.error(exact_value(n->value))});
  return *std::move(n);
}

} // namespace

void SampleSet::add(const RootSize &diameter, const Integer &quantity) {
  constexpr unsigned digits = 20;
  if (diameter.degree == 1) {
    add(SizeRange{diameter.power, diameter.power}, quantity);
    return;
  }
  const Enclosure x =
      enclose_root(numerator(diameter.power), denominator(diameter.power), diameter.degree, digits);
  add(SizeRange{x.lower(), x.upper()}, quantity);
}

void SampleSet::add(const SizeRange &diameter, const Integer &quantity) {
  sizes_[{diameter.lo, diameter.hi}] += quantity;
  if (sizes_.size() > most_sizes)
    throw InputError(
        fmt::format("more than the {} sizes that a set can hold: leave particles out", most_sizes));
}

ParticleSet SampleSet::set(const std::string &name, SizeUnit from, const ParticleSetOptions &options) const {
  if (sizes_.empty())
    throw InputError("there are no particles: give a file that has some");
  const Rational unit = in_mm(from) / in_mm(options.unit);
  ParticleClass all;
  all.number = 1;
  all.lower = 0;
  all.density = options.density * power(Rational(in_mm(options.unit) / 1000), 3);
  for (const auto &[range, quantity] : sizes_) {
    const SizeRange diameter{range.first * unit, range.second * unit};
    const SizeRange radius{diameter.lo / 2, diameter.hi / 2};
    all.upper = std::max(all.upper, Rational(2 * diameter.hi));
    all.sizes.push_back(
        {number_in(diameter, options, all.mass_error), number_in(radius, options, all.mass_error), quantity});
  }
  ParticleSet set{name, options.unit, {}, {}, 0};
  set.classes.push_back(std::move(all));
  return set;
}

} // namespace mdm
