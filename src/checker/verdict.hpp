#pragma once

#include "certificate.hpp"
#include "gradation.hpp"
#include "sample_certificate.hpp"

#include <string>

namespace mdm::checker {

/// The line of an accepted certificate (section 7). It repeats the whole question: its reader sees what was
/// proved.
std::string accepted_line(const Gradation &gradation, const Certificate &certificate,
                          const std::string &file);

/// What an accepted certificate was asked, in the words of its line: what is claimed of which match, without
/// the numbers of the claim and without what the gradation file says.
std::string question_in_words(const Gradation &gradation, const Certificate &certificate);

/// The same of a certificate of a sample (section 12).
std::string accepted_sample_line(const Gradation &gradation, const SampleCertificate &certificate,
                                 const std::string &file, const std::string &sample);

/// What an accepted certificate of a sample was asked, in words, without the numbers of the claim.
std::string question_in_words(const Gradation &gradation, const SampleCertificate &certificate);

/// The line of a certificate that is refused.
std::string refused_line(const std::string &file);
std::string refused_sample_line(const std::string &file, const std::string &sample);

} // namespace mdm::checker
