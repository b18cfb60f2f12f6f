#pragma once
/// \file
/// Compression by Zstandard, of files whose names end in .zst.

#include "text/sink.hpp"

#include <memory>
#include <string>
#include <string_view>

namespace mdm {

bool names_zstd(std::string_view path);

/// Compresses a text. The level is 1: it costs a tenth of what solving costs, and of answers and proofs it
/// leaves less than levels 2 to 5 do (tests/benchmark/README.md). The same text gives the same bytes.
class Compressor {
public:
  /// \throws InputError if the program was built without libzstd
  Compressor();
  ~Compressor();

  /// Hands on what is compressed so far.
  void add(std::string_view text, const Sink &to);
  /// Hands on the rest.
  void end(const Sink &to);

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace mdm
