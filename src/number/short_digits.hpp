#pragma once
/// \file
/// Decimal digits of short numbers, several times cheaper than by GMP.

#include "number/words.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string_view>

namespace mdm {

/// The decimal digits of a number below 2^126 < 10^38, made on the stack.
class ShortDigits {
public:
  __extension__ typedef unsigned __int128 Wide;

  explicit ShortDigits(Wide value) {
    constexpr std::uint64_t half = 10'000'000'000'000'000'000U; // 10^19
    constexpr std::size_t half_digits = 19;
    const auto high = static_cast<std::uint64_t>(value / half);
    const auto low = static_cast<std::uint64_t>(value - static_cast<Wide>(high) * half);
    if (high == 0) {
      size_ = write(0, low);
      return;
    }
    const std::size_t tail = write(0, high);
    const std::size_t written = write(tail, low) - tail;
    size_ = tail + half_digits;
    const auto begin = digits_.begin() + static_cast<std::ptrdiff_t>(tail);
    std::copy_backward(begin, begin + static_cast<std::ptrdiff_t>(written), begin + half_digits);
    std::fill(begin, begin + static_cast<std::ptrdiff_t>(half_digits - written), '0');
  }
  std::string_view text() const { return {digits_.data(), size_}; }

private:
  /// The end of value's digits, written from `at` on.
  std::size_t write(std::size_t at, std::uint64_t value) {
    const char *const end = std::to_chars(digits_.data() + at, digits_.data() + digits_.size(), value).ptr;
    return static_cast<std::size_t>(end - digits_.data());
  }

  std::array<char, 40> digits_;
  std::size_t size_;
};

/// Those of n; nothing if n is negative or too long.
inline std::optional<ShortDigits> short_digits(const Integer &n) {
  if (n < 0 || bit_length(n) > 126)
    return std::nullopt;
  return ShortDigits(static_cast<ShortDigits::Wide>(word(n, 1)) << 64 | word(n, 0));
}

} // namespace mdm
