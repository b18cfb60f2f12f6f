#pragma once
/// \file
/// Files of the Coulter LS laser diffraction instruments (.$ls).

#include "gradation/table.hpp"

namespace mdm {

/// True where a line is `[#Bindiam]`.
bool is_coulter(std::string_view text);

/// Below `[#Bindiam]` there is a diameter in um a line, below `[#Binheight]` as many shares by volume; each
/// is the share between its diameter and the next, and the last is not used.
/// \throws InputError with the line
Table read_coulter(std::string_view text, const Source &source, const std::string &id);

} // namespace mdm
