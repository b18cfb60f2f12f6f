#pragma once
/// \file
/// Standard input, output and error of mdm-check.

namespace mdm::checker {

/// What is written to them is written as it is, and a closed pipe is an error of write, no end by a signal.
/// Call first.
void settle_streams();

} // namespace mdm::checker
