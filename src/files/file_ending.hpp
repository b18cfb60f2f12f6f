#pragma once
/// \file
/// What the ending of a file's name says of its format.

#include <string>
#include <vector>

namespace mdm {

/// The ending in small letters and without its dot, of `a.json.zst` json; empty if there is none.
std::string ending_of(const std::string &path);

/// The endings of tables and of other text.
extern const std::vector<std::string> text_endings;

/// Refuses a path whose ending is that of a known format, but none of `own`: an ending that stands for none,
/// such as `.out`, is taken.
/// \param command whose result it is, \param remedy completes the message, such as `, or give --format`
/// \throws InputError that names the endings of `own`
void check_ending(const std::string &path, const std::vector<std::string> &own, const std::string &command,
                  const std::string &remedy);

} // namespace mdm
