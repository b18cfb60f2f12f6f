#include "cli/packing_file.hpp"

#include "cli/files.hpp"

#include <mdm/packing/packing_reader.hpp>

#include <fstream>

namespace mdm::cli {
namespace {

/// The first bytes of a file; none of one that cannot be read, or of standard input.
std::string beginning(const std::string &path) {
  constexpr std::size_t looked_at = 256;
  if (path == "-")
    return "";
  std::string begin(looked_at, ' ');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), looked_at);
  begin.resize(static_cast<std::size_t>(file.gcount()));
  return begin;
}

} // namespace

bool is_packing_file(const std::string &path) {
  return is_packing(beginning(path));
}

bool is_disc_sizes_file(const std::string &path) {
  return has_disc_sizes(beginning(path));
}

Packing read_packing_file(const std::string &path) {
  return read_packing(read_file(path, most_packing_bytes), shown_name(path));
}

DiscSizes read_disc_sizes_file(const std::string &path) {
  return read_disc_sizes(read_file(path, most_packing_bytes), shown_name(path));
}

} // namespace mdm::cli
