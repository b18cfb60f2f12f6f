#include "gradation/row_ranges.hpp"

#include "gradation/cells.hpp"
#include "gradation/shown.hpp"
#include "text/lines.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

bool is_digit_or_sign(char c) {
  return is_digit(c) || c == '.' || c == ',';
}

/// A dash between numbers is one behind a digit or a unit and before a digit; that of `1-1/2` is none.
std::size_t dash_between_numbers(std::string_view cell) {
  const std::size_t at = cell.find('-');
  if (at == 0 || at == std::string_view::npos || cell.find('/') != std::string_view::npos)
    return std::string_view::npos;
  const std::string_view before = without_spaces(cell.substr(0, at)),
                         behind = without_spaces(cell.substr(at + 1));
  const bool is_between = !before.empty() && !behind.empty() && is_digit_or_sign(behind.front()) &&
                          is_digit_or_sign(before.front()) &&
                          (is_digit(before.back()) || before.back() == 'm');
  return is_between ? at : std::string_view::npos;
}

} // namespace

std::optional<std::pair<std::string_view, std::string_view>> range_ends(std::string_view cell) {
  constexpr std::array<std::string_view, 6> words = {"\u2013", "\u2014", " to ", " bis ", " - ", " a "};
  const auto ends = [cell](std::size_t at, std::size_t length) {
    return std::pair(without_spaces(cell.substr(0, at)), without_spaces(cell.substr(at + length)));
  };
  for (const std::string_view word : words)
    if (const std::size_t at = cell.find(word); at != std::string_view::npos)
      if (const auto both = ends(at, word.size()); has_digit(both.first) && has_digit(both.second))
        return both;
  const std::size_t dash = dash_between_numbers(cell);
  return dash == std::string_view::npos ? std::nullopt : std::optional(ends(dash, 1));
}

void SizeRanges::add(std::size_t row, Rational end, Rational other_end) {
  if (end > other_end)
    std::swap(end, other_end);
  all_.push_back({row, std::move(end), std::move(other_end)});
}

void SizeRanges::settle(Table &table, bool are_retained, const Source &source) const {
  if (all_.empty())
    return;
  const auto refuse = [&](std::size_t row, const std::string &what) {
    source.refuse(table.lines[row], what);
  };
  if (!are_retained)
    refuse(
        all_.front().row,
        "the sizes are ranges, but the values are not what is retained between two sieves: give each value "
        "its one sieve");
  std::vector<Range> ranges = all_;
  std::stable_sort(ranges.begin(), ranges.end(),
                   [](const Range &a, const Range &b) { return a.lower < b.lower; });
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (ranges[i].lower == ranges[i].upper)
      refuse(ranges[i].row, "the range begins where it ends: give two sieves");
    if (i > 0 && ranges[i - 1].upper != ranges[i].lower)
      refuse(ranges[i].row,
             fmt::format(
                 "the range from {} does not begin where the next finer one ends, at {}: correct one of them",
                 shown(ranges[i].lower), shown(ranges[i - 1].upper)));
  }
  const Rational top = ranges.back().upper;
  bool has_top = false;
  for (std::size_t row = 0; row < table.sizes.size(); ++row) {
    const bool is_range =
        std::any_of(all_.begin(), all_.end(), [row](const Range &range) { return range.row == row; });
    has_top |= !is_range && table.sizes[row] == top;
    if (!is_range && table.sizes[row] != 0 && table.sizes[row] != top)
      refuse(row, "some sizes are ranges and this is none: write all alike");
  }
  table.notes.emplace_back("Sizes are ranges: each mass stays on the lower sieve.");
  if (has_top)
    return;
  table.lines.push_back(table.lines[ranges.back().row]);
  table.sizes.push_back(top);
  table.values.emplace_back(0);
  table.roundings.emplace_back(0);
}

} // namespace mdm
