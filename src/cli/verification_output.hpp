#pragma once
/// \file
/// What commands that verify a sample write.

#include "cli/output_flags.hpp"
#include "files/output.hpp"
#include "report/verification.hpp"

namespace mdm::cli {

/// Writes the report as the flags ask; beside CSV, which has no place for them, the verdict and the notes are
/// told.
void write_verification(const Verification &v, const OutputFlags &flags, Output &out);

} // namespace mdm::cli
