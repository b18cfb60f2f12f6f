#include "cli/files.hpp"

#include "cli/ending_signals.hpp"

#include <mdm/text/error.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

namespace mdm::cli {
namespace {

void check_size(const std::string &path, std::size_t bytes, std::size_t most) {
  if (bytes > most)
    throw file_error(path, fmt::format("more than {} MiB: is it the right file?", most >> 20));
}

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

/// realpath, or nothing where there is no such file.
std::string real_path(const std::string &path) {
  char *const real = realpath(path.c_str(), nullptr);
  if (real == nullptr)
    return {};
  std::string target(real);
  std::free(real);
  return target;
}

/// The end of a path's symbolic links where there is no such file yet.
std::string behind_links(std::filesystem::path path) {
  constexpr int most = 40; // as the kernel
  for (int i = 0; i < most; ++i) {
    std::error_code no_link;
    const std::filesystem::path target = std::filesystem::read_symlink(path, no_link);
    if (no_link)
      break;
    path = path.parent_path() / target;
  }
  return path.string();
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

void occupy_standard_streams() {
  for (const auto &[descriptor, mode] :
       {std::pair(STDIN_FILENO, O_WRONLY), std::pair(STDOUT_FILENO, O_RDONLY),
        std::pair(STDERR_FILENO, O_WRONLY)})
    if (fcntl(descriptor, F_GETFD) < 0)
      open("/dev/null", mode); // takes the lowest free number: this one
}

void tell(std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(STDERR_FILENO, text.data(), text.size());
    if (n < 0 && errno != EINTR)
      return;
    text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  }
}

std::string read_file(const std::string &path, std::size_t most) {
  ByteSource bytes(path);
  std::string text;
  while (bytes.read_some(text))
    check_size(path, text.size(), most);
  return text;
}

std::string beginning_of_file(const std::string &path, std::size_t most) {
  if (path == "-")
    return "";
  std::string begin;
  try {
    ByteSource bytes(path);
    while (begin.size() < most && bytes.read_some(begin)) {
    }
  } catch (const InputError &) { // who reads all of it says so
    return "";
  }
  return begin.substr(0, most);
}

std::string shown_name(const std::string &path) {
  return path == "-" ? "stdin" : path;
}

std::string shell_word(const std::string &path) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("/._-+").find(c) != std::string_view::npos;
  };
  if (!path.empty() && std::all_of(path.begin(), path.end(), is_plain))
    return path;
  std::string word = "'";
  for (const char c : path)
    word += c == '\'' ? "'\\''" : std::string(1, c);
  return printable(word + "'");
}

std::string line_name(const std::string &path, std::uint64_t line) {
  return shown_name(path) + ":" + std::to_string(line);
}

InputError file_error(const std::string &path, const std::string &what) {
  return InputError((path.empty() ? "''" : printable(shown_name(path))) + ": " + what);
}

void refuse_file(const std::string &path, const std::string &what, int error, const std::string &remedy) {
  throw file_error(path, what + ": " + std::strerror(error) + ": " + remedy);
}

void cannot_read(const std::string &path, int error) {
  refuse_file(path, "cannot be read", error, "name one that can be read");
}

std::string canonical_path(const std::string &path) {
  if (std::string file = real_path(path); !file.empty())
    return file;
  const std::string name = behind_links(path);
  const std::size_t slash = name.rfind('/');
  const std::string folder = real_path(slash == std::string::npos ? "." : name.substr(0, slash + 1));
  return folder.empty() ? name : folder + "/" + name.substr(slash == std::string::npos ? 0 : slash + 1);
}

void check_readable(const std::string &path) {
  struct stat status {};
  if (path == "-")
    return;
  if (access(path.c_str(), R_OK) != 0 || stat(path.c_str(), &status) != 0)
    cannot_read(path, errno);
  if (S_ISDIR(status.st_mode))
    cannot_read(path, EISDIR);
}

std::optional<std::uint64_t> file_bytes(const std::string &path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
    return std::nullopt;
  return static_cast<std::uint64_t>(status.st_size);
}

