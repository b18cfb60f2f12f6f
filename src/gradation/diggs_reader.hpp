#pragma once
/// \file
/// Gradations in DIGGS, the XML of ground investigations in the USA.

#include "gradation/table.hpp"

#include <optional>

namespace mdm {

/// Reads one ParticleSizeTest: the Grading elements in it, of its sieves and its hydrometer, each with
/// particleSize and percentPassing. It goes by its gml:id, or by the gml:id or the name of the Test around
/// it.
/// \throws InputError; where the program was built without pugixml, in any case
Table read_diggs(std::string_view text, const Source &source, const std::string &id,
                 const std::optional<std::string> &specimen);

} // namespace mdm
