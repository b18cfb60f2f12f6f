#pragma once
/// \file
/// A list in a message, cut where it is long.

#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// The items of a list of which only the first few are kept, for a message.
class ShortList {
public:
  void add(std::string_view item);
  bool empty() const { return total_ == 0; }
  std::size_t size() const { return total_; }
  /// `'a', 'b' and 7 more`.
  std::string text() const;

private:
  static constexpr std::size_t kept = 10;
  std::vector<std::string> first_;
  std::size_t total_ = 0;
};

} // namespace mdm
