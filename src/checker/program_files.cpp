#include "program_files.hpp"

#include "text.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace mdm::checker {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

File opened(const std::string &path) {
  return {path == "-" ? stdin : std::fopen(path.c_str(), "rb"), &std::fclose};
}

std::string shown_name(const std::string &path) {
  return path == "-" ? "standard input" : path;
}

void check_size(const std::string &name, std::size_t bytes, std::size_t most) {
  if (bytes > most)
    fail(name, "longer than " + std::to_string(most >> 20U) + " MiB: give the file that was meant");
}

void check_read(const std::string &name, const File &file) {
  if (!file || std::ferror(file.get()) != 0)
    fail(name, std::string("cannot be read: ") + std::strerror(errno) + ": give a file that is there");
}

} // namespace

void fail(const std::string &who, const std::string &what) {
  throw std::runtime_error(printable(who) + ": " + what);
}

Input read_input(const std::string &path, std::size_t most_bytes) {
  InputBytes bytes(path);
  Input input{bytes.name(), {}};
  for (std::string_view some = bytes.some(); !some.empty(); some = bytes.some()) {
    input.text += some;
    bytes.take(some.size());
    check_size(input.name, input.text.size(), most_bytes);
  }
  return input;
}

void print(const std::string &text) {
  if (std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0)
    return;
  if (errno == EPIPE)
    throw ClosedPipe();
  fail("standard output", std::string("cannot be written: ") + std::strerror(errno) + ": send it elsewhere");
}

InputBytes::InputBytes(const std::string &path)
    : name_(shown_name(path)), file_(opened(path)), memory_(std::size_t{1} << 16U) {
  check_read(name_, file_);
  try {
    if (path.ends_with(".zst"))
      unpacker_.emplace();
  } catch (const std::runtime_error &error) {
    fail(name_, error.what());
  }
}

std::string_view InputBytes::some() {
  if (piece_.empty())
    piece_ = unpacker_ ? unpack() : read();
  return piece_;
}

std::string_view InputBytes::read() {
  const std::size_t got = std::fread(memory_.data(), 1, memory_.size(), file_.get());
  check_read(name_, file_);
  return {memory_.data(), got};
}

std::string_view InputBytes::unpack() {
  for (;;) {
    if (packed_.empty())
      packed_ = read();
    const bool is_at_end = packed_.empty();
    if (is_at_end && unpacker_->is_whole())
      return {};
    try {
      if (const std::string_view text = unpacker_->unpack(packed_); !text.empty())
        return text;
    } catch (const std::runtime_error &error) {
      fail(name_, error.what());
    }
    if (is_at_end)
      fail(name_, "cannot be unpacked: it ends too early: give the whole file");
  }
}

std::optional<Input> InputLines::next() {
  Input line{name() + ":" + std::to_string(number_ + 1), {}, true};
  has_line_end_ = false;
  std::string_view some = bytes_.some();
  if (some.empty())
    return std::nullopt;
  ++number_;
  for (; !some.empty() && !has_line_end_; some = bytes_.some()) {
    const std::size_t end = some.find('\n');
    has_line_end_ = end != std::string_view::npos;
    line.text += some.substr(0, end);
    check_size(line.name, line.text.size(), most_gradation_bytes);
    bytes_.take(has_line_end_ ? end + 1 : some.size());
  }
  if (has_line_end_ && line.text.ends_with('\r'))
    line.text.pop_back();
  return line;
}

} // namespace mdm::checker
