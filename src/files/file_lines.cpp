#include "files/file_lines.hpp"

#include "files/paths.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mdm {

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

} // namespace mdm
