#include "gradation/exact_cut.hpp"

#include "gradation/shown.hpp"
#include "number/common_denominator.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {

std::size_t classes_below(const Gradation &g, const Rational &size, const char *where) {
  const std::vector<Rational> &x = g.sizes();
  const auto not_above = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), size) - x.begin());
  if (not_above == 0)
    return 0;
  const std::size_t j = not_above - 1;
  if (x[j] == size || j == g.classes() || g.mass(j) == 0)
    return j;
  throw InputError(fmt::format("there is no sieve of {} for {}, and mass between {} and {} of which nothing "
                               "says where it lies: choose one of these, or sieve there",
                               shown(size, g.unit()), where, shown(x[j], g.unit()),
                               shown(x[j + 1], g.unit())));
}

Rational mass_of(const Gradation &g, std::size_t from, std::size_t to) {
  const auto begin = g.masses().begin();
  return sum({begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(to)});
}

} // namespace mdm
