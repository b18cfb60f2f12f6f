#include "gradation/workbook_styles.hpp"

#include "gradation/xml_tree.hpp"
#include "text/lines.hpp"

#include <map>
#include <string>

namespace mdm {
namespace {

/// What a format such as `0.0%` or `dd.mm.yyyy` shows; texts in it, in quotes or brackets or behind `\`, say
/// nothing.
CellStyle style_of(std::string_view format) {
  char closing = '\0';
  for (std::size_t i = 0; i < format.size(); ++i) {
    const char c = lower(format[i]);
    if (closing != '\0')
      closing = c == closing ? '\0' : closing;
    else if (c == '"' || c == '[')
      closing = c == '[' ? ']' : '"';
    else if (c == '\\' || c == '_')
      ++i;
    else if (c == '%')
      return CellStyle::percent;
    else if (c == 'd' || c == 'm' || c == 'y' || c == 'h' || c == 's')
      return CellStyle::date;
  }
  return CellStyle::plain;
}

/// The formats with numbers that every workbook has (ECMA-376, Part 1, 18.8.30).
CellStyle built_in(unsigned id) {
  if (id == 9 || id == 10)
    return CellStyle::percent;
  return (id >= 14 && id <= 22) || (id >= 45 && id <= 47) ? CellStyle::date : CellStyle::plain;
}

} // namespace

std::vector<CellStyle> cell_styles(pugi::xml_node root) {
  std::map<unsigned, CellStyle> formats;
  for_each_below(child_of(root, "numFmts"), "numFmt", [&formats](pugi::xml_node format) {
    formats[format.attribute("numFmtId").as_uint()] = style_of(format.attribute("formatCode").value());
  });
  std::vector<CellStyle> styles;
  for_each_below(child_of(root, "cellXfs"), "xf", [&](pugi::xml_node xf) {
    const unsigned id = xf.attribute("numFmtId").as_uint();
    const auto found = formats.find(id);
    styles.push_back(found == formats.end() ? built_in(id) : found->second);
  });
  return styles;
}

} // namespace mdm
