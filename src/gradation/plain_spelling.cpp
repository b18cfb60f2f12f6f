#include "gradation/plain_spelling.hpp"

#include "text/lines.hpp"

#include <algorithm>
#include <bitset>

namespace mdm {

std::string spelled_plainly(std::string_view text, std::span<const Spelling> spellings) {
  // Most letters begin none of them.
  const auto byte = [](std::string_view of) { return static_cast<unsigned char>(of.front()); };
  std::bitset<256> begins;
  for (const Spelling &spelling : spellings)
    begins.set(byte(spelling.written));
  std::string plain;
  while (!text.empty()) {
    const auto found = begins[byte(text)]
                           ? std::find_if(spellings.begin(), spellings.end(),
                                          [text](const Spelling &s) { return text.starts_with(s.written); })
                           : spellings.end();
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
