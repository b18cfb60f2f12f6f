#include "files/suite_lines.hpp"

#include "text/file_names.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {

std::vector<SuiteLine> read_suite(FileLines &lines, const std::string &path) {
  std::vector<SuiteLine> suite;
  std::uint64_t number = 0;
  for (std::vector<FileLines::Line> next = lines.next(1); !next.empty(); next = lines.next(1)) {
    const FileLines::Line &line = next.front();
    const std::string fallback_id = std::to_string(++number);
    const std::string where = line_name(path, number);
    if (!line)
      throw file_error(where, FileLines::too_long("the line") + ": write one gradation a line");
    if (!FileLines::is_blank(line))
      suite.push_back({number, read_json_gradation(*line, where, fallback_id)});
  }
  if (suite.empty())
    throw file_error(line_name(path, std::max<std::uint64_t>(number, 1)),
                     "there are no gradations up to here, the end: write one a line, as JSON");
  return suite;
}

} // namespace mdm
