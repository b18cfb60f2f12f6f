// Files that end in .zst, of a program that was built without libzstd.
#include "files/unpacker.hpp"
#include "files/zstd_stream.hpp"

#include <mdm/text/error.hpp>

namespace mdm {
namespace {

[[noreturn]] void refuse_zstd() {
  throw InputError(
      "this mdm was built without libzstd and neither reads nor writes .zst: use zstd, or build mdm "
      "with Debian's libzstd-dev");
}

} // namespace

bool names_zstd(std::string_view path) {
  return path.ends_with(".zst");
}

struct Compressor::State {};
Compressor::Compressor() {
  refuse_zstd();
}
Compressor::~Compressor() = default;
void Compressor::add(std::string_view, const Sink &) {}
void Compressor::end(const Sink &) {}

std::unique_ptr<Unpacker> zstd_unpacker() {
  refuse_zstd();
}

} // namespace mdm
