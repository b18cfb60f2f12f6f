#pragma once

#include <cstdlib>

/// Whether the longest tests are to take all of their cases, as in tests/run --release; else they take some
/// of them.
inline bool takes_all_cases() {
  return std::getenv("MDM_ALL_CASES") != nullptr;
}
