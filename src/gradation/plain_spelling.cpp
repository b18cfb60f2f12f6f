#include "gradation/plain_spelling.hpp"

#include "text/lines.hpp"

#include <algorithm>
#include <bitset>

namespace mdm {
namespace {

bool begins_with(std::string_view text, std::string_view written) {
  return text.size() >= written.size() && text[written.size() - 1] == written.back() &&
         text.starts_with(written);
}

} // namespace

std::string spelled_plainly(std::string_view text, std::span<const Spelling> spellings) {
  // Most letters begin none of them, and many of them begin alike.
  const auto byte = [](std::string_view of) { return static_cast<unsigned char>(of.front()); };
  std::bitset<256> begins;
  for (const Spelling &spelling : spellings)
    begins.set(byte(spelling.written));
  std::string plain;
  while (!text.empty()) {
    const auto found = begins[byte(text)]
                           ? std::find_if(spellings.begin(), spellings.end(),
                                          [text](const Spelling &s) { return begins_with(text, s.written); })
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
