#include "cli/sample_files.hpp"

namespace mdm::cli {

void SampleFiles::add_to(CLI::App &command, const std::string &name, const std::string &more_help) {
  command
      .add_option(
          name, paths,
          "gradations (any that mdm convert reads), sets of mdm generate, or files of particles as mdm "
          "verify reads; - for standard input" +
              more_help)
      ->required();
  command.add_flag("--all-sheets", all_sheets,
                   "each sheet of a workbook in which something is written, and each specimen of AGS4, is a "
                   "sample of its own");
}

} // namespace mdm::cli
