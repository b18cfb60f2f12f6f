#pragma once
/// \file
/// Gradations in AGS4, the ground investigation data format of the UK and New Zealand (group GRAT).

#include "gradation/table.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <optional>

namespace mdm {

/// Reads one specimen of group GRAT: the rows that share LOCA_ID and all columns SAMP_* and SPEC_*.
/// Other groups are not looked at. The gradation's id is the specimen's, or `fallback_id` if that is empty.
/// \param specimen the specimen's id, that is these values joined by `/` without the empty ones, or its LOCA_ID, SAMP_ID
/// or SAMP_REF where one of them is enough; needed where there are several
/// \throws InputError with the line
Table read_ags4(std::string_view content, const Source &source, const std::string &fallback_id,
                const std::optional<std::string> &specimen);

/// All specimens of the group, in the order of the file, each with its id.
/// \throws InputError with the line where rows cannot be told apart
std::vector<UnreadGradation> ags4_specimens(std::string_view content, const std::string &file,
                                            const std::string &fallback_id);

} // namespace mdm
