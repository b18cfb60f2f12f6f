#include "files/descriptors.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace mdm {
namespace {

int flags_of(Opening opening) {
  switch (opening) {
  case Opening::to_read:
    return O_RDONLY;
  case Opening::to_write:
    return O_WRONLY;
  case Opening::new_file:
    return O_WRONLY | O_CREAT | O_EXCL;
  case Opening::to_go_on:
    break;
  }
  return O_RDWR | O_APPEND | O_CREAT;
}

} // namespace

int open_file(const std::string &path, Opening opening) {
  return open(path.c_str(), flags_of(opening) | O_CLOEXEC, 0666);
}

int duplicate(int descriptor) {
  return fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
}

std::ptrdiff_t read_bytes(int descriptor, char *bytes, std::size_t most) {
  ssize_t n = 0;
  do {
    n = read(descriptor, bytes, most);
  } while (n < 0 && errno == EINTR);
  return n;
}

std::ptrdiff_t write_bytes(int descriptor, std::string_view bytes) {
  ssize_t n = 0;
  do {
    n = write(descriptor, bytes.data(), bytes.size());
  } while (n < 0 && errno == EINTR);
  return n;
}

bool lock_file(int descriptor) {
  return flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

bool may_be_replaced(const std::string &path) {
  return access(path.c_str(), W_OK) == 0;
}

bool copy_rights(const std::string &from, int to) {
  struct stat status {};
  return stat(from.c_str(), &status) == 0 && fchmod(to, status.st_mode & 07777) == 0;
}

bool write_through(int descriptor) {
  return fsync(descriptor) == 0;
}

} // namespace mdm
