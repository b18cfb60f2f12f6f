#include "files/output.hpp"

#include "files/descriptors.hpp"
#include "files/ending_signals.hpp"
#include "files/file_ending.hpp"
#include "files/paths.hpp"
#include "text/filesystem_path.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <utility>
#include <vector>

namespace mdm {
namespace {

/// Names of the files that Outputs are writing, for the handler of signals: it may use atomics and unlink,
/// not much else. More than fit in are not removed at a signal.
std::array<std::atomic<const char *>, 64> unfinished{};

void note_unfinished(const std::string &path) {
  for (std::atomic<const char *> &place : unfinished) {
    const char *expected = nullptr;
    if (place.compare_exchange_strong(expected, path.c_str()))
      return;
  }
}

void forget_unfinished(const std::string &path) {
  for (std::atomic<const char *> &place : unfinished) {
    const char *expected = path.c_str();
    if (place.compare_exchange_strong(expected, nullptr))
      return;
  }
}

/// True of the PID-ATTEMPT of a name that Output::open_beside made.
bool is_of_a_run(std::string_view text) {
  const auto is_number = [](std::string_view digits) {
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const std::size_t dash = text.find('-');
  return dash != std::string_view::npos && is_number(text.substr(0, dash)) &&
         is_number(text.substr(dash + 1));
}

/// The descriptor that a path such as /dev/stdout stands for. To open it would begin anew at the start of a
/// regular file.
std::optional<int> descriptor_named(std::string_view path) {
  if (path == "/dev/stdout")
    return STDOUT_FILENO;
  if (path == "/dev/stderr")
    return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder))
      continue;
    const std::string_view digits = path.substr(folder.size());
    int descriptor = -1;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), descriptor);
    if (error == std::errc{} && end == digits.data() + digits.size() && descriptor >= 0)
      return descriptor;
  }
  return std::nullopt;
}

} // namespace

void remove_leftovers(const std::string &path) {
  const std::filesystem::path target = filesystem_path(canonical_path(path));
  const std::string begin = path_name(target.filename()) + ".", end = ".tmp";
  std::error_code error;
  std::vector<std::filesystem::path> leftovers;
  for (std::filesystem::directory_iterator entry(target.parent_path(), error), last; !error && entry != last;
       entry.increment(error)) {
    const std::string name = path_name(entry->path().filename());
    if (name.starts_with(begin) && name.ends_with(end) && name.size() > begin.size() + end.size() &&
        is_of_a_run(std::string_view(name).substr(begin.size(), name.size() - begin.size() - end.size())))
      leftovers.push_back(entry->path());
  }
  for (const std::filesystem::path &leftover : leftovers)
    std::filesystem::remove(leftover, error);
}

void remove_unfinished() {
  for (const std::atomic<const char *> &path : unfinished)
    if (const char *const name = path.load())
      unlink(name);
}

void remove_unfinished_at_signals() {
  before_ending_signals(remove_unfinished);
}

Output::Output(std::string path) : path_(std::move(path)) {
  if (path_.empty())
    throw file_error(path_, "cannot be written: it is no name: give one, or - for standard output");
  refuse_protected(path_);
  if (path_.ends_with(".gz"))
    throw file_error(path_, "mdm writes no .gz: let the name end in .zst, or pack the file with gzip");
  if (names_zstd(path_))
    in_file(path_, [this] { compressor_.emplace(); });
  if (path_ == "-") {
    descriptor_ = STDOUT_FILENO;
    return;
  }
  if (const std::optional<int> descriptor = descriptor_named(path_)) {
    descriptor_ = duplicate(*descriptor);
    if (descriptor_ < 0)
      fail(errno);
    return;
  }
  target_ = canonical_path(path_);
  struct stat status {};
  const bool exists = stat(target_.c_str(), &status) == 0;
  if (!exists && errno != ENOENT)
    fail(errno);
  if (!exists || S_ISREG(status.st_mode)) {
    if (exists && !may_be_replaced(target_))
      fail(errno);
    open_beside();
    if (exists && !copy_rights(target_, descriptor_))
      fail(errno);
    return;
  }
  descriptor_ = open_file(target_, Opening::to_write);
  if (descriptor_ < 0)
    fail(errno);
}

Output::~Output() {
  if (descriptor_ > STDOUT_FILENO)
    close(descriptor_);
  if (!temporary_.empty()) {
    unlink(temporary_.c_str());
    forget_unfinished(temporary_);
  }
}

void Output::fail(int error) const {
  if (path_ == "-" && error == EPIPE)
    throw ClosedPipe("standard output is closed");
  refuse_file(path_ == "-" ? "standard output" : path_, "cannot be written", error, "write it elsewhere");
}

void Output::open_beside() {
  for (unsigned attempt = 0; descriptor_ < 0; ++attempt) {
    temporary_ = fmt::format("{}.{}-{}.tmp", target_, getpid(), attempt);
    descriptor_ = open_file(temporary_, Opening::new_file);
    if (descriptor_ < 0 && errno != EEXIST) {
      const int error = errno;
      temporary_.clear();
      fail(error);
    }
  }
  note_unfinished(temporary_);
}

void Output::write(std::string_view text) {
  constexpr std::size_t at_once = std::size_t{1} << 16;
  waiting_ += text;
  if (temporary_.empty() || waiting_.size() >= at_once)
    compress(std::exchange(waiting_, {}));
}

void Output::compress(std::string_view text) {
  if (compressor_)
    compressor_->add(text, [this](std::string_view bytes) { write_bytes(bytes); });
  else
    write_bytes(text);
}

void Output::write_bytes(std::string_view bytes) {
  if (digest_)
    digest_->add(bytes);
  while (!bytes.empty()) {
    const std::ptrdiff_t n = mdm::write_bytes(descriptor_, bytes);
    if (n < 0)
      fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

void Output::end() {
  compress(std::exchange(waiting_, {}));
  if (compressor_)
    compressor_->end([this](std::string_view bytes) { write_bytes(bytes); });
  compressor_.reset();
}

void Output::commit_durably() {
  end();
  if (!write_through(descriptor_))
    fail(errno);
  commit();
}

void Output::commit() {
  end();
  // Standard output stays open for what follows, yet an error of closing it must be seen: close a copy.
  const int closing = descriptor_ == STDOUT_FILENO ? dup(descriptor_) : std::exchange(descriptor_, -1);
  if (closing < 0 || close(closing) != 0)
    fail(errno);
  if (temporary_.empty())
    return;
  std::error_code error;
  std::filesystem::rename(filesystem_path(temporary_), filesystem_path(target_), error);
  if (error)
    fail(errno_of(error));
  forget_unfinished(temporary_);
  temporary_.clear();
}

void write_output(const std::string &path, std::string_view text) {
  Output out(path);
  out.write(text);
  out.commit();
}

} // namespace mdm
