#pragma once

#include <memory>
#include <string_view>

namespace mdm::checker {

/// Unpacks what zstd compressed, in memory that does not grow with it: at most 128 MiB.
class Unpacker {
public:
  /// Throws std::runtime_error if the program was built without libzstd.
  Unpacker();
  ~Unpacker();

  /// Some of the text, until the next call, which may be empty; takes what it used off `packed`. Throws
  /// std::runtime_error where that is not what zstd compressed.
  std::string_view unpack(std::string_view &packed);
  /// What was unpacked so far is whole.
  bool is_whole() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace mdm::checker
