#pragma once
/// \file
/// Packings judged by mdm verify.

#include "cli/output_flags.hpp"

namespace mdm::cli {

/// Writes the verdict on a packing of these sizes, and what is known of it; gives the exit code.
int verify_packing(const std::string &sizes, const std::string &packing, const OutputFlags &output);

} // namespace mdm::cli
