#pragma once
/// \file
/// What is said of a run over many that Ctrl-C ended.

#include "number/counted.hpp"

#include <string>

namespace mdm::cli {

/// `the run was interrupted after 2 gradations: the others are left out`.
inline std::string interrupted_after(const Integer &n, const std::string &one) {
  return "the run was interrupted after " + counted(n, one) + ": the others are left out";
}

} // namespace mdm::cli
