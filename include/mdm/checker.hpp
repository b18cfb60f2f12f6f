#pragma once
/// \file
/// The checker of certificates as a library of its own, mdm::checker: it shares no code with the solver, and
/// needs nothing but GMP. Its formats and verdicts are those of proofs/certificate-format.md.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// The checker of the proofs of matches, with readers of its own.
namespace mdm::checker {

/// The text of a file to be judged, and the name under which messages speak of it. Nothing is opened.
struct Input {
  std::string name, text;
  bool is_line = false; ///< the text is one line of a file, which the name says: it has no lines to name
};

/// The verdict on a certificate, as mdm-check gives it.
struct Verdict {
  /// The exit codes of mdm-check.
  enum Code { accepted = 0, refused = 1, malformed = 2 } code;
  std::string line; ///< what was proved, with the whole question (section 7); empty if a file is malformed
  std::string
      question;       ///< of an accepted certificate: what was asked, in words, without numbers of the answer
  std::string reason; ///< `name: ...` or `name:line: ...`; empty if the certificate is accepted
};

/// Judges a certificate against a gradation: CSV or JSON, or that of a band. Several threads may call it.
/// Throws std::bad_alloc alone; GMP, where it finds no memory, ends the program (mp_set_memory_functions).
Verdict check(const Input &gradation, const Input &certificate);

/// Judges a certificate of a blend (section 11) against the specification and the gradations of the
/// stockpiles, in the order of the certificate. As check() otherwise.
Verdict check_blend(const Input &specification, const std::vector<Input> &stockpiles,
                    const Input &certificate);

/// Gives the next piece of a text, as long as the one before is no longer needed; an empty one at the end.
using Pieces = std::function<std::string_view()>;

/// Judges a certificate of a sample (section 12) against a gradation and the sample, which is read once,
/// piece by piece: memory does not depend on its length. As check() otherwise; what `sample` throws is passed
/// on.
/// \param sample_name  under which messages and the line speak of it
Verdict check_sample(const Input &gradation, const std::string &sample_name, const Pieces &sample,
                     const Input &certificate);

/// True if the text begins as certificates of samples do.
bool is_sample_certificate(std::string_view text);

/// The gradation as it is read, in the lines of canonical CSV (section 8) without the last line end; or
/// malformed.
Verdict print(const Input &gradation);

} // namespace mdm::checker
