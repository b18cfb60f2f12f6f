#include "program_files.hpp"

#include "text.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <vector>

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
  Input input{shown_name(path), {}};
  const File file = opened(path);
  std::vector<char> piece(std::size_t{1} << 16U);
  while (const std::size_t got = file ? std::fread(piece.data(), 1, piece.size(), file.get()) : 0) {
    input.text.append(piece.data(), got);
    check_size(input.name, input.text.size(), most_bytes);
  }
  check_read(input.name, file);
  return input;
}

void print(const std::string &text) {
  if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
    fail("standard output",
         std::string("cannot be written: ") + std::strerror(errno) + ": send it elsewhere");
}

InputLines::InputLines(const std::string &path) : name_(shown_name(path)), file_(opened(path)) {
  check_read(name_, file_);
}

std::optional<Input> InputLines::next() {
  Input line{name_ + ":" + std::to_string(number_ + 1), {}, true};
  int c = std::getc(file_.get());
  if (c == EOF) {
    check_read(name_, file_);
    return std::nullopt;
  }
  ++number_;
  for (; c != '\n' && c != EOF; c = std::getc(file_.get())) {
    line.text += static_cast<char>(c);
    check_size(line.name, line.text.size(), most_gradation_bytes);
  }
  check_read(name_, file_);
  if (c == '\n' && line.text.ends_with('\r'))
    line.text.pop_back();
  return line;
}

} // namespace mdm::checker
