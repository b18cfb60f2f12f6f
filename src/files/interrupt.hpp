#pragma once
/// \file
/// Ctrl-C as the wish to end a search.

namespace mdm {

/// While one is there, the first SIGINT does not end the program but is noted; a second one ends it. Where
/// SIGINT is ignored, it stays so. One at a time.
class Interrupt {
public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt &) = delete;
  Interrupt &operator=(const Interrupt &) = delete;

  /// True if SIGINT came since the last one was made.
  static bool was_pressed();
};

} // namespace mdm
