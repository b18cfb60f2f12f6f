#pragma once
/// \file
/// What a comment of a file of particles says of the numbers in it.

#include <mdm/gradation/size_unit.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// The words of a line, behind the # that it may begin with.
std::vector<std::string> words_behind_hash(std::string_view line);

/// The unit of lengths that a word names, such as `mm`, `(um)`, `metres;` or `units=mm`.
std::optional<SizeUnit> unit_in_word(std::string_view word);

/// The units that a comment names: `mm` and `um` anywhere, `m` and `in` where they are clear, as in `in m`,
/// `units: in`, `(m)` and `radius_m`.
std::vector<SizeUnit> units_in_comment(const std::vector<std::string_view> &words);

} // namespace mdm
