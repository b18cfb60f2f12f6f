#pragma once
/// \file
/// The shapes of the beta model and the particles that they take (Voivret, Delenne, Radjai, Figure 8).

#include "papers/size_models.hpp"
#include "sets/matched_set.hpp"

#include <chrono>

namespace mdm {

/// A grid of shapes and what a set of one must have.
struct AccessibleQuestion {
  std::vector<Rational> spans; ///< ascending, 0 < s < 1 (Eq. 17)
  std::vector<Rational> a, b;  ///< ascending
  Classing classing = Classing::geometric;
  unsigned classes = 10;
  Representativity wanted;
  Integer at_most = 10000;                             ///< N_max
  unsigned match_digits = 6;                           ///< of the gradation that is matched
  std::optional<std::chrono::milliseconds> time_limit; ///< of each match
};

/// The number of particles that a shape takes, counted in both ways.
struct AccessibleRow {
  Rational span;
  Shape shape;
  std::optional<Integer> paper; ///< max(sum N', N_min); nothing if not decided or beyond 10^1000
  std::optional<Integer> match; ///< N of the least match; nothing if there was a limit
  std::optional<bool> paper_accessible, match_accessible; ///< with N_max particles; nothing if not decided
  std::optional<Real> c_u, c_c;                           ///< of the curve; nothing if it is refused
  std::string why;                                        ///< something is not known
};

/// The shapes of the grid: spans, within them a, within them b.
std::vector<AccessibleRow> grid(const AccessibleQuestion &question);

/// Works out a row of the grid. Cost: some 10 milliseconds, more where a, b or the counts are extreme.
void fill(AccessibleRow &row, const AccessibleQuestion &question);

} // namespace mdm
