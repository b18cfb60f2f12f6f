// Choices of random numbers are made of Philox's in integers, in their order.

#include "catch.hpp"
#include "number/random_stream.hpp"

#include <set>

namespace random_stream_test {

using namespace mdm;

TEST_CASE("a choice is the product of a number and how many there are, above its 64 bits", "[random]") {
  const Philox philox(7);
  RandomStream stream(7, 3);
  for (const std::uint32_t n : {2U, 10U, 1000U, 4294967295U}) {
    const std::uint64_t index = n == 2 ? 0 : n == 10 ? 1 : n == 1000 ? 2 : 3;
    const Integer expected = Integer(Integer(philox(3, index)) * n) >> 64;
    CHECK(Integer(stream.below(n)) == expected);
  }
  CHECK(stream.next() == philox(3, 4));
}

TEST_CASE("a choice of a long number has 64 bits more than need be", "[random]") {
  const Philox philox(7);
  RandomStream stream(7, 3);
  const Integer n = power_of_ten(30); // 100 bits
  const Integer r = (((Integer(philox(3, 0)) << 64) + philox(3, 1)) << 64) + philox(3, 2);
  CHECK(stream.below(n) == Integer(r * n) >> 192);
  CHECK(stream.next() == philox(3, 3));
}

TEST_CASE("a choice of one takes no number", "[random]") {
  RandomStream stream(7, 3);
  CHECK(stream.below(1U) == 0);
  CHECK(stream.below(Integer(1)) == 0);
  CHECK(stream.next() == Philox(7)(3, 0));
}

TEST_CASE("all choices come", "[random]") {
  RandomStream stream(1, 1);
  std::set<std::uint32_t> small;
  std::set<Integer> large;
  for (int i = 0; i < 200; ++i) {
    small.insert(stream.below(5U));
    large.insert(stream.below(Integer(5)));
  }
  CHECK(small == std::set<std::uint32_t>{0, 1, 2, 3, 4});
  CHECK(large == std::set<Integer>{0, 1, 2, 3, 4});
}

} // namespace random_stream_test
