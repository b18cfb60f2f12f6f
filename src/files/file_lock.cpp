#include "files/file_lock.hpp"

#include "files/paths.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace mdm {

FileLock::FileLock(std::string path) : path_(std::move(path)) {
  do { // until the locked file is not one that another run has just removed
    if (descriptor_ >= 0)
      close(descriptor_);
    descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0)
      refuse_file(path_, "cannot be written", errno, "write it elsewhere");
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      close(descriptor_);
      throw file_error(path_, "another run writes these files: wait for it, or give other names");
    }
  } while (!is_at_path());
}

FileLock::~FileLock() {
  unlink(path_.c_str());
  close(descriptor_);
}

bool FileLock::is_at_path() const {
  struct stat ours {
  }, there{};
  return fstat(descriptor_, &ours) == 0 && stat(path_.c_str(), &there) == 0 && ours.st_ino == there.st_ino &&
         ours.st_dev == there.st_dev;
}

} // namespace mdm
