#include "text/text_table.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// The characters of a text in UTF-8, whose further bytes begin with the bits 10.
std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

} // namespace

std::string text_table(const std::vector<std::vector<std::string>> &lines, std::string_view alignment) {
  std::vector<std::size_t> width;
  for (const std::vector<std::string> &line : lines) {
    width.resize(std::max(width.size(), line.size()));
    for (std::size_t i = 0; i < line.size(); ++i)
      width[i] = std::max(width[i], characters(line[i]));
  }
  std::string text;
  for (const std::vector<std::string> &line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string padding(width[i] - characters(line[i]), ' ');
      const bool left = alignment[std::min(i, alignment.size() - 1)] == '<';
      text.append("  ").append(left ? line[i] + padding : padding + line[i]);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

void TextTable::add_column(const std::string &title, char align) {
  lines_.front().push_back(title);
  alignment_ += align;
}

std::string csv_field(std::string_view text) {
  const std::string field = printable(text);
  const auto is_space = [](char c) { return c == ' '; }; // readers cut them off at both ends
  const bool has_margin = !field.empty() && (is_space(field.front()) || is_space(field.back()));
  if (field.find_first_of(",\"") == std::string::npos && !has_margin)
    return field;
  std::string quoted = "\"";
  for (const char c : field)
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

} // namespace mdm
