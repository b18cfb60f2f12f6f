#include "files/counted_part.hpp"

#include "files/paths.hpp"
#include "files/proof_stream.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace mdm {

CountedPart::CountedPart(const std::string &path, const FileTotals &totals) : bytes_(path), totals_(totals) {
  bytes_.keep_digest();
}

void CountedPart::line(const Sink &to) {
  for (bool has_end = false; !has_end;) {
    fill();
    const std::string_view rest = std::string_view(buffer_).substr(taken_);
    const std::size_t end = rest.find('\n');
    has_end = end != std::string_view::npos;
    take(has_end ? end + 1 : rest.size(), to);
  }
}

void CountedPart::bytes(std::uint64_t count, const Sink &to) {
  while (count > 0) {
    fill();
    const std::size_t some = std::min<std::uint64_t>(count, buffer_.size() - taken_);
    take(some, to);
    count -= some;
  }
}

bool CountedPart::is_at_end() {
  return taken_ == buffer_.size() && !read();
}

void CountedPart::check_end() {
  if (!is_at_end() || FileTotals{bytes_.digest().bytes(), bytes_.digest().sha256()} != totals_)
    refuse();
}

void CountedPart::refuse() const {
  throw file_error(bytes_.path(),
                   "it is not the file that its totals were written of: solve the shard again");
}

bool CountedPart::read() {
  buffer_.clear();
  taken_ = 0;
  return bytes_.read_some(buffer_);
}

void CountedPart::fill() {
  if (is_at_end())
    refuse();
}

void CountedPart::take(std::size_t count, const Sink &to) {
  to(std::string_view(buffer_).substr(taken_, count));
  taken_ += count;
}

CountedProofs::CountedProofs(const std::string &stream, const FileTotals &stream_totals,
                             const std::string &index, const FileTotals &index_totals)
    : stream_(stream, stream_totals), index_(index, index_totals) {
  if (next_line() != proof_index_header)
    index_.refuse();
  next();
}

std::uint64_t CountedProofs::take(const Sink &to) {
  const std::uint64_t length = length_;
  stream_.bytes(length, to);
  next();
  return length;
}

void CountedProofs::check_end() {
  stream_.check_end();
  index_.check_end();
}

std::string CountedProofs::next_line() {
  std::string line;
  index_.line([&line](std::string_view text) { line += text; });
  return line;
}

void CountedProofs::next() {
  const std::uint64_t before = std::exchange(number_, 0);
  if (index_.is_at_end())
    return;
  const std::string line = next_line();
  std::uint64_t fields[3] = {}; // number, offset, length
  const char *at = line.data(), *const end = line.data() + line.size();
  for (std::uint64_t &field : fields) {
    const auto [behind, error] = std::from_chars(at, end, field);
    if (error != std::errc{} || behind == end)
      index_.refuse();
    at = behind + 1;
  }
  number_ = fields[0];
  length_ = fields[2];
  if (number_ <= before)
    index_.refuse();
}

} // namespace mdm
