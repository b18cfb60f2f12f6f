#include "files/unpacker.hpp"

#include "files/zstd_stream.hpp"

namespace mdm {
namespace {

// RFC 1952, 2.3.1; RFC 8878, 3.1.1.
constexpr std::string_view gzip = "\x1f\x8b", zstd = "\x28\xb5\x2f\xfd";

} // namespace

bool is_packed(std::string_view begin) {
  return begin.starts_with(gzip) || begin.starts_with(zstd);
}

std::unique_ptr<Unpacker> unpacker_of(std::string_view begin, std::string_view path) {
  if (begin.starts_with(zstd))
    return zstd_unpacker();
  if (begin.starts_with(gzip))
    return gzip_unpacker();
  if (names_zstd(path))
    return zstd_unpacker();
  return path.ends_with(".gz") ? gzip_unpacker() : nullptr;
}

} // namespace mdm
