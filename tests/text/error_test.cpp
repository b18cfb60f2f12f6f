#include "../gradation/support.hpp"

namespace error_test {

using namespace mdm;
using namespace mdm::test;

TEST_CASE("Quoted text is printable") {
  CHECK(in_quotes("3/8\"") == "'3/8\"'");
  CHECK(in_quotes("a\n\t\x1B\x7F") == "'a\\x0a\\x09\\x1b\\x7f'");
  CHECK(in_quotes("\xFF\xC3") == "'\\xff\\xc3'");
  CHECK(in_quotes("\xC2\x85") == "'\\xc2\\x85'");
  CHECK(in_quotes("\xC3\xA4") == "'\xC3\xA4'");
  CHECK(in_quotes("") == "''");
}

TEST_CASE("Misleading characters are escaped") {
  CHECK(in_quotes("u\xE2\x80\xAEgpj.csv") == "'u\\xe2\\x80\\xaegpj.csv'");
  for (const std::string code : {"\xC2\xAD", "\xD8\x9C", "\xE2\x80\x8B", "\xE2\x80\x8F", "\xE2\x80\xA8",
                                 "\xE2\x81\xA0", "\xE2\x81\xA9", "\xEF\xBB\xBF"})
    CHECK(printable(code).find(code) == std::string::npos);
  for (const std::string code : {"\xC2\xAC", "\xE2\x80\x8A", "\xE2\x80\x90", "\xE2\x80\xAF", "\xE2\x81\xAA"})
    CHECK(printable(code) == code);
}

TEST_CASE("Quoted text is cut to 80 characters") {
  CHECK(in_quotes(std::string(80, 'x')) == "'" + std::string(80, 'x') + "'");
  CHECK(in_quotes(std::string(81, 'x')) == "'" + std::string(77, 'x') + "...'");
  std::string umlauts;
  for (int i = 0; i < 81; ++i)
    umlauts += "\xC3\xA4";
  CHECK(in_quotes(umlauts) == "'" + umlauts.substr(0, 2 * 77) + "...'");
  CHECK(in_quotes(std::string(10'000'000, '\0')).size() <= 82);
}

TEST_CASE("UTF-8 is well-formed") {
  CHECK(is_utf8(""));
  CHECK(is_utf8("a\xC2\x80\xDF\xBF\xE0\xA0\x80\xED\x9F\xBF\xEF\xBF\xBF\xF0\x90\x80\x80\xF4\x8F\xBF\xBF"));
  for (const std::string bad :
       {"\x80", "\xC0\x80", "\xC1\xBF", "\xC2",
        "\xC2"
        "A",
        "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80",
        "\xF8\x88\x80\x80\x80", "\xFF", "\xE2\x82", "a\xF0\x9F\x8F"})
    CHECK_FALSE(is_utf8(bad));
}

} // namespace error_test
