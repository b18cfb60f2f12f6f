// Philox gives the numbers of its authors' test vectors (Random123, kat_vectors).

#include "catch.hpp"
#include "number/philox.hpp"

namespace philox_test {

using mdm::Philox;

TEST_CASE("philox 4x32-10 has its published values") {
  CHECK(Philox(Philox::Key{0, 0})(Philox::Block{0, 0, 0, 0}) ==
        Philox::Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
  CHECK(Philox(Philox::Key{0xffffffff, 0xffffffff})(
            Philox::Block{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}) ==
        Philox::Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
  CHECK(Philox(Philox::Key{0xa4093822, 0x299f31d0})(
            Philox::Block{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}) ==
        Philox::Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("a number of a stream is half of its block") {
  CHECK(Philox(0)(0, 0) == 0xe169c58d6627e8d5);
  CHECK(Philox(0x299f31d0a4093822)(0x0370734413198a2e, 0x85a308d3243f6a88) == 0x94fdccebd16cfe09);
}

} // namespace philox_test
