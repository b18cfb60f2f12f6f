// Integers of 128 bits that are exact or throw. The compiler's overflow checks guard every operation; a
// caller that catches Int128Overflow begins again with integers of any length, so that nothing but time
// depends on which is used. Here are the ways to these integers and back, whole words at a time; the
// operations themselves, which have to be quick, are in the header.

#include "number/int128.hpp"

#include "number/words.hpp"

namespace mdm {

Int128::Int128(const Integer &n) {
  // 126 bits leave room for the sign, whatever it is.
  if (bit_length(n) > 126)
    throw Int128Overflow{};
  value_ = static_cast<Value>(word(n, 1)) << 64 | word(n, 0);
  if (n < 0)
    value_ = -value_;
}

Integer Int128::to_integer() const {
  const bool negative = value_ < 0;
  // The magnitude in two's complement, right for the most negative value too.
  __extension__ typedef unsigned __int128 Magnitude;
  const Magnitude magnitude =
      negative ? Magnitude{0} - static_cast<Magnitude>(value_) : static_cast<Magnitude>(value_);
  Integer n, high;
  set_word(n.backend().data(), static_cast<std::uint64_t>(magnitude));
  if (magnitude >> 64 != 0) {
    set_word(high.backend().data(), static_cast<std::uint64_t>(magnitude >> 64));
    n += high << 64;
  }
  if (negative)
    mpz_neg(n.backend().data(), n.backend().data());
  return n;
}

} // namespace mdm
