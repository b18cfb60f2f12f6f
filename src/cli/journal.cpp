#include "journal.hpp"

#include "files.hpp"

#include <mdm/error.hpp>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <limits>

namespace mdm::cli {

Journal::Journal(std::string path, std::string solver) : path_(std::move(path)), solver_(std::move(solver)) {
  descriptor_ = open(path_.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0)
    fail(errno);
  try {
    struct stat status {};
    if (fstat(descriptor_, &status) != 0)
      fail(errno);
    if (!S_ISREG(status.st_mode))
      throw InputError(printable(path_) + ": a journal is a regular file: name one, or a new one");
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
      throw InputError(printable(path_) + ": another run writes this journal: wait for it, or name another");
    read();
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

Journal::~Journal() {
  close(descriptor_);
}

void Journal::fail(int error) const {
  throw InputError(printable(path_) + ": cannot be written: " + std::strerror(error) +
                   ": name a file that can be");
}

void Journal::read() {
  const std::string content = read_file(path_, std::numeric_limits<std::size_t>::max());
  const std::size_t whole = content.rfind('\n') + 1; // 0 where there is none
  std::string_view rest = std::string_view(content).substr(0, whole);
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::size_t end = rest.find('\n');
    take(rest.substr(0, end), number);
    rest.remove_prefix(end + 1);
  }
  if (whole < content.size() && content[whole] != '{')
    throw InputError(fmt::format("{}: is no journal of mdm crosscheck: name a new file", printable(path_)));
  if (whole < content.size() && ftruncate(descriptor_, static_cast<off_t>(whole)) != 0)
    fail(errno);
}

void Journal::take(std::string_view text, std::size_t number) {
  OtherAnswer answer = json_answer(text);
  const auto solver = answer.labels.find("solver");
  const auto line = answer.labels.find("line");
  const std::optional<Integer> at = line == answer.labels.end() ? std::nullopt : parse_natural(line->second);
  if (!at || *at > std::numeric_limits<std::uint64_t>::max() || solver == answer.labels.end())
    throw InputError(fmt::format("{}:{}: is no line of a journal of mdm crosscheck: name a new file",
                                 printable(path_), number));
  if (solver->second == solver_)
    answers_[static_cast<std::uint64_t>(*at)] = std::move(answer);
}

const OtherAnswer *Journal::find(std::uint64_t line, const std::string &id) const {
  const auto found = answers_.find(line);
  if (found == answers_.end())
    return nullptr;
  if (found->second.id != id)
    throw InputError(fmt::format("{}: has an answer for {} where the suite's line {} has {}: the suite is "
                                 "another one; name a new file",
                                 printable(path_), in_quotes(found->second.id), line, in_quotes(id)));
  return &found->second;
}

void Journal::add(std::uint64_t line, const OtherAnswer &answer) {
  const std::string text = answer_line(answer, {{"solver", solver_}, {"line", std::to_string(line)}}) + "\n";
  const std::lock_guard lock(mutex_);
  for (std::string_view rest = text; !rest.empty();) {
    const ssize_t n = write(descriptor_, rest.data(), rest.size());
    if (n < 0 && errno != EINTR)
      fail(errno);
    rest.remove_prefix(n < 0 ? 0 : static_cast<std::size_t>(n));
  }
}

} // namespace mdm::cli
