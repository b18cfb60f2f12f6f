#pragma once

#include "blend_certificate.hpp"

#include <string>
#include <utility>
#include <vector>

namespace mdm::checker {

/// A sieve at which blends are judged: limits and what passes each stockpile, in percent. Or a fineness
/// modulus in its place: the mean of what passes its sieves; or a limit c of the coarseness factor: what
/// passes 9.5 mm less c / 100 of what passes 2.36 mm.
struct JudgedSieve {
  enum Kind { sieve, modulus, factor };
  mpq_class size; ///< mm; 0 where it is no sieve
  mpq_class least, most;
  Rationals passing;
  std::vector<std::size_t> interpolated; ///< stockpiles, counted from 0
  Kind kind = sieve;
};

/// The sieves of the specification that limit something, and those that all stockpiles tell of, ascending,
/// then the certificate's fineness moduli, then its coarseness factor (section 11). Throws Refused where a
/// stockpile does not tell of one with a limit.
std::vector<JudgedSieve> judged_sieves(const Gradation &specification,
                                       const std::vector<Gradation> &stockpiles,
                                       const BlendCertificate &certificate);

/// Verifies the claim of a certificate; the value of the blend's aim. Throws Refused at the first thing that
/// fails, Malformed where it would take too long.
mpq_class verify_blend(const std::vector<JudgedSieve> &sieves, std::size_t stockpiles,
                       const BlendCertificate &certificate, std::string_view place);

} // namespace mdm::checker
