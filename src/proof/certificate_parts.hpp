#pragma once
/// \file
/// Lines that the certificates of exact matches and of matches within a tolerance share.

#include <mdm/proof/certificate.hpp>

#include <string>
#include <vector>

namespace mdm {

/// The format asks for ten significant digits of a size.
inline constexpr unsigned least_digits = 10;
/// A limit of the format beside max_power_bits (certificate-format.md, section 2): bits of all steps
/// together.
inline constexpr std::uint64_t max_work = std::uint64_t{1} << 34;
/// Digits of a number.
inline constexpr std::size_t max_digits = 100000;

/// Bits of the longest numerator or denominator.
std::size_t longest_part(const Rational &r);
std::size_t longest_part(const std::vector<Rational> &numbers);

/// Bits of the longest opening, each counted with the d-th part of the bits of its d-th power.
std::size_t longest_opening(const Gradation &g);
/// Bits of the longest number of a law by table or sum.
std::size_t longest_part(const MassLaw &law);
/// The exponent that numbers are raised to at most, max(a, b) d; or the work of a value of a law by table or
/// sum in its place.
std::uint64_t highest_power(const MassLaw &law, unsigned root);
std::uint64_t highest_power(const Match &m);

/// True if a size is precise enough for the format and not too long.
bool is_precise(const Match &m, const Enclosure &size);

[[noreturn]] void refuse_long_numbers();
/// \throws InputError if the text has a number of more digits than the format allows
void check_short_numbers(const std::string &text);
/// The lines from `law` to `at-least`.
std::string question_lines(const Match &m);

/// The certificate of a match within a tolerance.
Certified tree_certificate(const Match &m);

} // namespace mdm
