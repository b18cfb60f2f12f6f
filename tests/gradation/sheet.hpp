#pragma once
/// \file
/// A sheet of a laboratory to which tests add what they are about.

#include "support.hpp"

namespace mdm::test {

inline const std::string header = "Sieve (mm),Mass retained (g)\n", rows = "4,0\n2,300\n1,130\n";

inline std::string masses(const std::string &sheet) {
  return text(read(sheet).masses());
}

} // namespace mdm::test
