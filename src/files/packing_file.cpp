#include "files/packing_file.hpp"

#include "files/byte_source.hpp"
#include "files/paths.hpp"
#include "packing/packing_reader.hpp"

namespace mdm {
namespace {

constexpr std::size_t looked_at = 256;

} // namespace

bool is_packing_file(const std::string &path) {
  return is_packing(beginning_of_file(path, looked_at));
}

bool is_disc_sizes_file(const std::string &path) {
  return has_disc_sizes(beginning_of_file(path, looked_at));
}

Packing read_packing_file(const std::string &path) {
  return read_packing(read_file(path, most_packing_bytes), shown_name(path));
}

DiscSizes read_disc_sizes_file(const std::string &path) {
  return read_disc_sizes(read_file(path, most_packing_bytes), shown_name(path));
}

} // namespace mdm
