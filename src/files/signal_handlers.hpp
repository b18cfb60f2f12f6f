#pragma once
/// \file
/// Which signals end a run, as each system has them.

namespace mdm {

/// Lets the handler take the signals that end a run, but those that are ignored.
void handle_ending_signals(void (*handler)(int));

} // namespace mdm
