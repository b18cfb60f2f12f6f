#include "gradation/text_encoding.hpp"
#include "support.hpp"

namespace text_encoding_test {

using namespace mdm;
using namespace mdm::test;

namespace {

const std::string sand = "Siebweite [mm];Rückstand [g]\n2;0\n1;3,5\n0,5;\U0001D44E\n";

/// UTF-16 of a text of characters below 0x10000.
std::string utf16(const std::u16string &text, bool big_endian) {
  std::string bytes = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char16_t c : text) {
    const char high = static_cast<char>(c >> 8), low = static_cast<char>(c & 0xFF);
    bytes += big_endian ? high : low;
    bytes += big_endian ? low : high;
  }
  return bytes;
}

std::optional<DecodedText> decoded(const std::string &bytes) {
  return decoded_text(bytes, Source("sand.csv"));
}

std::string refusal_of(const std::string &bytes) {
  return message_of([&bytes] { decoded(bytes); });
}

} // namespace

TEST_CASE("UTF-8 is left as it is") {
  CHECK_FALSE(decoded(sand));
  CHECK_FALSE(decoded(""));
}

TEST_CASE("UTF-16 of both orders of bytes is told by its mark") {
  const std::u16string text = u"Siebweite [mm];Rückstand [g]\n2;0\n1;3,5\n0,5;\U0001D44E\n";
  CHECK(decoded(utf16(text, false))->text == sand);
  CHECK(decoded(utf16(text, true))->text == sand);
  CHECK(decoded(utf16(text, false))->encoding == "UTF-16LE");
  CHECK(decoded(utf16(text, true))->encoding == "UTF-16BE");
}

TEST_CASE("UTF-16 that is cut is refused with its line") {
  const std::string bytes = utf16(u"a\nb\n", false);
  CHECK(contains(refusal_of(bytes.substr(0, bytes.size() - 1)),
                 "sand.csv:2: the UTF-16 text ends in the middle of a character"));
  CHECK(contains(refusal_of(utf16({u'a', u'\n', char16_t(0xD835)}, true)),
                 "sand.csv:2: the UTF-16 text has half a character"));
  CHECK(contains(refusal_of(utf16({char16_t(0xD835), u'a'}, true)), "sand.csv:1: the UTF-16 text has half"));
  CHECK(contains(refusal_of(utf16({char16_t(0xDC00), u'a'}, false)), "sand.csv:1: the UTF-16 text has half"));
}

TEST_CASE("Bytes that are not UTF-8 are Windows-1252") {
  CHECK(decoded("R\xFC"
                "ckstand \x80 \xB5m\r\n")
            ->text == "Rückstand € µm\r\n");
  CHECK(decoded("R\xFC"
                "ckstand")
            ->encoding == "Windows-1252 (Latin-1)");
}

TEST_CASE("Bytes that no text in Windows-1252 has are no text") {
  CHECK_FALSE(decoded("\x89PNG\r\n\x1A\n"));
  CHECK_FALSE(decoded("\xFC\x81"));
}

} // namespace text_encoding_test
