#include "files/open_files.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {

void allow_open_files(std::size_t shards) {
  constexpr std::size_t most = 2048;          // of the C library
  const std::size_t needed = 2 * shards + 20; // and those of the program itself
  if (needed > most)
    throw InputError(
        fmt::format("mdm: {} shards are up to {} open files, and Windows allows {}: solve the suite in "
                    "fewer shards",
                    shards, needed, most));
}

} // namespace mdm
