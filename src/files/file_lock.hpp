#pragma once
/// \file
/// Keeps two runs from writing the same files.

#include <string>

namespace mdm {

/// A file that is there while a run has it locked; the lock ends with the process, however that ends. On file
/// systems without locks it keeps nobody out.
class FileLock {
public:
  /// \throws InputError if another run has the lock, or there can be no such file
  explicit FileLock(std::string path);
  ~FileLock();
  FileLock(const FileLock &) = delete;
  FileLock &operator=(const FileLock &) = delete;

private:
  bool is_at_path() const;

  std::string path_;
  int descriptor_ = -1;
};

} // namespace mdm
