#pragma once
/// \file
/// The options of what soil mechanics says of a gradation, as texts.

#include "ask/option_row.hpp"
#include "soil/describe.hpp"

#include <vector>

namespace mdm {

struct SoilTexts {
  OptionText liquid_limit, plastic_limit, pan_size;
  bool extrapolate = false;

  static const std::vector<OptionRow<SoilTexts>> options;

  /// \throws InputError naming the option where its value does not serve, or one limit without the other
  DescribeOptions describe_options() const;
  /// The gradation with the pan that was asked for. \throws InputError where that cannot be
  Gradation with_pan(const Gradation &g) const;
};

} // namespace mdm
