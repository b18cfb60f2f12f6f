#pragma once
/// \file
/// Sieves that were weighed with what they retain, and empty: two columns whose difference is a mass.

#include "gradation/cells.hpp"

#include <optional>

namespace mdm {

/// The places of two columns of masses.
struct WeighedSieves {
  std::size_t full;  ///< of sieves with what they retain
  std::size_t empty; ///< of the sieves alone
};

/// The two columns of a header such as `Mass of sieve + soil (g)` and `Mass of empty sieve (g)`; nothing
/// unless there is one of each.
std::optional<WeighedSieves> weighed_sieves(const CellRow &header);

/// True for a header such as `Tare (g)` or `Empty sieve (g)`.
bool names_empty_sieves(std::string_view header);
/// True for a header of masses that does not say of what: `Mass (g)`.
bool names_mass_alone(std::string_view header);

} // namespace mdm
