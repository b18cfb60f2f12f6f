#pragma once
/// \file
/// Text in XML and HTML.

#include <string>
#include <string_view>

namespace mdm {

/// The text as the content of an element: `&amp;`, `&lt;` and `&gt;` for the marks of XML.
std::string xml_text(std::string_view text);

} // namespace mdm
