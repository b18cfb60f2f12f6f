#include "gradation/sample.hpp"

#include "gradation/shown.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {

Sample::Sample(std::vector<Rational> sizes, std::vector<Integer> quantities)
    : sizes_(std::move(sizes)), quantities_(std::move(quantities)) {
  if (sizes_.size() != quantities_.size())
    throw InputError(fmt::format("a sample needs a quantity for each size: there are {} and {}",
                                 quantities_.size(), sizes_.size()));
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    if (sizes_[i] <= 0)
      throw InputError(fmt::format("particle size {} is not above 0", shown(sizes_[i])));
    if (i > 0 && sizes_[i] <= sizes_[i - 1])
      throw InputError(fmt::format("particle size {} does not ascend", shown(sizes_[i])));
    if (quantities_[i] < 1)
      throw InputError(fmt::format("the quantity of size {} is not 1 or more", shown(sizes_[i])));
  }
}

Integer Sample::particles() const {
  Integer sum = 0;
  for (const Integer &q : quantities_)
    sum += q;
  return sum;
}

} // namespace mdm
