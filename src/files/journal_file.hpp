#pragma once
/// \file
/// A file that keeps what a run has done so far, line by line.

#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace mdm {

/// Lines of JSON objects, each written as a whole; of one run at a time.
class JournalFile {
public:
  /// Opens or makes the file. \throws InputError if that fails, it is no regular file, or another run has it
  /// open
  explicit JournalFile(std::string path);
  ~JournalFile();
  JournalFile(const JournalFile &) = delete;
  JournalFile &operator=(const JournalFile &) = delete;

  const std::string &path() const { return path_; }

  /// Hands on the lines with their numbers, from 1. A last line without its end, of a run that was killed
  /// while writing, is dropped from the file.
  /// \param no_journal the message for a file that has no such lines
  void read(const std::function<void(std::string_view line, std::size_t number)> &take,
            const std::string &no_journal);
  /// Adds a line; several threads may. \throws InputError if it cannot be written
  void add(const std::string &line);

private:
  [[noreturn]] void fail(int error) const;

  std::string path_;
  int descriptor_ = -1;
  std::mutex mutex_; ///< of the file
};

} // namespace mdm
