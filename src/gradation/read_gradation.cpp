#include "ags4_reader.hpp"
#include "csv_reader.hpp"
#include "json_reader.hpp"
#include "text.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm {
namespace {

/// The content from its first character on that is no white space.
std::string_view without_leading_space(std::string_view content) {
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : content.substr(first);
}

} // namespace

bool is_ags4(std::string_view content) {
  return without_leading_space(without_byte_order_mark(content)).starts_with("\"GROUP\"");
}

Gradation read_gradation(std::string_view content, const std::string &file,
                         const std::optional<std::string> &specimen) {
  const Source source(file);
  source.check_length(content);
  const std::string_view text = without_byte_order_mark(content);
  if (is_ags4(content))
    return read_ags4(text, source, stem(file), specimen);
  if (specimen)
    source.refuse(1, "--specimen-id is for AGS4 files; this one holds a single gradation");
  source.check_text(text);
  if (without_leading_space(text).starts_with('{'))
    return read_json(text, source, stem(file));
  return read_csv(text, source, stem(file));
}

Gradation read_json_gradation(std::string_view content, const std::string &where,
                              const std::string &fallback_id) {
  const Source source(where, false);
  const std::string_view text = without_byte_order_mark(content);
  source.check_text(text);
  return read_json(text, source, fallback_id);
}

} // namespace mdm
