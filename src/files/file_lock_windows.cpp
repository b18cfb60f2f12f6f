#include "files/file_lock.hpp"
#include "files/paths.hpp"

#include <io.h>
#include <windows.h>

#include <cerrno>
#include <cstdint>
#include <utility>

namespace mdm {

FileLock::FileLock(std::string path) : path_(std::move(path)) {
  // Nobody else can open it, and the system removes it with its last descriptor.
  const HANDLE file = CreateFileA(path_.c_str(), GENERIC_READ | GENERIC_WRITE | DELETE, 0, nullptr,
                                  OPEN_ALWAYS, FILE_ATTRIBUTE_NORMAL | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  if (file == INVALID_HANDLE_VALUE && GetLastError() == ERROR_SHARING_VIOLATION)
    throw file_error(path_, "another run writes these files: wait for it, or give other names");
  if (file == INVALID_HANDLE_VALUE)
    refuse_file(path_, "cannot be written", GetLastError() == ERROR_PATH_NOT_FOUND ? ENOENT : EACCES,
                "write it elsewhere");
  descriptor_ = _open_osfhandle(reinterpret_cast<std::intptr_t>(file), 0);
}

FileLock::~FileLock() {
  _close(descriptor_);
}

} // namespace mdm
