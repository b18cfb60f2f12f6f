#pragma once
/// \file
/// mdm describe of the shares by mass and by number.

#include "cli/output_flags.hpp"
#include "report/shares_report.hpp"

#include <optional>
#include <string>

namespace mdm::cli {

/// True for a file of shares by number; standard input is not looked at.
bool is_number_file(const std::string &path);

/// The shares of the mass of a file of shares by number.
/// \throws InputError naming the file
ClassShares shares_of_mass(const std::string &path);

/// Writes the shares of both kinds.
void describe_shares(const ClassShares &shares, const OutputFlags &output, std::optional<unsigned> digits);

} // namespace mdm::cli
