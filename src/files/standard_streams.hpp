#pragma once
/// \file
/// Standard input, output and error as the program finds them.

#include <string_view>

namespace mdm {

/// Opens what of standard input, output and error is closed, so that no file of ours gets its number: reading
/// the first and writing the second fail as they should, messages go nowhere. Call first.
void occupy_standard_streams();

/// A closed pipe and a limit of the file size are then errors of write, not ends of the run by a signal.
void let_writes_fail();

/// Writes a text to standard error. Where that cannot be, there is nobody to tell.
void tell(std::string_view text);

/// The message of a run that memory ends.
inline constexpr const char *out_of_memory_message =
    "mdm: out of memory: give it more, or ask for fewer particles, steps or digits";

} // namespace mdm
