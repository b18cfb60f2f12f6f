#pragma once
/// \file
/// What the certificates of exact matches and of matches within a tolerance have in common.

#include <mdm/match/solve.hpp>

#include <string>
#include <vector>

namespace mdm {

/// The format asks for ten significant digits of a size.
inline constexpr unsigned least_digits = 10;
/// Limits of the format (certificate-format.md, section 2): bits of powers, and of all steps together.
inline constexpr std::size_t max_power_bits = std::size_t{1} << 20;
inline constexpr std::uint64_t max_work = std::uint64_t{1} << 34;

/// Bits of the longest numerator or denominator.
std::size_t longest_part(const Rational &r);
std::size_t longest_part(const std::vector<Rational> &numbers);

/// True if a size is precise enough for the format and not too long.
bool is_precise(const Match &m, const Enclosure &size);

[[noreturn]] void refuse_long_numbers();

/// The lines from `law` to `at-least`.
std::string question_lines(const Match &m);

/// The certificate of a match within a tolerance.
std::string tree_certificate(const Match &m);

} // namespace mdm
