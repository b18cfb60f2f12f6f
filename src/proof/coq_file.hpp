#pragma once
/// \file
/// The theorem of a match for Coq.

#include <mdm/match/match.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace mdm {

/// The longest certificate, in bytes, that a Coq file is written for: Coq needs some 10 s for it.
inline constexpr std::size_t max_coq_certificate = 100'000;

/// The most that classes times the square of the bits of their powers may be: Coq needs some 16 s for it.
inline constexpr std::uint64_t max_coq_powers = 1'000'000'000;

/// The most that windows times classes may be: Coq needs some 40 s for it.
inline constexpr std::uint64_t max_coq_windows = 4'000;

/// The chain or tree of a certificate, as the term of Coq that proofs/coq/Certificate.v reads it as.
std::string coq_evidence(const std::string &certificate);

/// A Coq 8.16 file with the sieves, the question, the certificate and the theorem, in the words of
/// proofs/coq/Spec.v, that m.particles() is the least number the question allows, or that no sample is within
/// its tolerance. `given` is the gradation that m was solved for, before the question's changes; the comment
/// at its head names `file_name` and the command that checks it.
/// \pre m.complete, and m was solved with Limits::keep_proof
/// \throws InputError if the certificate is longer than max_coq_certificate, its powers are beyond max_coq_powers or
/// its windows beyond max_coq_windows, or as certificate() does
std::string coq_file(const Gradation &given, const Match &m, std::string_view file_name,
                     std::string_view command);

} // namespace mdm
