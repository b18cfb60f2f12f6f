// LineSum: a sum modulo 2^256, in any order.

#include "answer/line_sum.hpp"
#include "catch.hpp"

namespace line_sum_test {

using namespace mdm;

namespace {

LineSum::Hash all_bytes(unsigned char byte) {
  LineSum::Hash hash{};
  hash.fill(byte);
  return hash;
}

} // namespace

TEST_CASE("sums of hashes carry, and go round at 2^256", "[answer]") {
  LineSum sum;
  CHECK(sum.text() == std::string(64, '0'));
  sum.add(all_bytes(0x80));
  sum.add(all_bytes(0x80));
  CHECK(sum.text() == std::string("01010101010101010101010101010101") + "01010101010101010101010101010100");
  LineSum one;
  LineSum::Hash last{};
  last.back() = 1;
  one.add(last);
  one.add(all_bytes(0xff));
  CHECK(one == LineSum());
}

TEST_CASE("the sum of a whole is that of its parts", "[answer]") {
  LineSum whole, odd, even;
  for (unsigned char i = 0; i < 200; ++i) {
    whole.add(all_bytes(i));
    (i % 2 == 0 ? even : odd).add(all_bytes(i));
  }
  odd.add(even);
  CHECK(odd == whole);
  CHECK(LineSum::parse(whole.text()) == whole);
}

TEST_CASE("what is no sum is not read as one", "[answer]") {
  for (const std::string &text : {std::string(), std::string(63, '0'), std::string(65, '0'),
                                  std::string(62, '0') + "0x", std::string(62, '0') + "-1"})
    CHECK_FALSE(LineSum::parse(text));
}

} // namespace line_sum_test
