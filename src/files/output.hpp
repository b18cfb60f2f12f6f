#pragma once
/// \file
/// Checked writes: no file is left half written.

#include "files/digest.hpp"
#include "files/zstd_stream.hpp"

#include <mdm/text/error.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace mdm {

/// Removes what runs that were killed have left beside the target of an Output. Nobody else may be writing
/// it.
void remove_leftovers(const std::string &path);

/// Removes what Outputs have written beside their targets, before the run ends on the spot.
void remove_unfinished();

/// Ends of the run by signals (SIGINT, SIGTERM, SIGHUP, SIGABRT) first call remove_unfinished(). Call once,
/// before the first Output.
void remove_unfinished_at_signals();

/// What a write throws where the reader of standard output has gone.
struct ClosedPipe : InputError {
  using InputError::InputError;
};

/// The place of a result. A regular file or a new path is written beside and takes its name in commit();
/// without commit nothing is left of it. Standard output (path `-`), devices and pipes are written in place.
/// What ends in .zst is compressed.
class Output {
public:
  /// \throws InputError if the path cannot be written
  explicit Output(std::string path);
  ~Output();
  Output(const Output &) = delete;
  Output &operator=(const Output &) = delete;

  /// \throws ClosedPipe, or another InputError if not all of it can be written
  void write(std::string_view text);
  /// Keeps the digest of the bytes as they lie in the file. Call before anything is written.
  /// \throws InputError if there is no libcrypto
  void keep_digest() { digest_.emplace(); }
  /// Makes what was written final. \throws InputError if that fails
  void commit();
  /// The same, when all of it is on the disk.
  void commit_durably();
  /// That of all that was committed. \pre keep_digest()
  Digest &digest() { return *digest_; }

private:
  [[noreturn]] void fail(int error) const;
  void open_beside();
  void compress(std::string_view text);
  void write_bytes(std::string_view bytes);
  void end();

  std::string path_;      // as the user gave it
  std::string target_;    // behind symbolic links
  std::string temporary_; // empty: written in place
  std::string waiting_;   // to be written with more
  std::optional<Compressor> compressor_;
  std::optional<Digest> digest_;
  int descriptor_ = -1;
};

/// Writes a text as a whole output. \throws as Output does
void write_output(const std::string &path, std::string_view text);

} // namespace mdm
