#pragma once
/// \file
/// The files of judge/specifications, which the build puts into the library.

#include <string_view>
#include <vector>

namespace mdm {

/// A file of that folder.
struct ShippedFile {
  std::string_view name; ///< without its ending
  std::string_view content;
};

/// All of them, by name.
const std::vector<ShippedFile> &shipped_files();

} // namespace mdm
