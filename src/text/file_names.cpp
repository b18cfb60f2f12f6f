#include "text/file_names.hpp"

#include <algorithm>
#include <filesystem>

namespace mdm {

std::size_t name_begin(std::string_view path) {
  constexpr char separators[] = {'/', static_cast<char>(std::filesystem::path::preferred_separator)};
  return path.find_last_of(separators, std::string_view::npos, sizeof separators) +
         1; // 0 where there is none
}

std::string shown_name(const std::string &path) {
  return path == "-" ? "stdin" : path;
}

std::string shell_word(const std::string &path) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("/._-+").find(c) != std::string_view::npos;
  };
  if (path.size() > 1 && path.front() == '-') // else it would be an option
    return shell_word("./" + path);
  if (!path.empty() && std::all_of(path.begin(), path.end(), is_plain))
    return path;
  std::string word = "'";
  for (const char c : path)
    word += c == '\'' ? "'\\''" : std::string(1, c);
  return printable(word + "'");
}

std::string line_name(const std::string &path, std::uint64_t line) {
  return shown_name(path) + ":" + std::to_string(line);
}

InputError file_error(const std::string &path, const std::string &what) {
  return InputError((path.empty() ? "''" : printable(shown_name(path))) + ": " + what);
}

} // namespace mdm
