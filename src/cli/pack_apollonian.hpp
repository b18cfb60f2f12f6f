#pragma once
/// \file
/// The Apollonian packings of mdm pack.

#include "ask/pack.hpp"
#include "cli/output_flags.hpp"

namespace mdm::cli {

/// Counts, writes or describes a gasket. \param output its `-o` is for the packing, beside the report
int run_apollonian(const PackTexts &asked, const OutputFlags &output);

} // namespace mdm::cli
