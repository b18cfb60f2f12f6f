#pragma once
/// \file
/// The bytes of a file, as they come in.

#include "files/digest.hpp"
#include "files/unpacker.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace mdm {

/// A file, or standard input for `-`. What gzip or zstd packed is unpacked, as its first bytes tell. A pipe,
/// and standard input, is read once, but for what beginning_of_file looks at.
class ByteSource {
public:
  /// \throws InputError if it cannot be read, or is a pipe that was read before
  explicit ByteSource(std::string path);
  ~ByteSource();
  ByteSource(const ByteSource &) = delete;
  ByteSource &operator=(const ByteSource &) = delete;

  const std::string &path() const { return path_; }

  /// Appends what comes next, at most 128 KiB; false at the end.
  /// \throws InputError if it cannot be read, or unpacked by a library that there is
  bool read_some(std::string &text);

  /// Keeps the digest of the bytes as they lie in the file. Call before anything is read.
  /// \throws InputError if there is no libcrypto
  void keep_digest() { digest_.emplace(); }
  /// That of all that was read. \pre keep_digest()
  Digest &digest() { return *digest_; }

private:
  friend std::string beginning_of_file(const std::string &path, std::size_t most);

  bool read_raw(std::string &text);
  void read_descriptor(std::string &text);
  bool begin(std::string &text);
  bool unpack_some(std::string &text);
  void put_back();

  std::string path_;
  int descriptor_ = -1;
  bool is_pipe_ = false;
  std::string ahead_; ///< of a pipe, what was looked at before
  std::string raw_;   ///< of a pipe that is looked at, all that was read
  bool is_looking_ = false, has_begun_ = false;
  std::optional<Digest> digest_;
  std::unique_ptr<Unpacker> unpacker_; ///< null: nothing is packed
  std::string packed_;
  std::size_t unpacked_ = 0; ///< of packed_
};

/// Content of a file, or of standard input for `-`.
/// \throws InputError if it cannot be read or has more than `most` bytes
std::string read_file(const std::string &path, std::size_t most);

/// The first bytes of a file, at most so many; none of one that cannot be read. Of a pipe, the ByteSource
/// that comes next has them too.
std::string beginning_of_file(const std::string &path, std::size_t most);

/// True of a regular file that is not packed: programs that only know its name can read it as it is. Of
/// standard input, that what was read of it is not packed.
bool is_plain_file(const std::string &path);

} // namespace mdm
