#pragma once
/// \file
/// One of the samples in a file with several.

#include "text/source.hpp"

#include <optional>
#include <string>
#include <vector>

namespace mdm {

/// A sample of a file: all names that it goes by, the one that it is listed with first.
struct SampleNames {
  std::vector<std::string> names;
  std::size_t line = 1; ///< where it begins
};

/// The index of the sample that `wanted` names, or of the only one. A name that comes later in `names` serves
/// where no earlier one of any sample is it.
/// \pre samples is not empty
/// \throws InputError with the samples there are, where that is not one
std::size_t chosen_sample(const std::vector<SampleNames> &samples, const std::optional<std::string> &wanted,
                          const Source &source);

} // namespace mdm
