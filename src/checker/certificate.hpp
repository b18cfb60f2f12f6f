#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mdm_check {

/// A number of the question, and its text, which the verdict repeats.
struct Number {
  mpq_class value;
  std::string text;
};

enum class Solids { none, cylinder, box, volume };

/// What the gradation file does not say: the problem is derived from both.
struct Question {
  unsigned long a = 3, b = 1; ///< mass law x^(a/b)
  std::optional<Number> pan_size, cut_below, size_factor;
  std::optional<mpz_class> min_per_class;
  Solids solids = Solids::none;
  std::vector<Number> dimensions; ///< D H e of a cylinder, A B C e of a box, or V
  mpq_class pi_low, pi_high;      ///< 0 without box and volume
  std::optional<mpz_class> at_least;
};

/// `quantity` particles of class `index`, counted from 1, of one size in [lo, hi].
struct ClassWitness {
  std::uint64_t index;
  mpz_class quantity;
  mpq_class lo, hi;
};

struct Certificate {
  Question question;
  mpz_class particles;
  mpq_class scale; ///< to the power b
  std::vector<ClassWitness> classes;
  std::optional<mpq_class> above;
  std::optional<std::vector<std::uint32_t>>
      chain; ///< indices beyond 32 bits, which no class has, as the largest
};

/// Reads a certificate (section 1).
Certificate read_certificate(std::string_view text);

} // namespace mdm_check
