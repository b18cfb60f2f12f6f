#pragma once
/// \file
/// Linear programs in double precision: a guide for exact arithmetic, which decides.

#include "match/watch.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace mdm {

/// The dual simplex method with bounds on variables and on linear forms of them, in doubles: what it finds
/// may be wrong, and is to be verified. Bounds and forms may be changed and added between searches, each of
/// which begins where the last one ended. Numbers should be near 1. Cost: a pivot is a pass over a dense
/// table of forms times variables.
class QuickSimplex {
public:
  static constexpr double unbounded = std::numeric_limits<double>::infinity();
  using Terms = std::vector<std::pair<std::size_t, double>>;

  /// Variables are numbered from 0: first the given ones, without bounds, then the forms.
  explicit QuickSimplex(std::size_t variables, Watch watch = {});

  /// Adds the form sum coefficient * variable over variables that are no forms; its number.
  std::size_t add_form(const Terms &terms);
  void set_lower(std::size_t variable, double bound) { lower_[variable] = bound; }
  void set_upper(std::size_t variable, double bound) { upper_[variable] = bound; }

  /// Moves to the least value of `aim`, a variable at its lower bound or a form. False if no values within
  /// all bounds were found: conflict() says why, if it is not empty. Ends early where `aim` must be above
  /// `enough`, with a value that is.
  bool minimise(std::size_t aim, double enough = unbounded);
  double value(std::size_t variable) const { return values_[variable]; }
  std::size_t forms() const { return basic_.size(); }

  /// A bound: `multiplier` > 0 times (variable >= its lower bound) or (variable <= its upper).
  struct Term {
    std::size_t variable;
    bool is_upper;
    double multiplier;
  };
  /// Bounds whose sum contradicts itself, of a search that has failed.
  const std::vector<Term> &conflict() const { return conflict_; }
  /// Bounds whose sum is `form` >= its value, of a search for its least value.
  std::vector<Term> bounds_of(std::size_t form) const;
  /// A form that has no number: its coefficients at the columns.
  using Row = std::vector<double>;
  void add_to(Row &row, std::size_t variable, double coefficient) const;
  /// How much more `aim` is where a row's value rises, or falls, by 1: as a first step of a search would tell
  /// (Driebeek, "An algorithm for the solution of mixed integer programming problems", 1966). Unbounded if it
  /// cannot.
  double price(std::size_t aim, const Row &row, bool rise) const;

  /// Makes the table anew from the forms: errors of many pivots are gone.
  void refresh();

private:
  const double *cost_of(std::size_t aim) const;
  std::optional<std::size_t> most_violated_row() const;
  std::optional<std::size_t> entering(std::size_t row, bool rise, std::size_t aim) const;
  std::vector<Term> terms_of(std::size_t row, bool rise) const;
  void move(std::size_t column, double by);
  void exchange(std::size_t row, std::size_t column);
  void place_columns(std::size_t aim);
  double *row(std::size_t r) { return table_.data() + r * variables_; }
  const double *row(std::size_t r) const { return table_.data() + r * variables_; }

  std::size_t variables_;
  Watch watch_;
  std::vector<Terms> forms_;
  std::vector<double> table_; ///< basic variables as forms of the columns' variables
  std::vector<std::size_t> basic_, columns_;
  std::vector<std::size_t> place_; ///< of a variable: its column, or variables_ + its row
  std::vector<double> lower_, upper_, values_;
  std::vector<Term> conflict_;
  std::size_t pivots_ = 0; ///< since the table was made
};

} // namespace mdm
