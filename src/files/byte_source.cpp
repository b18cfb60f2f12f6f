#include "files/byte_source.hpp"

#include "files/descriptors.hpp"
#include "files/paths.hpp"
#include "files/real_path.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <map>
#include <mutex>
#include <utility>

namespace mdm {
namespace {

constexpr std::size_t bytes_at_once = std::size_t{1} << 16;
constexpr std::size_t packed_mark = 4; // bytes that tell a packed file

/// A pipe that is open, and what was looked at of it.
struct OpenPipe {
  int descriptor;
  std::string ahead;
};

/// The pipes of the run by their names; without one where it was read.
std::mutex pipes_mutex;
std::map<std::string, std::optional<OpenPipe>> pipes;

std::atomic<bool> standard_input_is_packed = false;

bool is_pipe(const std::string &path) {
  return path == "-" || is_named_pipe(path);
}

/// The pipe that was looked at; nothing of one that is new.
std::optional<OpenPipe> taken_up(const std::string &path) {
  const std::lock_guard lock(pipes_mutex);
  const auto [known, is_new] = pipes.try_emplace(path);
  if (is_new)
    return std::nullopt;
  if (!known->second && path == "-") // it is at its end
    return OpenPipe{STDIN_FILENO, ""};
  if (!known->second)
    throw file_error(path, "it is a pipe, which can be read once: write it to a file and give that");
  return std::exchange(known->second, std::nullopt);
}

int open_for_reading(const std::string &path) {
  if (path == "-")
    return STDIN_FILENO;
  const int descriptor = open_file(path, Opening::to_read);
  if (descriptor < 0)
    cannot_read(path, errno);
  return descriptor;
}

} // namespace

ByteSource::ByteSource(std::string path) : path_(std::move(path)) {
  is_pipe_ = is_pipe(path_);
  if (std::optional<OpenPipe> pipe = is_pipe_ ? taken_up(path_) : std::nullopt) {
    descriptor_ = pipe->descriptor;
    ahead_ = std::move(pipe->ahead);
  } else {
    descriptor_ = open_for_reading(path_);
  }
}

ByteSource::~ByteSource() {
  if (is_looking_)
    put_back();
  else if (descriptor_ > STDIN_FILENO)
    close(descriptor_);
}

bool ByteSource::read_raw(std::string &text) {
  const std::size_t before = text.size();
  if (!ahead_.empty())
    text += std::exchange(ahead_, {});
  else
    read_descriptor(text);
  const std::string_view bytes = std::string_view(text).substr(before);
  if (digest_)
    digest_->add(bytes);
  if (is_looking_)
    raw_ += bytes;
  return !bytes.empty();
}

void ByteSource::read_descriptor(std::string &text) {
  const std::size_t before = text.size();
  text.resize(before + bytes_at_once);
  const std::ptrdiff_t n = read_bytes(descriptor_, text.data() + before, bytes_at_once);
  const int error = errno;
  text.resize(before + static_cast<std::size_t>(std::max<std::ptrdiff_t>(n, 0)));
  if (n < 0)
    cannot_read(path_ == "-" ? "standard input" : path_, error);
}

bool ByteSource::read_some(std::string &text) {
  if (!std::exchange(has_begun_, true))
    return begin(text);
  return unpacker_ ? unpack_some(text) : read_raw(text);
}

bool ByteSource::begin(std::string &text) {
  std::string first;
  while (first.size() < packed_mark && read_raw(first)) {
  }
  unpacker_ = in_file(path_, [&] { return unpacker_of(first, path_); });
  if (path_ == "-")
    standard_input_is_packed = unpacker_ != nullptr;
  if (unpacker_) {
    packed_ = std::move(first);
    return unpack_some(text);
  }
  text += first;
  return !first.empty();
}

void ByteSource::put_back() {
  const std::lock_guard lock(pipes_mutex);
  pipes[path_] = OpenPipe{std::exchange(descriptor_, -1), std::move(raw_)};
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
  std::string begin;
  try {
    ByteSource bytes(path);
    bytes.is_looking_ = bytes.is_pipe_;
    while (begin.size() < most && bytes.read_some(begin)) {
    }
  } catch (const InputError &) { // who reads all of it says so
    return "";
  }
  return begin.substr(0, most);
}

bool is_plain_file(const std::string &path) {
  if (path == "-")
    return !standard_input_is_packed;
  if (!file_bytes(path))
    return false;
  const int descriptor = open_for_reading(path);
  std::array<char, packed_mark> begin{};
  const std::ptrdiff_t n = read_bytes(descriptor, begin.data(), begin.size());
  close(descriptor);
  return !is_packed({begin.data(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(n, 0))});
}

} // namespace mdm
