#include "document/html.hpp"

#include "text/xml_text.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {

std::string html_text(std::string_view text) {
  std::string shown = xml_text(printable(text));
  const std::string_view quote = "&quot;";
  for (std::size_t at = shown.find('"'); at != std::string::npos; at = shown.find('"', at + quote.size()))
    shown.replace(at, 1, quote);
  return shown;
}

std::string HtmlTable::html() const {
  constexpr std::size_t most_columns = 6; // behind the heads
  std::string html;
  for (std::size_t begin = heads_; begin < titles_.size() || html.empty(); begin += most_columns)
    html += part(begin, std::min(titles_.size(), begin + most_columns));
  return html;
}

std::string HtmlTable::part(std::size_t begin, std::size_t end) const {
  const auto in_part = [&](std::size_t i) { return i < heads_ || (i >= begin && i < end); };
  std::string html = fmt::format("<table><caption>{}</caption>\n<thead><tr>", html_text(caption_));
  for (std::size_t i = 0; i < titles_.size(); ++i)
    if (in_part(i))
      html += fmt::format("<th scope=\"col\">{}</th>", html_text(titles_[i]));
  html += "</tr></thead>\n<tbody>\n";
  for (const Line &line : lines_) {
    html += line.kind.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", html_text(line.kind));
    for (std::size_t i = 0; i < line.cells.size(); ++i)
      if (in_part(i))
        html += i == 0 ? fmt::format("<th scope=\"row\">{}</th>", html_text(line.cells[i]))
                       : fmt::format("<td>{}</td>", html_text(line.cells[i]));
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

} // namespace mdm
