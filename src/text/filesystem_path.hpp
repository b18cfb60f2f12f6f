#pragma once
/// \file
/// Names of files as paths of std::filesystem. A name is UTF-8 on every system; Windows would take each byte
/// of a plain std::string for a letter of its own.

#include <filesystem>
#include <string>

namespace mdm {

/// The path that a name means. Where the system's names are bytes, these are the bytes of the name.
std::filesystem::path filesystem_path(const std::string &name);

/// The name of a path.
std::string path_name(const std::filesystem::path &path);

} // namespace mdm
