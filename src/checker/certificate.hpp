#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace mdm_check {

/// A number of a certificate, and its text there.
struct Number {
  mpq_class value;
  std::string_view text;
};
using Numbers = std::vector<Number>;

/// `quantity` particles of class `index`, counted from 1, of one size in [lo, hi].
struct ClassWitness {
  std::uint64_t index;
  mpz_class quantity;
  mpq_class lo, hi;
};

/// The numbers of each line; none where the line is absent. The texts are those of the file.
struct Certificate {
  Numbers version, law, pan_size, cut_below, size_factor, min_per_class, cylinder, box, solids_volume, pi,
      at_least, particles, scale, above;
  std::vector<ClassWitness> classes;
  std::optional<std::vector<std::uint32_t>>
      chain; ///< an index beyond 32 bits, which no class has, as 2^32 - 1
};

/// Reads a certificate (section 1).
Certificate read_certificate(std::string_view text);

} // namespace mdm_check
