#pragma once
/// \file
/// Actions at the signals that end the program.

namespace mdm {

/// Lets SIGINT, SIGTERM, SIGHUP and SIGABRT call `action` before they end the program, where they are not
/// ignored; it may do only what a handler of signals may. Actions may be added in any order and at any time,
/// by one thread at once; there is room for a few.
void before_ending_signals(void (*action)());

} // namespace mdm
