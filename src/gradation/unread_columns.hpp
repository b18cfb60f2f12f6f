#pragma once
/// \file
/// Columns of a sheet whose headers are not understood and speak of the sample's mass all the same.

#include "gradation/sheet_accounts.hpp"

namespace mdm {

/// True for a header that speaks of masses or shares of the sample alone, by its unit or by a word such as
/// `corrected` or `cum.`; not for one of limits, empty sieves, an assay or the moisture.
bool may_hold_values(std::string_view header);

/// Refuses a column whose numbers are not those of the deciding column in any reading: as what each sieve
/// retains, as cumulative ones or as what passes. Where the user chose the column, `notes` says so instead.
/// \throws InputError with the line of the header
void check_unread(const OrderedAccounts &accounts, std::size_t deciding, const Source &source,
                  std::vector<std::string> &notes);

} // namespace mdm
