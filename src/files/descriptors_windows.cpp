#include "files/descriptors.hpp"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>

namespace mdm {
namespace {

struct Access {
  DWORD rights, creation;
  int flags; ///< of the descriptor
};

Access access_of(Opening opening) {
  switch (opening) {
  case Opening::to_read:
    return {GENERIC_READ, OPEN_EXISTING, _O_RDONLY};
  case Opening::to_write:
    return {GENERIC_WRITE, OPEN_EXISTING, 0};
  case Opening::new_file:
    return {GENERIC_WRITE, CREATE_NEW, 0};
  case Opening::to_go_on:
    break;
  }
  return {GENERIC_READ | GENERIC_WRITE, OPEN_ALWAYS, _O_APPEND};
}

int errno_of_last_error() {
  switch (GetLastError()) {
  case ERROR_FILE_EXISTS:
  case ERROR_ALREADY_EXISTS:
    return EEXIST;
  case ERROR_FILE_NOT_FOUND:
  case ERROR_PATH_NOT_FOUND:
  case ERROR_INVALID_NAME:
  case ERROR_BAD_NETPATH:
  case ERROR_INVALID_DRIVE:
    return ENOENT;
  case ERROR_TOO_MANY_OPEN_FILES:
    return EMFILE;
  default:
    return EACCES;
  }
}

/// With other descriptors, also for removal: at a signal, files that are not finished are removed while they
/// are open.
constexpr DWORD shared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

/// At once: the C library counts by unsigned int, and consoles take less.
constexpr std::size_t most_at_once = std::size_t{1} << 20;

} // namespace

int open_file(const std::string &path, Opening opening) {
  const Access access = access_of(opening);
  const HANDLE file = CreateFileA(path.c_str(), access.rights, shared, nullptr, access.creation,
                                  FILE_ATTRIBUTE_NORMAL, nullptr);
  if (file == INVALID_HANDLE_VALUE) {
    errno = errno_of_last_error();
    return -1;
  }
  const int descriptor =
      _open_osfhandle(reinterpret_cast<std::intptr_t>(file), access.flags | _O_BINARY | _O_NOINHERIT);
  if (descriptor < 0)
    CloseHandle(file);
  return descriptor;
}

int duplicate(int descriptor) {
  const int copy = _dup(descriptor);
  if (copy >= 0)
    _setmode(copy, _O_BINARY);
  return copy;
}

std::ptrdiff_t read_bytes(int descriptor, char *bytes, std::size_t most) {
  return _read(descriptor, bytes, static_cast<unsigned>(std::min(most, most_at_once)));
}

std::ptrdiff_t write_bytes(int descriptor, std::string_view bytes) {
  const int n = _write(descriptor, bytes.data(), static_cast<unsigned>(std::min(bytes.size(), most_at_once)));
  // The C library has no word for this way of a pipe to be closed.
  if (n < 0 && GetLastError() == ERROR_PIPE_NOT_CONNECTED)
    errno = EPIPE;
  return n;
}

bool lock_file(int descriptor) {
  // Windows keeps other descriptors from what is locked: it is a byte far behind the end.
  OVERLAPPED place{};
  place.OffsetHigh = 0x7fffffff;
  const auto file = reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
  return LockFileEx(file, LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &place) != 0;
}

bool may_be_replaced(const std::string &path) {
  const HANDLE file = CreateFileA(path.c_str(), GENERIC_WRITE | DELETE, shared, nullptr, OPEN_EXISTING,
                                  FILE_ATTRIBUTE_NORMAL, nullptr);
  if (file == INVALID_HANDLE_VALUE) {
    errno = errno_of_last_error();
    return false;
  }
  CloseHandle(file);
  return true;
}

bool copy_rights(const std::string &, int) {
  return true; // a file has those of its folder
}

bool write_through(int descriptor) {
  return _commit(descriptor) == 0;
}

} // namespace mdm
