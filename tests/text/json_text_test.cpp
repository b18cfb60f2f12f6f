#include "catch.hpp"
#include "text/json_text.hpp"

namespace json_text_test {

using namespace mdm;

TEST_CASE("text in JSON is escaped, and what is no UTF-8 is replaced") {
  CHECK(json_string("a\"\\\x01") == R"("a\"\\\u0001")");
  CHECK(json_string("\xff") == "\"\\ufffd\"");
}

} // namespace json_text_test
