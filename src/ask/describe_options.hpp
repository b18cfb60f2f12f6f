#pragma once
/// \file
/// The options of a description, as texts.

#include "ask/soil_options.hpp"

namespace mdm {

struct DescribeTexts {
  SoilTexts soil;
  OptionText percents, void_ratio;

  /// All but those of the soil.
  static const std::vector<OptionRow<DescribeTexts>> options;

  /// \throws InputError naming the option where its value does not serve
  DescribeOptions describe_options() const;
};

} // namespace mdm
