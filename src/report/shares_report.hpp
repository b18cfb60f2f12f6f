#pragma once
/// \file
/// The shares of a gradation by mass and by number, as text, JSON and CSV.

#include "soil/number_shares.hpp"

#include <string>

namespace mdm {

/// The shares of a gradation of one kind, and what they are of the other.
struct ClassShares {
  Gradation gradation; ///< its masses are the shares that are given
  ShareOf given;
  std::vector<RealRange> other; ///< one a class, ascending, of the whole
};

/// \throws InputError as other_shares
ClassShares class_shares(Gradation gradation, ShareOf given);

/// In percent; the ends of ranges are rounded outwards to so many significant digits.
std::string shares_text(const ClassShares &s, unsigned digits);
/// mdm-shares-1.
std::string shares_json(const ClassShares &s, unsigned digits);
std::string shares_csv(const ClassShares &s, unsigned digits);

} // namespace mdm
