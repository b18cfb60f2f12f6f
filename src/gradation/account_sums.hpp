#pragma once
/// \file
/// The sums of a laboratory's sheet, compared with what it says of them.

#include "gradation/account_comparison.hpp"

namespace mdm {

/// Compares what the rows add up to with totals, with the masses before and after washing, with losses and
/// with the whole of percent. What is found goes to `notes`.
/// \return true where a sum that the sheet states is that of its rows
/// \throws InputError where they differ by more than may be lost, or what was washed out is missing
bool check_sums(const OrderedAccounts &accounts, const ColumnsCompared &compared, const Source &source,
                std::vector<std::string> &notes);

} // namespace mdm
