#pragma once
/// \file
/// How the cells of a workbook are shown, as far as it changes what they mean.

#include <pugixml.hpp>

#include <vector>

namespace mdm {

/// What a cell shows of its number.
enum class CellStyle { plain, percent, date };

/// The styles by the index that cells have; `root` is that of xl/styles.xml.
std::vector<CellStyle> cell_styles(pugi::xml_node root);

} // namespace mdm
