#pragma once

#include "certificate.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace mdm::checker {

/// The percents from lo to hi, decimals; in a line of a class one number means exactly this rational.
struct Percents {
  Number lo, hi;
};

/// A line `class` of a certificate of a sample.
struct ClassClaim {
  std::uint64_t index; ///< from 1
  mpz_class quantity;
  Percents share;
  bool is_exact; ///< lo alone is there
};

/// The largest error of a measure, and the class where it is.
struct LargestError {
  std::uint64_t index = 0; ///< from 1
  Percents percents{};
};

/// What is said of a match. Those that say no name a value that is `least` or `most` asked for.
struct SampleVerdict {
  enum Kind { match, outside, of_class, passing, total } kind = match;
  std::uint64_t index = 0; ///< of a class
  Percents found{};
  bool is_least = false;
  Number asked{}; ///< at least, or at most, so much
};

/// A certificate of a sample (section 12).
struct SampleCertificate {
  Certificate question; ///< the lines from `law` to `band`
  bool is_tolerant = false;
  Numbers places, particles, below, above, unplaced; ///< none where the line is absent
  std::vector<ClassClaim> classes;
  LargestError retained;
  std::optional<LargestError> passing; ///< none where the line is absent
  Percents total{};
  std::array<std::string_view, 4> conditions;
  SampleVerdict verdict;
};

/// Reads one.
SampleCertificate read_sample_certificate(std::string_view text);

} // namespace mdm::checker
