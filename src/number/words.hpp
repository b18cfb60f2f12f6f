#pragma once
/// \file
/// Integers as words of 64 bits, however long GMP's own words are.

#include <mdm/number/integer.hpp>

#include <cstdint>

namespace mdm {

/// Bits 64 i to 64 i + 63 of |n|; 0 where n has none, and for i < 0.
inline std::uint64_t word(const Integer &n, long i) {
  const mpz_srcptr z = n.backend().data();
  if constexpr (GMP_NUMB_BITS == 64)
    return mpz_getlimbn(z, i);
  return std::uint64_t{mpz_getlimbn(z, 2 * i + 1)} << 32 | mpz_getlimbn(z, 2 * i);
}

/// z := value.
inline void set_word(mpz_ptr z, std::uint64_t value) {
  if constexpr (sizeof(unsigned long) == sizeof value) // not so on Windows
    mpz_set_ui(z, static_cast<unsigned long>(value));
  else
    mpz_import(z, 1, -1, sizeof value, 0, 0, &value);
}

} // namespace mdm
