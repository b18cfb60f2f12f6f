#pragma once
/// \file
/// Problems of blends, one a line.

#include "answer/blend_problem_reader.hpp"
#include "files/file_lines.hpp"

#include <cstdint>

namespace mdm {

/// A problem in a line of a file, or what is wrong with the line.
struct BlendLine {
  std::string where;                   ///< names it in messages
  std::string text;                    ///< the line itself
  std::string id;                      ///< the number of the line where it has none
  std::optional<BlendProblem> problem; ///< nothing where it cannot be read
  std::string error;
};

/// True if the first line has a member `stockpiles`, as no gradation has. Takes nothing.
bool begin_blends(FileLines &lines);

/// All of a file, JSON Lines; blank lines are passed over.
/// \param path  names it
/// \throws InputError if there is no problem
std::vector<BlendLine> read_blend_lines(FileLines &lines, const std::string &path);

} // namespace mdm
