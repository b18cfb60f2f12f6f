#include "particles/sample_sieves.hpp"

#include "gradation/step_curve.hpp"
#include "number/decimal_exponent.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/number/enclosure.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// The least decimal of so many significant digits that is not below x > 0.
Rational rounded_up(const Rational &x, unsigned digits) {
  const Rational unit = ten_to(decimal_exponent(x) + 1 - static_cast<long>(digits));
  return Rational(ceil(Rational(x / unit))) * unit;
}

} // namespace

void SampleSieves::restart() {
  *this = SampleSieves();
}

void SampleSieves::gather(const Rational &least, const Rational &size, const Integer &quantity) {
  const Rational sieve = digits_ == 0 ? size : rounded_up(size, digits_);
  masses_[sieve] += power(size, 3) * Rational(quantity);
  particles_ += quantity;
  Rational &known = least_.try_emplace(sieve, least).first->second;
  known = std::min(known, least);
  if (masses_.size() > most_sieves)
    coarsen();
}

void SampleSieves::coarsen() {
  constexpr unsigned first_digits = 4;
  do {
    digits_ = digits_ == 0 ? first_digits : digits_ - 1;
    std::map<Rational, Rational> coarser, least;
    for (const auto &[size, mass] : masses_) {
      const Rational sieve = rounded_up(size, digits_);
      coarser[sieve] += mass;
      Rational &known = least.try_emplace(sieve, least_.at(size)).first->second;
      known = std::min(known, least_.at(size));
    }
    masses_ = std::move(coarser);
    least_ = std::move(least);
  } while (masses_.size() > most_sieves && digits_ > 1);
}

void SampleSieves::add(const RootSize &diameter, const Integer &quantity) {
  constexpr unsigned digits = 15;
  if (diameter.degree == 1)
    return gather(diameter.power, diameter.power, quantity);
  const Enclosure size =
      enclose_root(numerator(diameter.power), denominator(diameter.power), diameter.degree, digits);
  gather(size.lower(), size.upper(), quantity);
}

void SampleSieves::add(const SizeRange &diameter, const Integer &quantity) {
  has_ranges_ = has_ranges_ || !diameter.is_point();
  gather(diameter.lo, diameter.hi, quantity);
}

Gradation SampleSieves::gradation(const std::string &id, SizeUnit unit, std::vector<std::string> notes,
                                  SampleClasses classes) const {
  Gradation::Data data;
  data.notes = std::move(notes);
  data.id = id;
  data.unit = unit;
  data.sizes.emplace_back(0);
  const bool has_steps = classes == SampleClasses::at_sizes;
  for (const auto &[size, mass] : masses_)
    add_step(data, has_steps ? least_.at(size) : Rational(0), size, mass);
  data.masses.emplace_back(0);
  data.notes.push_back(fmt::format("a sample of {} spheres: its gradation has a sieve of each size{}{}",
                                   to_string(particles_),
                                   digits_ == 0 ? "" : fmt::format(", rounded up to {} digits", digits_),
                                   has_steps ? ", and one 10^-12 of it below" : ""));
  if (has_ranges_)
    data.notes.emplace_back("of sizes of which ranges are known the upper ends were taken");
  return Gradation(std::move(data));
}

} // namespace mdm
