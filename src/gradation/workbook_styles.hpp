#pragma once
/// \file
/// How the cells of a workbook are shown, as far as it changes what they mean.

#include <pugixml.hpp>

#include <string>
#include <vector>

namespace mdm {

enum class CellKind { plain, percent, date };

/// What a format shows of a number that is not negative.
struct CellStyle {
  CellKind kind = CellKind::plain;
  std::string before = {}, behind = {}; ///< texts around the digits: `No. ` before, ` um` behind
};

/// The styles by the index that cells have; `root` is that of xl/styles.xml.
std::vector<CellStyle> cell_styles(pugi::xml_node root);

} // namespace mdm
