#include "answer/line_sum.hpp"

#include <charconv>

namespace mdm {

void LineSum::add(const Hash &hash) {
  unsigned carry = 0;
  for (std::size_t i = sum_.size(); i-- > 0;) {
    carry += sum_[i] + unsigned{hash[i]};
    sum_[i] = static_cast<unsigned char>(carry & 0xff);
    carry >>= 8;
  }
}

std::string LineSum::text() const {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : sum_) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

std::optional<LineSum> LineSum::parse(std::string_view text) {
  LineSum sum;
  if (text.size() != 2 * sum.sum_.size())
    return std::nullopt;
  for (std::size_t i = 0; i < sum.sum_.size(); ++i) {
    const char *const at = text.data() + 2 * i;
    if (std::from_chars(at, at + 2, sum.sum_[i], 16).ptr != at + 2)
      return std::nullopt;
  }
  return sum;
}

} // namespace mdm
