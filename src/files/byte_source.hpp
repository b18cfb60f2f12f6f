#pragma once
/// \file
/// The bytes of a file, as they come in.

#include "files/digest.hpp"
#include "files/unpacker.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace mdm {

/// A file, or standard input for `-`. What ends in .zst or .gz is unpacked.
class ByteSource {
public:
  /// \throws InputError if it cannot be read, or is packed and there is no library that unpacks it
  explicit ByteSource(std::string path);
  ~ByteSource();
  ByteSource(const ByteSource &) = delete;
  ByteSource &operator=(const ByteSource &) = delete;

  const std::string &path() const { return path_; }

  /// Appends what comes next, at most 128 KiB; false at the end.
  /// \throws InputError if it cannot be read or unpacked
  bool read_some(std::string &text);

  /// Keeps the digest of the bytes as they lie in the file. Call before anything is read.
  /// \throws InputError if there is no libcrypto
  void keep_digest() { digest_.emplace(); }
  /// That of all that was read. \pre keep_digest()
  Digest &digest() { return *digest_; }

private:
  bool read_raw(std::string &text);
  bool unpack_some(std::string &text);

  std::string path_;
  int descriptor_ = -1;
  std::optional<Digest> digest_;
  std::unique_ptr<Unpacker> unpacker_; ///< null: nothing is packed
  std::string packed_;
  std::size_t unpacked_ = 0; ///< of packed_
};

/// Content of a file, or of standard input for `-`.
/// \throws InputError if it cannot be read or has more than `most` bytes
std::string read_file(const std::string &path, std::size_t most);

/// The first bytes of a file, at most so many; none of one that cannot be read, or of standard input.
std::string beginning_of_file(const std::string &path, std::size_t most);

} // namespace mdm
