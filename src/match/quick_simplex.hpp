#pragma once
/// \file
/// Linear programs in double precision: a guide for exact arithmetic, which decides.

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace mdm {

/// The dual simplex method with bounds on variables and on linear forms of them, in doubles: what it finds
/// may be wrong, and is to be verified. Numbers should be near 1. Cost: a pivot is a pass over a dense table
/// of forms times variables.
class QuickSimplex {
public:
  static constexpr double unbounded = std::numeric_limits<double>::infinity();
  using Terms = std::vector<std::pair<std::size_t, double>>;

  /// Variables are numbered from 0: first the given ones, without bounds, then the forms.
  explicit QuickSimplex(std::size_t variables);

  /// Adds the form sum coefficient * variable over variables that are no forms; its number.
  std::size_t add_form(const Terms &terms);
  void set_lower(std::size_t variable, double bound) { lower_[variable] = bound; }
  void set_upper(std::size_t variable, double bound) { upper_[variable] = bound; }

  /// Moves to the least value of `aim`, a variable with a lower bound, once all forms are there. False if no
  /// values within all bounds were found. Ends early where `aim` must be above `enough`, with a value that
  /// is.
  bool minimise(std::size_t aim, double enough = unbounded);
  double value(std::size_t variable) const { return values_[variable]; }

private:
  double cost(std::size_t aim, std::size_t column) const;
  std::optional<std::size_t> most_violated_row() const;
  std::optional<std::size_t> entering(std::size_t row, bool rise, std::size_t aim) const;
  void move(std::size_t column, double by);
  void exchange(std::size_t row, std::size_t column);
  void place_columns(std::size_t aim);
  double *row(std::size_t r) { return table_.data() + r * variables_; }
  const double *row(std::size_t r) const { return table_.data() + r * variables_; }

  std::size_t variables_;
  std::vector<double> table_; ///< basic variables as forms of the columns' variables
  std::vector<std::size_t> basic_, columns_;
  std::vector<std::size_t> place_; ///< of a variable: its column, or variables_ + its row
  std::vector<double> lower_, upper_, values_;
};

} // namespace mdm
