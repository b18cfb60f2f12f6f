#include "files/unpacker.hpp"

#include "files/zstd_stream.hpp"

namespace mdm {

std::unique_ptr<Unpacker> unpacker_of(std::string_view path) {
  if (names_zstd(path))
    return zstd_unpacker();
  return path.ends_with(".gz") ? gzip_unpacker() : nullptr;
}

} // namespace mdm
