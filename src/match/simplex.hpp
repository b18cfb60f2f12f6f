#pragma once
/// \file
/// Linear programs, decided exactly and with strict bounds.

#include "match/watch.hpp"

#include <mdm/number/rational.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace mdm {

/// value + tiny * eps for an infinitesimal eps > 0: x > 0 is x >= eps (Dutertre and de Moura, "A fast
/// linear-arithmetic solver for DPLL(T)", 2006).
struct Infinitesimal {
  Rational value = 0;
  Rational tiny = 0;

  friend bool operator==(const Infinitesimal &a, const Infinitesimal &b) {
    return a.value == b.value && a.tiny == b.tiny;
  }
  friend bool operator<(const Infinitesimal &a, const Infinitesimal &b) {
    return a.value < b.value || (a.value == b.value && a.tiny < b.tiny);
  }
};

/// Bounds on variables and on linear forms of them, which are changed and restored as a search tree is
/// walked. All numbers are exact. Cost: a pivot is a pass over a dense table of forms times variables.
class Simplex {
public:
  /// Variables are numbered from 0: first the given ones, without bounds, then the forms.
  /// Soon after the watch's end, within the work on one row, all that takes long throws Interrupted.
  explicit Simplex(std::size_t variables, Watch watch = {});

  /// Thrown at the watch's end, after which the object is of no use.
  struct Interrupted {};

  /// Adds the form sum coefficient * variable over earlier variables that are no forms; its number.
  std::size_t add_form(const std::vector<std::pair<std::size_t, Rational>> &terms);
  /// Makes another form of one that never had bounds.
  void change_form(std::size_t form, const std::vector<std::pair<std::size_t, Rational>> &terms);

  using Bound = std::optional<Infinitesimal>;
  /// Sets a bound, or removes it.
  void set_lower(std::size_t variable, const Bound &bound);
  void set_upper(std::size_t variable, const Bound &bound);
  const Bound &lower(std::size_t variable) const { return lower_[variable]; }
  const Bound &upper(std::size_t variable) const { return upper_[variable]; }

  /// Finds values within all bounds. Where there are none, conflict() says why. Values on the way to the
  /// least of `aim` are preferred: after bounds have changed little, few pivots lead there, by the rule of
  /// the dual simplex method.
  bool find(std::size_t aim);
  /// Minimises a variable that has a lower bound, from values that find() has found.
  void minimise(std::size_t variable);

  const Infinitesimal &value(std::size_t variable) const { return values_[variable]; }
  /// The values of variables [from, to) with a number so small in the place of eps that all bounds still
  /// hold.
  std::vector<Rational> concrete_values(std::size_t from, std::size_t to) const;

  /// A bound in a contradiction: `multiplier` > 0 times (variable >= its lower bound) or (variable <= its
  /// upper).
  struct Term {
    std::size_t variable;
    bool is_upper;
    Rational multiplier;
  };
  /// Bounds whose sum, each with its multiplier, has 0 on the side of the variables and is false (Farkas).
  const std::vector<Term> &conflict() const { return conflict_; }

private:
  /// scale * basic = sum of_c * (variable of column c), in integers without a common divisor.
  struct Row {
    std::size_t basic;
    Integer scale; ///< > 0
    std::vector<Integer> of;
  };

  /// \throws Interrupted after the watch's end
  void look() const;
  void define(std::size_t form, Row &row, const std::vector<std::pair<std::size_t, Rational>> &terms);
  std::size_t column_of(std::size_t variable) const;
  bool is_below(std::size_t variable) const;
  bool is_above(std::size_t variable) const;
  bool can_rise(std::size_t variable) const;
  bool can_fall(std::size_t variable) const;
  void move(std::size_t column, const Infinitesimal &by);
  void settle(std::size_t variable);
  void pivot(std::size_t row, std::size_t column);
  std::optional<std::size_t> violated_row(bool by_bland) const;
  bool can_move(const Row &row, std::size_t column, bool rise) const;
  std::optional<std::size_t> least_entering(const Row &row, bool rise) const;
  std::optional<std::size_t> cheapest_entering(const Row &row, bool rise, std::size_t aim) const;
  void explain(const Row &row, bool rise);
  bool step(std::size_t column, bool rise);

  Watch watch_;
  std::vector<Row> rows_;
  std::vector<std::size_t> columns_;               ///< variable of each column
  std::vector<std::optional<std::size_t>> row_of_; ///< of basic variables
  std::vector<Bound> lower_, upper_;
  std::vector<Infinitesimal> values_;
  std::vector<Term> conflict_;
};

} // namespace mdm
