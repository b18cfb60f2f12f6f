#include "text/lines.hpp"

#include "text/file_names.hpp"

#include <algorithm>

namespace mdm {
namespace {

void skip_blanks(std::string_view &text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
}

/// Moves a quoted field from the front of `rest` to `field`.
/// \return false if its closing quote is missing
bool take_quoted(std::string_view &rest, std::string &field) {
  rest.remove_prefix(1);
  for (;;) {
    const std::size_t quote = rest.find('"');
    if (quote == std::string_view::npos)
      return false;
    const bool doubled = rest.substr(quote + 1).starts_with('"');
    field += rest.substr(0, doubled ? quote + 1 : quote);
    rest.remove_prefix(doubled ? quote + 2 : quote + 1);
    if (!doubled)
      return true;
  }
}

} // namespace

std::string_view without_byte_order_mark(std::string_view content) {
  constexpr std::string_view mark = "\uFEFF";
  if (content.starts_with(mark))
    content.remove_prefix(mark.size());
  return content;
}

std::string stem(std::string_view file) {
  file.remove_prefix(name_begin(file));
  const std::size_t dot = file.rfind('.');
  return std::string(dot == 0 ? file : file.substr(0, dot));
}

std::string_view trimmed(std::string_view text) {
  skip_blanks(text);
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

std::vector<std::string> between_commas(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    parts.emplace_back(text.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

bool are_alike(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char one, char other) { return lower(one) == lower(other); });
}

bool is_pan(std::string_view text) {
  return are_alike(text, "pan");
}

bool Lines::next() {
  if (rest_.empty())
    return false;
  const std::size_t end = rest_.find('\n');
  text_ = rest_.substr(0, end);
  if (end == std::string_view::npos) {
    rest_ = {};
  } else {
    rest_.remove_prefix(end + 1);
    if (text_.ends_with('\r'))
      text_.remove_suffix(1);
  }
  ++number_;
  return true;
}

std::string unquoted(std::string_view field) {
  if (field.size() < 2 || field.front() != '"' || field.back() != '"')
    return std::string(field);
  std::string_view rest = field;
  std::string text;
  return take_quoted(rest, text) && rest.empty() ? text : std::string(field.substr(1, field.size() - 2));
}

bool split_fields(std::string_view line, char delimiter, std::vector<std::string> &fields) {
  fields.clear();
  for (std::string_view rest = line;;) {
    skip_blanks(rest);
    std::string &field = fields.emplace_back();
    if (rest.starts_with('"')) {
      if (!take_quoted(rest, field))
        return false;
      skip_blanks(rest);
      if (!rest.empty() && rest.front() != delimiter)
        return false;
    } else {
      field = trimmed(rest.substr(0, rest.find(delimiter)));
    }
    const std::size_t end = rest.find(delimiter);
    if (end == std::string_view::npos || fields.size() == max_fields)
      return true;
    rest.remove_prefix(end + 1);
  }
}

} // namespace mdm
