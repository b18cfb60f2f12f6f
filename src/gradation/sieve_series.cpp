#include "gradation/sieve_series.hpp"

#include "gradation/phi.hpp"
#include "gradation/sieve_name.hpp"

#include <mdm/text/error.hpp>

#include <array>

namespace mdm {
namespace {

/// ISO 565: 20 sizes a decade, in hundredths of its first.
constexpr std::array<unsigned, 20> r20 = {100, 112, 125, 140, 160, 180, 200, 224, 250, 280,
                                          315, 355, 400, 450, 500, 560, 630, 710, 800, 900};

/// Every `step`-th size of R20 from 20 um to 125 mm, counted from 1 mm; those below 40 um have two digits.
std::vector<Rational> iso_series(unsigned step) {
  constexpr unsigned first = 6, last = 82; // 20 um and 125 mm, counted from 10 um
  constexpr unsigned one_mm = 40, first_of_three_digits = 12;
  std::vector<Rational> sizes;
  for (unsigned i = first; i <= last; ++i) {
    if (i % step != one_mm % step)
      continue;
    const unsigned hundredths = i < first_of_three_digits ? (r20[i] + 5) / 10 * 10 : r20[i % r20.size()];
    sizes.push_back(ratio(hundredths, 10000) * power(Rational(10), static_cast<unsigned>(i / r20.size())));
  }
  return sizes;
}

std::vector<Rational> phi_series(int steps) {
  constexpr int least = -7, largest = 14;
  std::vector<Rational> sizes;
  for (int i = largest * steps; i >= least * steps; --i)
    sizes.push_back(phi_size(ratio(i, steps)));
  return sizes;
}

} // namespace

std::vector<Rational> sieve_series(const std::string &name) {
  if (name == "ISO R20/3")
    return iso_series(3);
  if (name == "ISO R20")
    return iso_series(1);
  if (name == "ASTM E11")
    return astm_openings();
  if (name == "Tyler")
    return tyler_openings();
  if (name == "phi")
    return phi_series(1);
  if (name == "half-phi")
    return phi_series(2);
  if (name == "quarter-phi")
    return phi_series(4);
  throw InputError(in_quotes(name) +
                   " is no series of sieves: write ISO R20/3, ISO R20, ASTM E11, Tyler, phi, half-phi or "
                   "quarter-phi");
}

} // namespace mdm
