#pragma once
/// \file
/// The index numbers of a description, as all its forms show them.

#include "soil/describe.hpp"

#include <string>
#include <utility>
#include <vector>

namespace mdm {

/// A number, or a range in which it lies.
struct DescriptionItem {
  std::string key;  ///< in JSON and CSV
  std::string name; ///< in text; empty: a note says it there
  const char *unit;
  std::optional<RealRange> value; ///< nothing: not available
  bool is_range = false;
};

/// All but the diameters that were asked for.
std::vector<DescriptionItem> usual_items(const SoilDescription &d);
/// All: the diameters that were asked for come after D60.
std::vector<DescriptionItem> items_of(const SoilDescription &d);
/// D_p.
DescriptionItem item_of(const DiameterAt &at);

/// Decimals below and above the number or range, of so many significant digits.
std::optional<std::pair<std::string, std::string>> bounds_of(const DescriptionItem &i, unsigned digits);
/// For people, without the unit: a number is rounded, the ends of a range are rounded outwards; empty where
/// it is not available.
std::string shown_item(const DescriptionItem &i, unsigned digits);

/// The group index of AASHTO M 145; empty where it is not known.
std::string group_index(const SoilDescription &d);
/// `A-2-6 (1)`, the group index in brackets as the standard writes it; empty where there is no group.
std::string aashto_symbol(const SoilDescription &d);

} // namespace mdm
