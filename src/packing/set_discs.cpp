#include "packing/set_discs.hpp"

#include <mdm/text/error.hpp>

namespace mdm {

DiscSizes set_discs(const ParticlesOf &particles, std::size_t classes, const std::string &unit) {
  DiscSizes discs;
  discs.unit = unit;
  for (std::size_t j = 0; j < classes; ++j)
    particles(j, [&discs](const Enclosure &size, const Integer &count) {
      if (count > most_discs)
        throw InputError("more than 10^7 discs: ask for fewer");
      discs.add(size, static_cast<std::uint64_t>(count));
    });
  return discs;
}

} // namespace mdm
