#pragma once
/// \file
/// Rows of what is retained between two sieves.

#include "gradation/table.hpp"

#include <optional>
#include <string_view>
#include <utility>

namespace mdm {

/// The two ends of `4.75-2.36`, `2.36 to 4.75` or `4.75 mm - 2.36 mm`, as texts; nothing for other cells.
std::optional<std::pair<std::string_view, std::string_view>> range_ends(std::string_view cell);

/// The ranges among the rows of a table.
class SizeRanges {
public:
  /// Of the table's next row. Its size is the smaller end, in the unit of the table.
  void add(std::size_t row, Rational end, Rational other_end);

  /// The mass between two sieves stays on the lower one; the upper end of the coarsest range is a sieve that
  /// retains nothing, and becomes a row. Does nothing where there are no ranges.
  /// \throws InputError where ranges leave gaps or overlap, other sizes are among them, or the values are not
  /// what is retained
  void settle(Table &table, bool are_retained, const Source &source) const;

  bool empty() const { return all_.empty(); }
  const Rational &lower() const { return all_.back().lower; }

private:
  struct Range {
    std::size_t row;
    Rational lower, upper;
  };
  std::vector<Range> all_;
};

} // namespace mdm
