#include "files.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace mdm_test {

std::string read_file(const std::filesystem::path &path) {
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::ptrdiff_t line_count(const std::filesystem::path &path) {
  const std::string text = read_file(path);
  return std::count(text.begin(), text.end(), '\n');
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "mdm-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("cannot make " + name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::operator/(const std::string &name) const {
  return (path_ / name).string();
}

std::string TemporaryFolder::write(const std::string &name, const std::string &text) const {
  std::ofstream file(path_ / name, std::ios::binary);
  file << text;
  if (!file.flush())
    throw std::runtime_error("cannot write " + name);
  return *this / name;
}

std::size_t TemporaryFolder::entries() const {
  const std::filesystem::directory_iterator all(path_);
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

} // namespace mdm_test
