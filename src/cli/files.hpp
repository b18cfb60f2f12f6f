#pragma once
/// \file
/// Input and output of the commands: bounded reads, checked writes, no file left half written.

#include "cli/byte_source.hpp"

#include <mdm/text/error.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mdm::cli {

/// Opens what of standard input, output and error is closed, so that no file of ours gets its number: reading
/// the first and writing the second fail as they should, messages go nowhere. Call first.
void occupy_standard_streams();

/// Writes a text to standard error. Where that cannot be, there is nobody to tell.
void tell(std::string_view text);

/// Content of a file, or of standard input for `-`.
/// \throws InputError if it cannot be read or has more than `most` bytes
std::string read_file(const std::string &path, std::size_t most);

/// The first bytes of a file, at most so many; none of one that cannot be read, or of standard input.
std::string beginning_of_file(const std::string &path, std::size_t most);

/// A path as messages name it: `stdin` for `-`.
std::string shown_name(const std::string &path);
/// A path as a word of a command in a message, for sh: in single quotes, unless it is of letters, digits and
/// `/._-+` alone.
std::string shell_word(const std::string &path);
/// A line of a file as messages name it: `stdin:3`.
std::string line_name(const std::string &path, std::uint64_t line);

/// The error `path: what`.
InputError file_error(const std::string &path, const std::string &what);
/// Throws the error `path: what: <the system's words>: remedy`. \param error errno
[[noreturn]] void refuse_file(const std::string &path, const std::string &what, int error,
                              const std::string &remedy);

/// The error of a file that cannot be read. \param error errno
[[noreturn]] void cannot_read(const std::string &path, int error);

/// Calls action() and names the file, or the line of it, in what it throws.
template <class Action>
auto in_file(const std::string &path, Action action) {
  try {
    return action();
  } catch (const InputError &e) {
    throw file_error(path, e.what());
  }
}

/// The absolute path without symbolic links of a file or of a file that is to be.
std::string canonical_path(const std::string &path);

/// Refuses two names of one regular file among the inputs and outputs of a command; `-` and devices do not
/// count. \throws InputError naming the second
void check_distinct(const std::vector<std::string> &paths);

/// Refuses a file that cannot be read, before any work is done. \throws InputError
void check_readable(const std::string &path);

/// The bytes of a regular file as it lies on the disk; nothing of others.
std::optional<std::uint64_t> file_bytes(const std::string &path);

/// Makes a folder where there is none.
/// \throws InputError if that cannot be
void make_folder(const std::string &path);

/// Removes what runs that were killed have left beside the target of an Output. Nobody else may be writing
/// it.
void remove_leftovers(const std::string &path);

/// Removes what Outputs have written beside their targets, before the run ends on the spot.
void remove_unfinished();

/// Ends of the run by signals (SIGINT, SIGTERM, SIGHUP, SIGABRT) first call remove_unfinished(). Call once,
/// before the first Output.
void remove_unfinished_at_signals();

/// The message of a run that memory ends.
inline constexpr const char *out_of_memory_message =
    "mdm: out of memory: give it more, or ask for fewer particles, steps or digits";

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

/// Lines of a file or of standard input, as they come in and in bounded memory. A pipe is read once: who
/// looks at its beginning can take the rest as lines or as one text.
class FileLines {
public:
  explicit FileLines(const std::string &path) : bytes_(path) {}

  /// For its digest.
  ByteSource &bytes() { return bytes_; }

  /// A line without its end; nothing of a line that was longer than `longest_line`.
  using Line = std::optional<std::string>;
  static constexpr std::size_t longest_line = std::size_t{64} << 20;
  /// The mistake of `what` that is longer, such as `the line`.
  static std::string too_long(const std::string &what);

  /// The beginning of what is not taken yet, after one more read; at the end of the input all of it.
  std::string_view look_further();
  bool is_at_end() const { return at_end_; }
  /// What is not taken yet, to the end of the input.
  /// \throws InputError if it has more than `most` bytes
  std::string rest(std::size_t most);

  /// The lines that are there, at least one and at most `most`; waits only for the first. Empty at the end of
  /// the input.
  std::vector<Line> next(std::size_t most);

private:
  void fill();
  bool take_line(std::vector<Line> &lines);

  ByteSource bytes_;
  std::string buffer_;
  std::size_t taken_ = 0;    // of the buffer
  std::size_t searched_ = 0; // no line end before it
  bool skipping_ = false;    // inside a line that is too long
  bool at_end_ = false;
};

} // namespace mdm::cli