void make_folder(const std::string &path) {
  struct stat status {};
  if (mkdir(path.c_str(), 0777) == 0)
    return;
  const int error = errno;
  if (stat(path.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
    refuse_file(path, "no folder can be made there", error, "name another");
}

void check_distinct(const std::vector<std::string> &paths) {
  std::set<std::string> seen;
  for (const std::string &path : paths) {
    struct stat status {};
    const bool exists = stat(path.c_str(), &status) == 0;
    if (path == "-" || (exists && !S_ISREG(status.st_mode)))
      continue;
    if (!seen.insert(canonical_path(path)).second)
      throw file_error(path, "would be overwritten: give input and outputs different names");
  }
}

void remove_leftovers(const std::string &path) {
  const std::filesystem::path target = canonical_path(path);
  const std::string begin = target.filename().string() + ".", end = ".tmp";
  std::error_code error;
  std::vector<std::filesystem::path> leftovers;
  for (std::filesystem::directory_iterator entry(target.parent_path(), error), last; !error && entry != last;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(begin) && name.ends_with(end) && name.size() > begin.size() + end.size() &&
        is_of_a_run(std::string_view(name).substr(begin.size(), name.size() - begin.size() - end.size())))
      leftovers.push_back(entry->path());
  }
  for (const std::filesystem::path &leftover : leftovers)
    unlink(leftover.c_str());
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
  if (names_zstd(path_))
    in_file(path_, [this] { compressor_.emplace(); });
  if (path_ == "-") {
    descriptor_ = STDOUT_FILENO;
    return;
  }
  if (const std::optional<int> descriptor = descriptor_named(path_)) {
    descriptor_ = fcntl(*descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
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
    if (exists && access(target_.c_str(), W_OK) != 0)
      fail(errno);
    open_beside();
    if (exists && fchmod(descriptor_, status.st_mode & 07777) != 0)
      fail(errno);
    return;
  }
  descriptor_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC);
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
    descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
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
    const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
    if (n < 0 && errno != EINTR)
      fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
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
  if (fsync(descriptor_) != 0)
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
  if (rename(temporary_.c_str(), target_.c_str()) != 0)
    fail(errno);
  forget_unfinished(temporary_);
  temporary_.clear();
}

std::string FileLines::too_long(const std::string &what) {
  return fmt::format("{} has more than {} MiB", what, longest_line >> 20);
}

void FileLines::fill() {
  buffer_.erase(0, taken_);
  searched_ -= taken_;
  taken_ = 0;
  if (skipping_ || buffer_.size() > longest_line) {
    skipping_ = true;
    buffer_.clear();
    searched_ = 0;
  }
  at_end_ = !bytes_.read_some(buffer_);
}

bool FileLines::take_line(std::vector<Line> &lines) {
  std::size_t end = buffer_.find('\n', searched_);
  if (end == std::string::npos) {
    if (!at_end_ || (taken_ == buffer_.size() && !skipping_)) {
      searched_ = buffer_.size();
      return false;
    }
    end = buffer_.size(); // the last line has no end
  }
  if (skipping_)
    lines.emplace_back();
  else
    lines.emplace_back(buffer_.substr(taken_, end - taken_));
  skipping_ = false;
  taken_ = searched_ = std::min(end + 1, buffer_.size());
  return true;
}

std::string_view FileLines::look_further() {
  if (!at_end_)
    fill();
  return std::string_view(buffer_).substr(taken_);
}

std::string FileLines::rest(std::size_t most) {
  std::string text = buffer_.substr(taken_);
  buffer_.clear();
  taken_ = searched_ = 0;
  while (text.size() <= most && !at_end_)
    at_end_ = !bytes_.read_some(text);
  check_size(bytes_.path(), text.size(), most);
  return text;
}

std::vector<FileLines::Line> FileLines::next(std::size_t most) {
  std::vector<Line> lines;
  for (;;) {
    while (lines.size() < most && take_line(lines)) {
    }
    if (!lines.empty() || at_end_)
      return lines;
    fill();
  }
}

} // namespace mdm::cli
