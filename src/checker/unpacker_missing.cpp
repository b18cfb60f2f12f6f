// What zstd compressed, of a program that was built without libzstd.
#include "unpacker.hpp"

#include <stdexcept>

namespace mdm::checker {

struct Unpacker::State {};
Unpacker::Unpacker() {
  throw std::runtime_error(
      "this mdm-check was built without libzstd and reads no .zst: unpack it with zstd -d");
}
Unpacker::~Unpacker() = default;
std::string_view Unpacker::unpack(std::string_view &) {
  return {};
}
bool Unpacker::is_whole() const {
  return false;
}

} // namespace mdm::checker
