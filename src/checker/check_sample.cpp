#include "sample.hpp"
#include "verdict.hpp"

#include <mdm/checker.hpp>

#include <algorithm>

namespace mdm::checker {
namespace {

bool is_in(const std::string &text, const char *place) {
  return std::less_equal<>()(text.data(), place) && std::less_equal<>()(place, text.data() + text.size());
}

/// A file is malformed in a line that has a place, or of which the number is known.
Verdict malformed_sample(const Malformed &error, const Input &file, std::uint64_t line) {
  if (!file.is_line && is_in(file.text, error.at))
    line = 1 + static_cast<std::uint64_t>(std::count(file.text.data(), error.at, '\n'));
  return {Verdict::malformed,
          {},
          {},
          printable(file.name) + (line > 0 ? ":" + std::to_string(line) : "") + ": " + error.what()};
}

} // namespace

Verdict check_sample(const Input &gradation_file, const std::string &sample_name, const Pieces &sample,
                     const Input &certificate_file) {
  const Input sample_file{sample_name, {}};
  const Input *reading = &gradation_file;
  std::uint64_t line = 0;
  try {
    const Gradation gradation = read_gradation(gradation_file.text);
    reading = &certificate_file;
    const SampleCertificate certificate = read_sample_certificate(certificate_file.text);
    Gradation asked = gradation;
    apply_question(asked, certificate.question);
    reading = &sample_file;
    line = 1;
    SampleReader reader(sample, asked.unit());
    SampleTally tally(asked, certificate, reader.power());
    for (SampleRow row; (line = reader.line() + 1, reader.next(row));)
      tally.add(row);
    reading = &certificate_file;
    line = 0;
    verify_sample(asked, certificate, tally);
    return {Verdict::accepted,
            accepted_sample_line(gradation, certificate, gradation_file.name, sample_name),
            question_in_words(gradation, certificate),
            {}};
  } catch (const Refused &reason) {
    return {Verdict::refused,
            refused_sample_line(gradation_file.name, sample_name),
            {},
            printable(certificate_file.name) + ": " + reason.what()};
  } catch (const Malformed &error) {
    const bool is_of_certificate = is_in(certificate_file.text, error.at);
    return malformed_sample(error, is_of_certificate ? certificate_file : *reading,
                            is_of_certificate ? 0 : line);
  }
}

} // namespace mdm::checker
