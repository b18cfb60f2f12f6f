#include "files/real_path.hpp"

#include <sys/stat.h>

#include <cstdlib>

namespace mdm {

std::string real_path(const std::string &path) {
  char *const real = realpath(path.c_str(), nullptr);
  if (real == nullptr)
    return {};
  std::string target(real);
  std::free(real);
  return target;
}

bool is_named_pipe(const std::string &path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode));
}

} // namespace mdm
