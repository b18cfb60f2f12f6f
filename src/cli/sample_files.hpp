#pragma once
/// \file
/// The samples of a command that takes several.

#include "cli/reading_flags.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <string>
#include <vector>

namespace mdm::cli {

/// Samples, and of each the path of its file.
struct ReadSamples {
  std::vector<UnderstoodGradation> samples;
  std::vector<std::string> files;
};

struct SampleFiles {
  std::vector<std::string> paths;
  bool all_sheets = false;

  void add_to(CLI::App &command, const std::string &name, const std::string &more_help = "");
  /// \throws InputError naming the file
  ReadSamples read(const ReadingFlags &reading, bool quiet) const;
};

} // namespace mdm::cli
