#pragma once

#include "gradation.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mdm::checker {

/// A certificate of a match by number (section 13). Tolerances are percentages.
struct NumberCertificate {
  std::optional<mpq_class> retained, passing, total;
  mpz_class particles;               ///< those of the set, or those that no set goes below
  std::vector<mpz_class> quantities; ///< one a class; empty: it is of the bound alone
};

/// Whether the text begins as such a certificate does.
bool is_number_certificate(std::string_view text);

/// Throws Malformed unless it is one.
NumberCertificate read_number_certificate(std::string_view text);

/// Verifies the claim (Theorem 27). Throws Refused if it is false or not proved.
void verify_number(const Gradation &gradation, const NumberCertificate &certificate);

std::string accepted_number_line(const NumberCertificate &certificate, const std::string &file);
std::string question_in_words(const NumberCertificate &certificate);

} // namespace mdm::checker
