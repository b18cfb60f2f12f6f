#include "gradation/workbook_styles.hpp"

#include "gradation/xml_tree.hpp"
#include "text/lines.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace mdm {
namespace {

/// Reads a format such as `0.0%`, `dd.mm.yyyy` or `0.0" um"`, up to the `;` where that of negative numbers
/// begins.
class Format {
public:
  explicit Format(std::string_view format) : rest_(format) {}

  CellStyle read() {
    while (!rest_.empty() && rest_.front() != ';')
      read_character();
    return std::move(style_);
  }

private:
  void read_character() {
    const char c = lower(take());
    if (c == '"')
      while (!rest_.empty() && rest_.front() != '"')
        show(take());
    if (c == '"' && !rest_.empty())
      take();
    else if (c == '[')
      take_brackets();
    else if (c == '\\' && !rest_.empty())
      show(take());
    else if ((c == '_' || c == '*') && !rest_.empty()) // room for a character, or what fills the cell
      take();
    else if (c == '%')
      style_.kind = CellKind::percent;
    else if (is_placeholder(c) || c == 'g') // of General
      has_digits_ = true;
    else if (std::string_view("dmyhs").find(c) != std::string_view::npos)
      style_.kind = CellKind::date;
    else if (c == '<' || c == '>')
      show(c);
    else if (c == ',' && has_digits_ && (rest_.empty() || !is_placeholder(rest_.front())))
      style_.behind += " in thousands";
  }

  static bool is_placeholder(char c) { return c == '0' || c == '#' || c == '?'; }

  /// A colour, a currency or a condition, which makes the format hold for some numbers only.
  void take_brackets() {
    if (rest_.starts_with('<') || rest_.starts_with('>') || rest_.starts_with('='))
      style_.behind += " on a condition";
    const std::size_t end = rest_.find(']');
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
  }

  char take() {
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }
  void show(char c) { (has_digits_ ? style_.behind : style_.before) += c; }

  std::string_view rest_;
  CellStyle style_;
  bool has_digits_ = false;
};

/// The formats with numbers that every workbook has (ECMA-376, Part 1, 18.8.30).
CellStyle built_in(unsigned id) {
  if (id == 9 || id == 10)
    return {CellKind::percent};
  return {(id >= 14 && id <= 22) || (id >= 45 && id <= 47) ? CellKind::date : CellKind::plain};
}

} // namespace

std::vector<CellStyle> cell_styles(pugi::xml_node root) {
  std::map<unsigned, CellStyle> formats;
  for_each_below(child_of(root, "numFmts"), "numFmt", [&formats](pugi::xml_node format) {
    formats[format.attribute("numFmtId").as_uint()] = Format(format.attribute("formatCode").value()).read();
  });
  std::vector<bool> are_struck; // of the fonts
  for_each_below(child_of(root, "fonts"), "font", [&are_struck](pugi::xml_node font) {
    const pugi::xml_node strike = child_of(font, "strike");
    are_struck.push_back(strike && strike.attribute("val").as_bool(true));
  });
  std::vector<CellStyle> styles;
  for_each_below(child_of(root, "cellXfs"), "xf", [&](pugi::xml_node xf) {
    const unsigned id = xf.attribute("numFmtId").as_uint(), font = xf.attribute("fontId").as_uint();
    const auto found = formats.find(id);
    styles.push_back(found == formats.end() ? built_in(id) : found->second);
    if (font < are_struck.size() && are_struck[font])
      styles.back().behind += " (struck out)";
  });
  return styles;
}

} // namespace mdm
