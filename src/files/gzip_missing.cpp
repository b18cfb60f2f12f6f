// Files that end in .gz, of a program that was built without zlib.
#include "files/unpacker.hpp"

#include <mdm/text/error.hpp>

namespace mdm {

std::unique_ptr<Unpacker> gzip_unpacker() {
  throw InputError(
      "this mdm was built without zlib and does not read .gz: use gunzip, or build mdm with Debian's "
      "zlib1g-dev");
}

} // namespace mdm
