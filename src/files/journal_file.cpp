#include "files/journal_file.hpp"

#include "files/byte_source.hpp"
#include "files/descriptors.hpp"
#include "files/paths.hpp"
#include "files/zstd_stream.hpp"
#include "text/lines.hpp"

#include <mdm/text/error.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <limits>

namespace mdm {

JournalFile::JournalFile(std::string path) : path_(std::move(path)) {
  if (names_zstd(path_))
    throw file_error(path_, "a journal is not compressed: give a name without .zst");
  refuse_protected(path_);
  descriptor_ = open_file(path_, Opening::to_go_on);
  if (descriptor_ < 0)
    fail(errno);
  try {
    struct stat status {};
    if (fstat(descriptor_, &status) != 0)
      fail(errno);
    if (!S_ISREG(status.st_mode))
      throw file_error(path_, "a journal is a regular file: name one, or a new one");
    if (!lock_file(descriptor_))
      throw file_error(path_, "another run writes this journal: wait for it, or name another");
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

JournalFile::~JournalFile() {
  close(descriptor_);
}

void JournalFile::fail(int error) const {
  refuse_file(path_, "cannot be written", error, "name a file that can be");
}

void JournalFile::read(const std::function<void(std::string_view, std::size_t)> &take,
                       const std::string &no_journal) {
  const std::string content = read_file(path_, std::numeric_limits<std::size_t>::max());
  const std::size_t whole = content.rfind('\n') + 1; // 0 where there is none
  for (Lines lines(std::string_view(content).substr(0, whole)); lines.next();)
    take(lines.text(), lines.number());
  if (whole < content.size() && content[whole] != '{')
    throw file_error(path_, no_journal);
  if (whole < content.size() && ftruncate(descriptor_, static_cast<off_t>(whole)) != 0)
    fail(errno);
}

void JournalFile::add(const std::string &line) {
  const std::string text = line + "\n";
  const std::lock_guard lock(mutex_);
  for (std::string_view rest = text; !rest.empty();) {
    const std::ptrdiff_t n = write_bytes(descriptor_, rest);
    if (n < 0)
      fail(errno);
    rest.remove_prefix(static_cast<std::size_t>(n));
  }
}

} // namespace mdm
