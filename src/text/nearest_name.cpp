#include "text/nearest_name.hpp"

#include "text/lines.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace mdm {
namespace {

constexpr std::size_t longest = 100; // bytes: a longer word is meant to be something else

/// The least number of letters to put in, leave out or replace (Levenshtein).
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = std::exchange(row[j + 1], std::min({replaced, row[j] + 1, row[j + 1] + 1}));
    }
  }
  return row.back();
}

} // namespace

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names) {
  std::string_view nearest;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  if (word.size() > longest)
    return nearest;
  for (const std::string_view name : names) {
    const std::size_t common = std::min(word.size(), name.size()),
                      length = std::max(word.size(), name.size());
    const std::size_t n = edits(word, name);
    const bool is_near =
        2 * n <= length || (common >= 4 && edits(word.substr(0, common), name.substr(0, common)) == 0);
    if (is_near && n < least) {
      least = n;
      nearest = name;
    }
  }
  return nearest;
}

} // namespace mdm
