#pragma once
/// \file
/// What file a path means.

#include <string>

namespace mdm {

/// The absolute path of a file, without symbolic links; nothing where there is no such file.
std::string real_path(const std::string &path);

/// True of a pipe or a socket that has a name.
bool is_named_pipe(const std::string &path);

} // namespace mdm
