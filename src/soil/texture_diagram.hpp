#pragma once
/// \file
/// The triangles in which textures are read off: their lines, and the names between them.

#include "soil/texture.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace mdm {

/// A place of a triangle: the three parts in the order of texture_parts(), in percent; they add up to 100.
using TexturePlace = std::array<double, 3>;

/// A field of a diagram.
struct TextureField {
  std::string_view name;  ///< as texture() says it
  std::string_view label; ///< as it is written into the field, short where there is little room
  TexturePlace at;        ///< of the label, inside of the field
};

/// A triangle with the first part at the lower left, the second at the lower right, and the third at the top.
struct TextureDiagram {
  std::array<std::string_view, 3> parts;          ///< their names
  std::vector<std::array<TexturePlace, 2>> lines; ///< between the fields, from place to place
  std::vector<TextureField> fields;               ///< every name of the system, once
};

/// For drawing: names are decided by texture(), whatever the width of a line.
const TextureDiagram &texture_diagram(TextureSystem system);

} // namespace mdm
