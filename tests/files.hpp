#pragma once
/// \file
/// Files that tests read and write.

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace mdm_test {

std::string read_file(const std::filesystem::path &path);

/// The number of lines that end in the file.
std::ptrdiff_t line_count(const std::filesystem::path &path);

/// A new folder that is gone with the object.
class TemporaryFolder {
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;

  const std::filesystem::path &path() const { return path_; }
  std::string operator/(const std::string &name) const;
  std::string write(const std::string &name, const std::string &text) const;
  std::size_t entries() const;

private:
  std::filesystem::path path_;
};

} // namespace mdm_test
