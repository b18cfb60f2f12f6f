#include "files/paths.hpp"

#include "files/real_path.hpp"
#include "text/filesystem_path.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>

namespace mdm {
namespace {

/// The end of a path's symbolic links where there is no such file yet.
std::string behind_links(const std::string &name) {
  constexpr int most = 40; // as the kernel
  std::filesystem::path path = filesystem_path(name);
  for (int i = 0; i < most; ++i) {
    std::error_code no_link;
    const std::filesystem::path target = std::filesystem::read_symlink(path, no_link);
    if (no_link)
      break;
    path = path.parent_path() / target;
  }
  return path_name(path);
}

bool is_regular_file(const std::string &path) {
  struct stat status {};
  return path != "-" && stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

/// The canonical paths of the inputs that no output may take.
std::set<std::string> protected_inputs;

[[noreturn]] void would_be_overwritten(const std::string &path) {
  throw file_error(path, "would be overwritten: give input and outputs different names");
}

} // namespace

void refuse_file(const std::string &path, const std::string &what, int error, const std::string &remedy) {
  throw file_error(path, what + ": " + std::strerror(error) + ": " + remedy);
}

int errno_of(const std::error_code &error) {
  return error.default_error_condition().value();
}

void cannot_read(const std::string &path, int error) {
  refuse_file(path, "cannot be read", error, "name one that can be read");
}

std::string canonical_path(const std::string &path) {
  if (std::string file = real_path(path); !file.empty())
    return file;
  const std::string name = behind_links(path);
  const std::size_t begin = name_begin(name);
  const std::string folder = real_path(begin == 0 ? "." : name.substr(0, begin));
  return folder.empty() ? name : folder + "/" + name.substr(begin);
}

void check_paths(const std::vector<std::string> &inputs, const std::vector<std::string> &outputs) {
  if (std::count(inputs.begin(), inputs.end(), "-") > 1)
    throw InputError("-: standard input is one file: give the others by name");
  std::for_each(outputs.begin(), outputs.end(), refuse_protected);
  for (const std::string &input : inputs) {
    std::vector<std::string> paths = outputs;
    paths.insert(paths.begin(), input);
    check_distinct(paths);
  }
}

void protect_input(const std::string &path) {
  if (is_regular_file(path))
    protected_inputs.insert(canonical_path(path));
}

void refuse_protected(const std::string &path) {
  if (!protected_inputs.empty() && is_regular_file(path) && protected_inputs.count(canonical_path(path)) != 0)
    would_be_overwritten(path);
}

void check_readable(const std::string &path) {
  struct stat status {};
  if (path == "-")
    return;
  if (access(path.c_str(), R_OK) != 0 || stat(path.c_str(), &status) != 0)
    cannot_read(path, errno);
  if (S_ISDIR(status.st_mode))
    cannot_read(path, EISDIR);
}

std::optional<std::uint64_t> file_bytes(const std::string &path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
    return std::nullopt;
  return static_cast<std::uint64_t>(status.st_size);
}

void check_size(const std::string &path, std::size_t bytes, std::size_t most) {
  if (bytes > most)
    throw file_error(path, fmt::format("more than {} MiB: is it the right file?", most >> 20));
}

bool is_stream(const std::string &path) {
  struct stat status {};
  return path == "-" || (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode));
}

void make_folder(const std::string &path) {
  std::error_code error;
  std::filesystem::create_directory(filesystem_path(path), error);
  if (error)
    refuse_file(path, "no folder can be made there", errno_of(error), "name another");
}

bool has_file(const std::string &folder, std::string_view ending) {
  std::error_code unreadable; // what is written there is refused later
  const std::filesystem::directory_iterator entries(filesystem_path(folder), unreadable);
  return std::any_of(begin(entries), end(entries), [ending](const std::filesystem::directory_entry &entry) {
    return path_name(entry.path()).ends_with(ending);
  });
}

void check_distinct(const std::vector<std::string> &paths) {
  std::set<std::string> seen;
  for (const std::string &path : paths) {
    if (is_stream(path))
      continue;
    if (!seen.insert(canonical_path(path)).second)
      would_be_overwritten(path);
  }
}

} // namespace mdm
