#include "files/real_path.hpp"

#include <windows.h>

namespace mdm {

std::string real_path(const std::string &path) {
  const HANDLE file = CreateFileA(path.c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                                  nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (file == INVALID_HANDLE_VALUE)
    return {};
  // It has the case of letters that the folder has: names that differ by it alone are those of one file.
  std::string target(DWORD{1} << 15, '\0');
  const DWORD length = GetFinalPathNameByHandleA(file, target.data(), static_cast<DWORD>(target.size()), 0);
  CloseHandle(file);
  if (length == 0 || length >= target.size())
    return path;
  target.resize(length);
  if (target.starts_with(R"(\\?\UNC\)"))
    return R"(\\)" + target.substr(8);
  return target.starts_with(R"(\\?\)") ? target.substr(4) : target;
}

bool is_named_pipe(const std::string &path) {
  return path.starts_with(R"(\\.\pipe\)") || path.starts_with("//./pipe/");
}

} // namespace mdm
