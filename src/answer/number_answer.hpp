#pragma once
/// \file
/// The answer about a gradation by number.

#include "match/number_match.hpp"

#include <string>
#include <vector>

namespace mdm {

/// A gradation by number with what was asked of it and what was found.
struct NumberAnswer {
  Gradation gradation;
  std::vector<AskedTolerance> asked;
  NumberMatch match;
  std::vector<std::string> notes;
};

/// One sentence: how many particles, and whether fewer may do.
std::string headline(const NumberAnswer &a);
std::string number_text(const NumberAnswer &a);
/// The schema mdm-number-1.
std::string number_json(const NumberAnswer &a);
std::string number_csv(const NumberAnswer &a);

} // namespace mdm
