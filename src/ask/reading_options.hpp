#pragma once
/// \file
/// The options that say how a gradation file is to be read, as texts.

#include "ask/option_row.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <string>
#include <vector>

namespace mdm {

struct ReadingTexts {
  OptionText specimen_id, columns, kind, unit, skip, sheet, loss, round;

  static const std::vector<OptionRow<ReadingTexts>> options;

  /// The first of them that is given, as messages name it; empty if there is none.
  std::string given() const;
  bool is_given() const { return !given().empty(); }
  /// True if none but unit is given, or none.
  bool is_unit_at_most() const;
  /// All that are given as words of a command, for sh, with a space before each.
  std::string words() const;
  /// \throws InputError naming the option where its value does not serve
  Reading reading(PhiReading phi = PhiReading::exact) const;
};

} // namespace mdm
