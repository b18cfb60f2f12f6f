#pragma once
/// \file
/// Gradations made of others, exactly, with what was done to them.

#include <mdm/gradation/gradation.hpp>

namespace mdm {

/// A gradation and how it was made, a sentence a line. All masses are decimals if those were of which it was
/// made: where a share is none, all masses are multiplied by one integer, which the history says.
struct Regraded {
  Gradation gradation;
  std::vector<std::string> history;
};

// Sizes are in the gradation's unit. All throw InputError where a size is no exact cut (exact_cut.hpp),
// where nothing would be left, and where openings are irrational; all but `parallel` also for a column of
// tolerances, which are of the shares as they were.

/// Without the grains above `size`.
Regraded scalped(const Gradation &g, const Rational &size);

/// Grains above a size are replaced by as much mass between two others.
struct Replacement {
  Rational above, from, to; ///< from < to <= above
};

/// The classes in (from, to] are multiplied by one number, so that the mass above is theirs.
Regraded replaced(const Gradation &g, const Replacement &r);

/// All sizes times `factor` > 0: the parallel gradation.
Regraded parallel(const Gradation &g, const Rational &factor);

/// \throws InputError if g has tolerances
void refuse_tolerances(const Gradation &g);

/// Multiplies all masses by the least integer that makes them decimals.
/// \return that integer
Integer make_decimals(std::vector<Rational> &masses);

/// The history's sentence about such an integer; nothing for 1.
void add_multiple(std::vector<std::string> &history, const Integer &multiple);

/// A share as a percent, `15.5 %`, or `about 33.33 %` where that is not all of it.
std::string shown_percent(const Rational &share);

/// The history as comments of canonical CSV.
std::string history_comments(const std::vector<std::string> &history);

} // namespace mdm
