#pragma once
/// \file
/// Columns of a sheet whose headers are not understood and speak of the sample's mass all the same.

#include "gradation/sheet_accounts.hpp"

namespace mdm {

/// True for a header that may be of masses or shares of the sample: by a unit of mass or percent, or by words
/// alone such as `corrected` or `cum.`; not for one of limits, errors, an assay or what changes masses.
bool may_hold_values(std::string_view header);

/// True for a factor of each row, or its water content.
bool changes_masses(std::string_view header);

/// Refuses a column whose numbers are not those of the deciding column in any reading: as what each sieve
/// retains, as cumulative ones, as what passes, or as what stays below each size; nor with a tare, which is
/// that of one container or stands in another column. Where the user chose the column, `notes` says so
/// instead.
/// \throws InputError with the line of the header
void check_unread(const OrderedAccounts &accounts, std::size_t deciding, const Source &source,
                  std::vector<std::string> &notes);

} // namespace mdm
