#pragma once
/// \file
/// The samples of a command that takes several.

#include "cli/reading_flags.hpp"
#include "files/read_samples.hpp"

namespace mdm::cli {

struct SampleFiles {
  std::vector<std::string> paths;
  bool all_sheets = false;

  void add_to(CLI::App &command, const std::string &name, const std::string &more_help = "");
  /// \throws InputError as read_samples
  ReadSamples read(const ReadingFlags &reading, bool quiet) const {
    return read_samples(paths, all_sheets, reading, quiet);
  }
};

} // namespace mdm::cli
