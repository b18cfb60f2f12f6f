#pragma once
/// \file
/// Paths of files.

#include "text/file_names.hpp"

#include <mdm/text/error.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace mdm {

/// Throws the error `path: what: <the system's words>: remedy`. \param error errno
[[noreturn]] void refuse_file(const std::string &path, const std::string &what, int error,
                              const std::string &remedy);

/// What errno would say of an error of std::filesystem.
int errno_of(const std::error_code &error);

/// The error of a file that cannot be read. \param error errno
[[noreturn]] void cannot_read(const std::string &path, int error);

/// The absolute path without symbolic links of a file or of a file that is to be.
std::string canonical_path(const std::string &path);

/// Refuses two names of one regular file among the inputs and outputs of a command; `-` and devices do not
/// count. \throws InputError naming the second
void check_distinct(const std::vector<std::string> &paths);

/// Refuses standard input that is given twice, and an output that is one of the inputs, protected or another
/// output.
/// \throws InputError
void check_paths(const std::vector<std::string> &inputs, const std::vector<std::string> &outputs);

/// Keeps a regular file that an option names as an input from being overwritten in this run.
void protect_input(const std::string &path);

/// \throws InputError if the path is that of a protected input
void refuse_protected(const std::string &path);

/// Refuses a file that cannot be read, before any work is done. \throws InputError
void check_readable(const std::string &path);

/// True of `-`, a device, a pipe: of what is there and no regular file.
bool is_stream(const std::string &path);

/// The bytes of a regular file as it lies on the disk; nothing of others.
std::optional<std::uint64_t> file_bytes(const std::string &path);

/// Refuses a file of more than `most` bytes. \throws InputError
void check_size(const std::string &path, std::size_t bytes, std::size_t most);

/// Makes a folder where there is none.
/// \throws InputError if that cannot be
void make_folder(const std::string &path);

/// True for a folder with a file whose name ends so.
bool has_file(const std::string &folder, std::string_view ending);

} // namespace mdm
