#pragma once
/// \file
/// The theorem of a certificate for Coq.

#include <mdm/match/match.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace mdm {

/// The most bytes of gradation and certificate together that a Coq file is written for: Coq's stack does not
/// hold a string of twice as many.
inline constexpr std::size_t max_coq_bytes = 30'000;

/// The most that classes times the square of the bits of their powers may be: Coq needs some 16 s for it.
inline constexpr std::uint64_t max_coq_powers = 1'000'000'000;

/// The most that windows times classes may be: Coq needs some 40 s for it.
inline constexpr std::uint64_t max_coq_windows = 4'000;

/// What a Coq file is about.
struct CoqSource {
  std::string name;        ///< of the gradation file, as the verdict is to have it
  std::string gradation;   ///< the bytes that the checkers read
  std::string certificate; ///< the bytes of the certificate
  std::string command;     ///< that checks the Coq file, for its heading
};

/// A Coq 8.16 file with the bytes of both files and the theorem that what the verified checker prints of them
/// is true of the gradation (proofs/README.md, "A theorem for one answer"). The certificate is that of m.
/// \throws InputError if they are longer than max_coq_bytes, or the powers are beyond max_coq_powers or the windows
/// beyond max_coq_windows
std::string coq_file(const Match &m, const CoqSource &source);

} // namespace mdm
