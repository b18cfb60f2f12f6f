#include "cli/sample_files.hpp"

#include "cli/sample_file.hpp"
#include "files/paths.hpp"
#include "text/option_name.hpp"

namespace mdm::cli {
namespace {

/// All gradations of a file.
std::vector<UnderstoodGradation> sheets_of(const std::string &path, const ReadingFlags &reading) {
  const std::string content = read_file(path, max_gradation_bytes), file = shown_name(path);
  std::vector<UnderstoodGradation> all;
  for (const Reading &one : readings_of(content, file, reading.reading(PhiReading::exact)))
    all.push_back(understand_gradation(content, file, one));
  return all;
}

} // namespace

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

ReadSamples SampleFiles::read(const ReadingFlags &reading, bool quiet) const {
  if (all_sheets && (reading.sheet || reading.specimen_id))
    throw InputError(option("all-sheets") + " reads all: leave out " + option("sheet") + " and " +
                     option("specimen-id"));
  ReadSamples read;
  for (const std::string &path : paths) {
    if (all_sheets && !is_sample_file(path))
      for (UnderstoodGradation &sheet : sheets_of(path, reading))
        read.samples.push_back(std::move(sheet));
    else
      read.samples.push_back(any_gradation(path, reading, quiet));
    read.files.resize(read.samples.size(), path);
  }
  return read;
}

} // namespace mdm::cli
