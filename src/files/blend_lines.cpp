#include "files/blend_lines.hpp"

#include "text/file_names.hpp"

#include <algorithm>

namespace mdm {
namespace {

BlendLine read_line(const FileLines::Line &line, const std::string &path, std::uint64_t number) {
  BlendLine result{line_name(path, number), line.value_or(""), std::to_string(number), std::nullopt, ""};
  if (!line) {
    result.error = FileLines::too_long("the line") + ": write one problem a line";
    return result;
  }
  try {
    StatedBlendProblem stated = read_blend_problem(*line);
    if (!stated.id.empty())
      result.id = std::move(stated.id);
    result.problem = std::move(stated.problem);
  } catch (const InputError &e) {
    result.error = e.what();
    if (std::string id = stated_blend_id(*line); !id.empty())
      result.id = std::move(id);
  }
  return result;
}

} // namespace

bool begin_blends(FileLines &lines) {
  constexpr std::string_view white = " \t\r\n";
  constexpr std::size_t longest_look = std::size_t{1} << 20;
  std::string_view line;
  do {
    line = lines.look_further();
    line.remove_prefix(std::min(line.find_first_not_of(white), line.size()));
  } while (!lines.is_at_end() && line.find('\n') == std::string_view::npos && line.size() < longest_look);
  line = line.substr(0, line.find('\n'));
  constexpr std::string_view key = "\"stockpiles\"";
  const std::size_t at = line.find(key);
  if (at == std::string_view::npos)
    return false;
  const std::size_t next = line.find_first_not_of(white, at + key.size());
  return next != std::string_view::npos && line[next] == ':';
}

std::vector<BlendLine> read_blend_lines(FileLines &lines, const std::string &path) {
  std::vector<BlendLine> problems;
  std::uint64_t number = 0;
  for (std::vector<FileLines::Line> next = lines.next(1); !next.empty(); next = lines.next(1)) {
    ++number;
    if (!FileLines::is_blank(next.front()))
      problems.push_back(read_line(next.front(), path, number));
  }
  if (problems.empty())
    throw file_error(line_name(path, std::max<std::uint64_t>(number, 1)),
                     "there are no problems up to here, the end: write one a line, as JSON");
  return problems;
}

} // namespace mdm
