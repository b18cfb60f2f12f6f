#pragma once
/// \file
/// The SHA-256 of a file, as sha256sum prints it.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace mdm {

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
  /// The same as bytes; what is added afterwards is of a new one.
  std::array<unsigned char, 32> take();

private:
  std::array<unsigned char, 32> hash();

  struct State;
  std::unique_ptr<State> state_;
  std::uint64_t bytes_ = 0;
};

} // namespace mdm
