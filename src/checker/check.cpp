#include "number_check.hpp"
#include "print.hpp"
#include "verdict.hpp"
#include "verify.hpp"

#include <mdm/checker.hpp>

#include <algorithm>

namespace mdm::checker {
namespace {

Verdict malformed(const Input &input, const Malformed &error) {
  const auto line = error.at == nullptr || input.is_line
                        ? ""
                        : ":" + std::to_string(1 + std::count(input.text.data(), error.at, '\n'));
  return {Verdict::malformed, {}, {}, printable(input.name) + line + ": " + error.what()};
}

} // namespace

Verdict check(const Input &gradation_file, const Input &certificate_file) {
  const Input *reading = &gradation_file;
  try {
    if (is_number_certificate(certificate_file.text)) {
      const Gradation numbers = read_number_gradation(gradation_file.text);
      reading = &certificate_file;
      const NumberCertificate certificate = read_number_certificate(certificate_file.text);
      verify_number(numbers, certificate);
      return {Verdict::accepted,
              accepted_number_line(certificate, gradation_file.name),
              question_in_words(certificate),
              {}};
    }
    const Gradation gradation = read_gradation_or_materials(gradation_file.text);
    reading = &certificate_file;
    const Certificate certificate = read_certificate(certificate_file.text);
    const auto verify = certificate.tree.empty() ? verify_exact : verify_tolerant;
    verify(gradation, certificate);
    return {Verdict::accepted,
            accepted_line(gradation, certificate, gradation_file.name),
            question_in_words(gradation, certificate),
            {}};
  } catch (const Refused &reason) {
    return {Verdict::refused,
            refused_line(gradation_file.name),
            {},
            printable(certificate_file.name) + ": " + reason.what()};
  } catch (const Malformed &error) {
    return malformed(*reading, error);
  }
}

Verdict print(const Input &gradation) {
  try {
    std::string csv = canonical_csv(read_gradation_or_materials(gradation.text));
    csv.pop_back();
    return {Verdict::accepted, std::move(csv), {}, {}};
  } catch (const Malformed &error) {
    return malformed(gradation, error);
  }
}

} // namespace mdm::checker
