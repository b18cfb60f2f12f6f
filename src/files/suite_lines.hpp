#pragma once
/// \file
/// A suite as a whole.

#include "files/file_lines.hpp"

#include <mdm/gradation/gradation.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace mdm {

/// A gradation in a line of a suite.
struct SuiteLine {
  std::uint64_t line; ///< from 1 on
  Gradation gradation;
};

/// All of a suite, so that nothing is run or written where a line is bad. A gradation without an id has
/// the number of its line.
/// \param path  names it
/// \throws InputError naming the line, or if there is no gradation
std::vector<SuiteLine> read_suite(FileLines &lines, const std::string &path);

} // namespace mdm
