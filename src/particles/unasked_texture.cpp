#include "particles/unasked_texture.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {

std::optional<SphereTexture> unasked_texture(const PlacedSink &placed, std::size_t classes,
                                             const SphereTextureOptions &options, const char *asking,
                                             std::vector<std::string> &notes) {
  if (placed.has_too_many())
    notes.push_back(
        fmt::format("There are more than {} places: {} judges them.", most_unasked_places, asking));
  if (!placed.odd().empty())
    notes.push_back(fmt::format("The places were not judged: one {}.", placed.odd()));
  if (!placed.has_all())
    return std::nullopt;
  if (placed.sample().is_of_discs()) {
    notes.emplace_back("The places were not judged: all centres are in a plane, as of discs.");
    return std::nullopt;
  }
  try {
    return sphere_texture(placed.sample(), classes, options);
  } catch (const InputError &error) {
    notes.push_back(fmt::format("The places were not judged: {}.", error.what()));
    return std::nullopt;
  }
}

} // namespace mdm
