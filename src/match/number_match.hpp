#pragma once
/// \file
/// The smallest set of particles whose numbers, not masses, have the shares of a gradation.

#include <mdm/match/tolerance.hpp>

#include <cstdint>
#include <vector>

namespace mdm {

/// The smallest set, or what is known of it.
struct NumberMatch {
  std::vector<Integer>
      quantities;      ///< q_j of each class: within what is asked; exact where is_smallest is not
  Integer particles;   ///< their sum
  Integer lower_bound; ///< no set has fewer
  bool is_smallest() const { return particles == lower_bound; }
};

/// The classes times numbers of particles that a search within a tolerance looks at; mdm-check looks at as
/// many.
inline constexpr std::uint64_t max_number_steps = std::uint64_t{1} << 24;

/// The least N >= 1 for which integers q_j >= 0 with sum N have shares q_j / N that are those of the masses
/// of g, which hold numbers, or within the tolerances (Theorem 27). Where max_steps come first the set is the
/// exact one, and the bound says how far the search came.
/// \param asked retained, passing and total with a percentage; a total alone
/// \throws InputError for another tolerance
NumberMatch number_match(const Gradation &g, const std::vector<AskedTolerance> &asked,
                         std::uint64_t max_steps = max_number_steps);

} // namespace mdm
