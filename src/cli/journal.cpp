#include "cli/journal.hpp"

#include "cli/files.hpp"
#include "crosscheck/journal_line.hpp"
#include "text/lines.hpp"

#include <mdm/text/error.hpp>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
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
      throw file_error(path_, "a journal is a regular file: name one, or a new one");
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
      throw file_error(path_, "another run writes this journal: wait for it, or name another");
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
  refuse_file(path_, "cannot be written", error, "name a file that can be");
}

void Journal::read() {
  const std::string content = read_file(path_, std::numeric_limits<std::size_t>::max());
  const std::size_t whole = content.rfind('\n') + 1; // 0 where there is none
  for (Lines lines(std::string_view(content).substr(0, whole)); lines.next();)
    take(lines.text(), lines.number());
  if (whole < content.size() && content[whole] != '{')
    throw file_error(path_, "is no journal of mdm crosscheck: name a new file");
  if (whole < content.size() && ftruncate(descriptor_, static_cast<off_t>(whole)) != 0)
    fail(errno);
}

void Journal::take(std::string_view text, std::size_t number) {
  OtherAnswer answer = json_answer(text);
  const auto solver = answer.labels.find(journal_label::solver);
  const auto line = answer.labels.find(journal_label::line);
  const std::optional<Integer> at = line == answer.labels.end() ? std::nullopt : parse_natural(line->second);
  if (!at || *at > std::numeric_limits<std::uint64_t>::max() || solver == answer.labels.end())
    throw file_error(line_name(path_, number), "is no line of a journal of mdm crosscheck: name a new file");
  const auto gradation = answer.labels.find(journal_label::gradation);
  if (gradation == answer.labels.end())
    throw file_error(line_name(path_, number),
                     "does not say which gradation was asked, as journals of version 1 do not: name a new "
                     "file (this one is still good as ANSWERS)");
  if (solver->second == solver_)
    answers_[static_cast<std::uint64_t>(*at)] = {gradation->second, std::move(answer)};
}

const OtherAnswer *Journal::find(std::uint64_t line, const Gradation &g) const {
  const auto found = answers_.find(line);
  if (found == answers_.end())
    return nullptr;
  const auto &[gradation, answer] = found->second;
  if (answer.id != g.id())
    throw file_error(path_, fmt::format("has an answer for {} where the suite's line {} has {}: the suite is "
                                        "another one; name a new file",
                                        in_quotes(answer.id), line, in_quotes(g.id())));
  return gradation == digest(g) ? &answer : nullptr;
}

void Journal::add(std::uint64_t line, const Gradation &g, const OtherAnswer &answer) {
  const std::string text = answer_line(answer, {{journal_label::solver, solver_},
                                                {journal_label::line, std::to_string(line)},
                                                {journal_label::gradation, digest(g)}}) +
                           "\n";
  const std::lock_guard lock(mutex_);
  for (std::string_view rest = text; !rest.empty();) {
    const ssize_t n = write(descriptor_, rest.data(), rest.size());
    if (n < 0 && errno != EINTR)
      fail(errno);
    rest.remove_prefix(n < 0 ? 0 : static_cast<std::size_t>(n));
  }
}

} // namespace mdm::cli
