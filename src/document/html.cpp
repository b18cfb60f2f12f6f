#include "document/html.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

namespace mdm {

std::string html_text(std::string_view text) {
  std::string shown;
  for (const char c : printable(text)) {
    switch (c) {
    case '&':
      shown += "&amp;";
      break;
    case '<':
      shown += "&lt;";
      break;
    case '>':
      shown += "&gt;";
      break;
    case '"':
      shown += "&quot;";
      break;
    default:
      shown += c;
    }
  }
  return shown;
}

HtmlTable::HtmlTable(std::string_view caption, const std::vector<std::string> &titles) {
  html_ = fmt::format("<table><caption>{}</caption>\n<thead><tr>", html_text(caption));
  for (const std::string &title : titles)
    html_ += fmt::format("<th scope=\"col\">{}</th>", html_text(title));
  html_ += "</tr></thead>\n<tbody>\n";
}

void HtmlTable::add(const std::vector<std::string> &cells, std::string_view kind) {
  html_ += kind.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", html_text(kind));
  bool is_first = true;
  for (const std::string &cell : cells) {
    html_ += is_first ? fmt::format("<th scope=\"row\">{}</th>", html_text(cell))
                      : fmt::format("<td>{}</td>", html_text(cell));
    is_first = false;
  }
  html_ += "</tr>\n";
}

} // namespace mdm
