#pragma once
/// \file
/// The linear program of a match within a tolerance, in double precision.

#include "match/certain_bound.hpp"
#include "match/quick_simplex.hpp"

namespace mdm {

/// Counts and masses without whole numbers, the number of particles least. Counts and masses are in units in
/// which they are about 1. What it finds steers exact arithmetic.
class TolerantRelaxation {
public:
  /// \param typical  about how many particles the classes have
  TolerantRelaxation(const TolerantProblem &problem, const std::vector<double> &typical, const Watch &watch);

  /// The bounds on counts that are in force, and the most particles of interest.
  void set(const CountBounds &bounds, const std::optional<Integer> &most);
  /// False if there seems to be nothing within these bounds, or soon after the watch's end.
  bool minimise() { return is_feasible_ = program_.minimise(count_); }
  /// As well as the numbers allow.
  void refresh() { program_.refresh(); }
  /// What shows that there is nothing, or no less than was found.
  std::vector<Steering> steering() const;

  double typical(std::size_t j) const { return counts_[j]; }
  double count(std::size_t j) const { return program_.value(j) * counts_[j]; }
  double mass(std::size_t j) const { return program_.value(k_ + j) * masses_[j]; }
  double particles() const { return program_.value(count_) * count_scale_; }

  /// By how much the number of particles rises at least if classes i to j together hold one more, or one
  /// less: i and j one after the other for fixed i or j make this cheap.
  class Row {
  public:
    void add(const TolerantRelaxation &of, std::size_t j) { of.program_.add_to(row_, j, of.counts_[j]); }
    double price(const TolerantRelaxation &of, bool rise) const {
      return of.program_.price(of.count_, row_, rise) * of.count_scale_;
    }

  private:
    QuickSimplex::Row row_;
  };

private:
  /// A form of the program: `scale` times it is the condition's left side.
  struct Form {
    TolerantCondition condition;
    std::size_t i, j;
    double scale;
  };
  void add_row(const LinearRow &row);
  std::size_t sum_form(std::size_t i, std::size_t j);

  const TolerantProblem &problem_;
  std::size_t k_;
  std::vector<double> counts_, masses_; ///< scales
  QuickSimplex program_;
  std::vector<Form> forms_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> sums_; ///< numbers of forms
  std::vector<std::size_t> strict_;                                 ///< forms of above_lower
  std::size_t count_ = 0;
  double count_scale_ = 1;
  double mass_scale_ = 1;
  bool is_feasible_ = false;
};

} // namespace mdm
