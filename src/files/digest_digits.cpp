#include "files/digest.hpp"

#include <fmt/format.h>

namespace mdm {

std::string Digest::sha256() {
  std::string digits;
  for (const unsigned char byte : hash())
    digits += fmt::format("{:02x}", byte);
  return digits;
}

} // namespace mdm
