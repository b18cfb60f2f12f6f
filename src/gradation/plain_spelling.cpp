#include "gradation/plain_spelling.hpp"

#include "text/lines.hpp"

#include <algorithm>

namespace mdm {

std::string spelled_plainly(std::string_view text, std::span<const Spelling> spellings) {
  std::string plain;
  while (!text.empty()) {
    const auto found = std::find_if(spellings.begin(), spellings.end(),
                                    [text](const Spelling &s) { return text.starts_with(s.written); });
    if (found == spellings.end()) {
      plain += lower(text.front());
      text.remove_prefix(1);
    } else {
      plain += found->plain;
      text.remove_prefix(found->written.size());
    }
  }
  return plain;
}

} // namespace mdm
