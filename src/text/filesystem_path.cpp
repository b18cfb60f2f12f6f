#include "text/filesystem_path.hpp"

namespace mdm {

std::filesystem::path filesystem_path(const std::string &name) {
  return {std::u8string(name.begin(), name.end())};
}

std::string path_name(const std::filesystem::path &path) {
  const std::u8string name = path.u8string();
  return {name.begin(), name.end()};
}

} // namespace mdm
