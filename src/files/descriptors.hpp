#pragma once
/// \file
/// Open files by their descriptors, as each system has them. What fails says why in errno.

#include <cstddef>
#include <string>
#include <string_view>

namespace mdm {

/// How a file is opened.
enum class Opening {
  to_read,
  to_write, ///< one that is there
  new_file, ///< to write; fails where there is one
  to_go_on, ///< to read, and to write at its end; made where there is none
};

/// The descriptor of a file, of which other programs get none; -1 if it cannot be opened.
int open_file(const std::string &path, Opening opening);

/// Another descriptor of the same file, none of the standard ones; -1 if there is none.
int duplicate(int descriptor);

/// Reads at most so many bytes; their number, 0 at the end, -1 if it fails.
std::ptrdiff_t read_bytes(int descriptor, char *bytes, std::size_t most);

/// Writes some of the bytes; their number, -1 if it fails.
std::ptrdiff_t write_bytes(int descriptor, std::string_view bytes);

/// Locks a file for this run, which may read it by other descriptors; false if another run has it.
bool lock_file(int descriptor);

/// True of a file that this run may write, and that no other program keeps from being replaced.
bool may_be_replaced(const std::string &path);

/// Gives the file the rights of another one; false if it fails.
bool copy_rights(const std::string &from, int to);

/// Waits until all of the file is on the disk; false if it fails.
bool write_through(int descriptor);

} // namespace mdm
