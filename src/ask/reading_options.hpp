#pragma once
/// \file
/// The options that say how a gradation file is to be read, as texts.

#include "ask/option_row.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <vector>

namespace mdm {

struct ReadingTexts {
  OptionText specimen_id, columns, kind, unit, skip, sheet, loss, round;

  static const std::vector<OptionRow<ReadingTexts>> options;

  /// \throws InputError naming the option where its value does not serve
  Reading reading(PhiReading phi = PhiReading::exact) const;
};

} // namespace mdm
