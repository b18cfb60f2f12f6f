#pragma once
/// \file
/// The samples of several files.

#include "ask/reading_options.hpp"

namespace mdm {

/// Samples, and of each the path of its file.
struct ReadSamples {
  std::vector<UnderstoodGradation> samples;
  std::vector<std::string> files;
};

/// The gradation of each file, as any_gradation has it, or with `all_sheets` of each sheet and specimen in
/// it.
/// \throws InputError naming the file, or the options that do not go together
ReadSamples read_samples(const std::vector<std::string> &paths, bool all_sheets, const ReadingTexts &reading,
                         bool quiet);

} // namespace mdm
