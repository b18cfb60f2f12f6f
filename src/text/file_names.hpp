#pragma once
/// \file
/// Names of files, and how messages name them.

#include <mdm/text/error.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace mdm {

/// Where in a path the name of its file begins, behind all folders.
std::size_t name_begin(std::string_view path);
/// A path as messages name it: `stdin` for `-`.
std::string shown_name(const std::string &path);
/// A path as a word of a command in a message, for sh: in single quotes, unless it is of letters, digits and
/// `/._-+` alone; one that begins with a hyphen has `./` before it.
std::string shell_word(const std::string &path);
/// A line of a file as messages name it: `stdin:3`.
std::string line_name(const std::string &path, std::uint64_t line);

/// The error `path: what`.
InputError file_error(const std::string &path, const std::string &what);
/// Calls action() and names the file, or the line of it, in what it throws.
template <class Action>
auto in_file(const std::string &path, Action action) {
  try {
    return action();
  } catch (const InputError &e) {
    throw file_error(path, e.what());
  }
}

} // namespace mdm
