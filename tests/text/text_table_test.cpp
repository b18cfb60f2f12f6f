#include "catch.hpp"
#include "text/text_table.hpp"

namespace text_table_test {

using namespace mdm;

TEST_CASE("columns are as wide as the characters of their longest cell, not its bytes") {
  CHECK(text_table({{"sample", "D50"}, {"K\u00F6rnung", "1"}, {"A", "0.25"}}, "<>") ==
        "  sample    D50\n"
        "  K\u00F6rnung     1\n"
        "  A        0.25\n");
}

TEST_CASE("no line of a table ends with spaces") {
  CHECK(text_table({{"a", "b"}, {"long", ""}}, "<") == "  a     b\n  long\n");
}

} // namespace text_table_test
