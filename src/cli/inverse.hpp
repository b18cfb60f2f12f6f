#pragma once
/// \file
/// `mdm generate --cu --cc`, and `--fit`.

#include "cli/accessible.hpp"
#include "sets/inverse_model.hpp"

namespace mdm::cli {

/// Finds and reports the shapes; the exit code: 1 if there is none at any span, 3 if something is not
/// certain.
int run_inverse(const InverseTask &task, const OutputFlags &output, const AccessibleFlags &flags);

} // namespace mdm::cli
