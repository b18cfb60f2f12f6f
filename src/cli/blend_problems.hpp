#pragma once
/// \file
/// mdm blend of many problems.

#include "ask/blend.hpp"
#include "cli/output_flags.hpp"

namespace mdm::cli {

/// Solves the problems in the lines of a file, an answer each in the same order; a line that is none is an
/// error in its place. \param search  when each search is to end, and what it is to find
/// \return the exit code of the worst
int blend_problems(const std::string &path, const BlendTexts &search, unsigned threads,
                   const OutputFlags &output);

} // namespace mdm::cli
