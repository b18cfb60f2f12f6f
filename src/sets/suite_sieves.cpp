#include "sets/suite_sieves.hpp"

#include "number/power_product.hpp"

#include <mdm/number/decimal.hpp>

namespace mdm {

std::vector<Rational> drawn_openings(const ListedSieves &sieves, std::uint32_t classes,
                                     RandomStream &random) {
  const auto all = static_cast<std::uint32_t>(sieves.openings.size());
  std::uint32_t wanted = classes + 1;
  if (sieves.neighbours) {
    const auto first = sieves.openings.begin() + random.below(all - classes);
    return {first, first + wanted};
  }
  // Each is taken with the probability that leaves all choices equally likely.
  std::vector<Rational> openings;
  for (std::uint32_t i = 0; i < all && wanted > 0; ++i)
    if (wanted == all - i || random.below(all - i) < wanted) {
      openings.push_back(sieves.openings[i]);
      --wanted;
    }
  return openings;
}

std::vector<Rational> drawn_openings(const GeometricSieves &sieves, std::uint32_t classes,
                                     RandomStream &random) {
  const PowerProduct from(sieves.from.drawn(random));
  const PowerProduct end(sieves.to ? sieves.to->drawn(random) : sieves.ratio->drawn(random));
  const PowerProduct step = sieves.to ? pow(end / from, ratio(1, classes)) : end;
  std::vector<Rational> openings;
  for (std::uint32_t i = 0; i <= classes; ++i)
    openings.push_back(parse_decimal(rounded((from * pow(step, i)).real(), sieves.digits)));
  return openings;
}

} // namespace mdm
