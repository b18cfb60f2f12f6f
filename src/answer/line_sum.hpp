#pragma once
/// \file
/// What lines of a suite are told by, in any order and part by part.

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace mdm {

/// The sum, modulo 2^256, of the SHA-256 of lines, each with its number in the suite. That of a suite is the
/// sum of those of its shards.
class LineSum {
public:
  using Hash = std::array<unsigned char, 32>; ///< the highest byte first

  void add(const Hash &hash);
  void add(const LineSum &other) { add(other.sum_); }

  /// 64 hexadecimal digits.
  std::string text() const;
  /// Reads what text() wrote; nothing of anything else.
  static std::optional<LineSum> parse(std::string_view text);

  bool operator==(const LineSum &) const = default;

private:
  Hash sum_{};
};

} // namespace mdm
