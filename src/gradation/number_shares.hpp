#pragma once
/// \file
/// Words that say that the shares of a table are by number, or by surface or length.

#include "gradation/cells.hpp"

namespace mdm {

/// True for `Number distribution` and `Distribution base Number`.
bool speaks_of_number_shares(std::string_view text);

/// True where the label asks what shares are of, and the value says that it is no mass and no volume: `Result
/// units`, `Number`; `Verteilungsart`, `Anzahl`; `Basis`, `Surface area`.
bool states_other_shares(std::string_view label, std::string_view value);

inline constexpr std::string_view number_shares_remedy =
    "export them by volume, or write canonical CSV with the column number_percent";

/// Refuses a table where one of so many rows above it, in a cell or in two, speaks of shares by number,
/// surface or length.
void refuse_number_shares(const Cells &cells, std::size_t above, const Source &source);

} // namespace mdm
