#include "files/read_samples.hpp"

#include "files/byte_source.hpp"
#include "files/paths.hpp"
#include "files/sample_file.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

namespace mdm {
namespace {

/// All gradations of a file.
std::vector<UnderstoodGradation> sheets_of(const std::string &path, const ReadingTexts &reading) {
  const std::string content = read_file(path, max_gradation_bytes), file = shown_name(path);
  std::vector<UnderstoodGradation> all;
  for (const Reading &one : readings_of(content, file, reading.reading(PhiReading::exact)))
    all.push_back(understand_gradation(content, file, one));
  return all;
}

} // namespace

ReadSamples read_samples(const std::vector<std::string> &paths, bool all_sheets, const ReadingTexts &reading,
                         bool quiet) {
  if (all_sheets && (reading.sheet || reading.specimen_id))
    throw InputError(option("all-sheets") + " reads all: leave out " + option("sheet") + " and " +
                     option("specimen-id"));
  ReadSamples read;
  for (const std::string &path : paths) {
    if (all_sheets && !is_sample_file(path))
      for (UnderstoodGradation &sheet : sheets_of(path, reading))
        read.samples.push_back(std::move(sheet));
    else
      read.samples.push_back(any_curve(path, reading, quiet));
    read.files.resize(read.samples.size(), path);
  }
  return read;
}

} // namespace mdm
