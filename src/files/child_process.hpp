#pragma once
/// \file
/// A program of the user's, run with what bounds it needs.

#include <chrono>
#include <string>
#include <string_view>

namespace mdm {

/// The end of a program and its output.
struct ChildEnd {
  enum class How { exited, signalled, timed_out, too_much_output };
  How how = How::exited;
  int code = 0;           ///< exit code, or number of the signal
  std::string output;     ///< its standard output
  std::string last_error; ///< the last line of its standard error, cut to some kilobytes
};

/// Runs `/bin/sh -c command` with `input` on its standard input, as a process group of its own, until it ends
/// by itself, the time limit is over, or it has written more than `most_output` bytes. Whatever of the group
/// is left then is killed; children that it leaves behind are not waited for, even with its pipes open. What
/// it does not read of its input is no error. Several threads may run programs at once. SIGINT, SIGTERM and
/// SIGHUP, which end this program, first kill those that run; where SIGKILL ends it, the kernel ends their
/// shells, not what these have started.
/// \throws InputError if no program can be started
ChildEnd run_child(const std::string &command, std::string_view input, std::chrono::milliseconds time_limit,
                   std::size_t most_output);

} // namespace mdm
