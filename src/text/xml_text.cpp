#include "text/xml_text.hpp"

namespace mdm {

std::string xml_text(std::string_view text) {
  std::string shown;
  for (const char c : text) {
    if (c == '&')
      shown += "&amp;";
    else if (c == '<')
      shown += "&lt;";
    else if (c == '>')
      shown += "&gt;";
    else
      shown += c;
  }
  return shown;
}

} // namespace mdm
