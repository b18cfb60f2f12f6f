#include "number/int128.hpp"

namespace mdm {

Int128::Int128(const Integer &n) {
  // 126 bits leave room for the sign, whatever it is.
  if (bit_length(n) > 126)
    throw Int128Overflow{};
  const mpz_srcptr z = n.backend().data();
  for (std::size_t limb = mpz_size(z); limb-- > 0;)
    value_ = (value_ << 64) | static_cast<Value>(mpz_getlimbn(z, static_cast<mp_size_t>(limb)));
  if (n < 0)
    value_ = -value_;
}

Integer Int128::to_integer() const {
  const bool negative = value_ < 0;
  // The magnitude in two's complement, right for the most negative value too.
  __extension__ typedef unsigned __int128 Magnitude;
  const Magnitude magnitude =
      negative ? Magnitude{0} - static_cast<Magnitude>(value_) : static_cast<Magnitude>(value_);
  Integer n = static_cast<std::uint64_t>(magnitude >> 64);
  if (n != 0)
    n <<= 64;
  mpz_add_ui(n.backend().data(), n.backend().data(), static_cast<std::uint64_t>(magnitude));
  if (negative)
    mpz_neg(n.backend().data(), n.backend().data());
  return n;
}

} // namespace mdm
