#include "files/byte_source.hpp"

#include "files/paths.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace mdm {
namespace {

constexpr std::size_t bytes_at_once = std::size_t{1} << 16;

int open_for_reading(const std::string &path) {
  if (path == "-")
    return STDIN_FILENO;
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    cannot_read(path, errno);
  return descriptor;
}

} // namespace

ByteSource::ByteSource(std::string path) : path_(std::move(path)) {
  unpacker_ = in_file(path_, [this] { return unpacker_of(path_); });
  descriptor_ = open_for_reading(path_);
}

ByteSource::~ByteSource() {
  if (descriptor_ > STDIN_FILENO)
    close(descriptor_);
}

bool ByteSource::read_raw(std::string &text) {
  const std::size_t before = text.size();
  text.resize(before + bytes_at_once);
  ssize_t n = 0;
  do {
    n = read(descriptor_, text.data() + before, bytes_at_once);
  } while (n < 0 && errno == EINTR);
  const int error = errno;
  text.resize(before + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  if (n < 0)
    cannot_read(path_ == "-" ? "standard input" : path_, error);
  if (digest_)
    digest_->add(std::string_view(text).substr(before));
  return n > 0;
}

bool ByteSource::read_some(std::string &text) {
  return unpacker_ ? unpack_some(text) : read_raw(text);
}

bool ByteSource::unpack_some(std::string &text) {
  const std::size_t before = text.size();
  for (bool is_at_end = false; text.size() == before;) {
    if (unpacked_ == packed_.size()) {
      packed_.clear();
      unpacked_ = 0;
      is_at_end = !read_raw(packed_);
    }
    if (is_at_end && unpacker_->is_whole())
      return false;
    std::string_view packed = std::string_view(packed_).substr(unpacked_);
    in_file(path_, [&] { unpacker_->unpack(packed, text); });
    unpacked_ = packed_.size() - packed.size();
    if (is_at_end && text.size() == before)
      throw file_error(path_, "cannot be unpacked: it ends too early: give the whole file");
  }
  return true;
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

} // namespace mdm
