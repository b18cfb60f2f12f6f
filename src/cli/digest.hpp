#pragma once
/// \file
/// The SHA-256 of a file, as sha256sum prints it.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace mdm::cli {

/// The SHA-256 and the number of the bytes that it is given.
class Digest {
public:
  /// \throws InputError if the program was built without libcrypto
  Digest();
  ~Digest();
  Digest(Digest &&) noexcept;

  void add(std::string_view bytes);
  std::uint64_t bytes() const { return bytes_; }
  /// In 64 hexadecimal digits. Nothing is added afterwards.
  std::string sha256();

private:
  struct State;
  std::unique_ptr<State> state_;
  std::uint64_t bytes_ = 0;
};

} // namespace mdm::cli
