#include "gradation/cell_double.hpp"
#include "support.hpp"

namespace cell_double_test {

using namespace mdm;
using namespace mdm::test;

TEST_CASE("What a spreadsheet stores is read as what was typed") {
  for (const auto &[stored, typed] :
       std::vector<std::pair<std::string, std::string>>{{"1.1481999999999999E-2", "0.011482"},
                                                        {"7.4999999999999997E-2", "0.075"},
                                                        {"140.69999999999999", "140.7"},
                                                        {"0.94920000000000004", "0.9492"},
                                                        {"100", "100"},
                                                        {"0", "0"},
                                                        {"-1.5E3", "-1500"},
                                                        {"9.9999999999999995E-7", "0.000001"},
                                                        {"123456789012345", "123456789012345"}}) {
    INFO(stored);
    REQUIRE(cell_double(stored));
    CHECK(parse_decimal(cell_double(stored)->text) == parse_decimal(typed));
    CHECK(cell_double(stored)->is_short);
  }
}

TEST_CASE("Doubles without a decimal of 15 digits keep 16 or 17 and say so") {
  CHECK(cell_double("0.30000000000000004")->text == "0.30000000000000004");
  CHECK_FALSE(cell_double("0.30000000000000004")->is_short);
  CHECK_FALSE(cell_double("33.333333333333336")->is_short);
  CHECK_FALSE(cell_double("0.99999999999999989")->is_short);
}

TEST_CASE("What is no finite double is no number") {
  for (const std::string text : {"", "abc", "1,5", "1.5 ", "inf", "nan", "1e999", "0x10", "#N/A"})
    CHECK_FALSE(cell_double(text));
}

} // namespace cell_double_test
