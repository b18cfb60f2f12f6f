// A file for Coq that states what is proved of one gradation as a theorem, and has Coq's kernel check it
// (proofs/README.md, "A theorem for one answer"). It has the bytes of gradation and certificate as strings.
// Coq evaluates the verified checker on them: `judge` of proofs/coq, the function that mdm-check-verified is
// extracted from. What it prints is the theorem, so that nothing is left to compare. What Coq would take
// minutes for is refused with the reason.

#include "proof/coq_file.hpp"

#include "proof/certificate_parts.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace mdm {
namespace {

// ---- Limits ----

/// Refuses what Coq would take minutes or hours for: it raises openings, masses and sizes to the power e, and
/// multiplies in quadratic time.
void check_powers(const Match &m) {
  const Gradation &g = m.gradation;
  if (!m.question.law.is_power())
    throw InputError(option("coq") + ": the theorem is of laws that are powers: leave it out, or " +
                     option("law") + " by table or sum");
  std::uint64_t bits = std::max({longest_opening(g), longest_part(g.masses()), longest_part(g.factors())});
  if (m.sample)
    for (const std::optional<Enclosure> &size : m.sample->sizes)
      if (size)
        bits = std::max<std::uint64_t>({bits, longest_part(size->lo), longest_part(size->hi)});
  const std::uint64_t e = highest_power(m);
  if (Rational(g.classes()) * Rational(e * bits) * Rational(e * bits) > Rational(max_coq_powers))
    throw InputError(
        fmt::format("the theorem needs powers of {} bits for each of {} classes, and Coq takes too "
                    "long where classes times bits times bits are more than {}: use {} and "
                    "mdm-check-verified, or leave out {}",
                    e * bits, g.classes(), max_coq_powers, option("proof"), option("coq")));
}

/// The leaves that are windows of the mass.
std::uint64_t windows(const std::string &certificate) {
  std::istringstream lines(certificate);
  std::uint64_t count = 0;
  for (std::string line; std::getline(lines, line);)
    if (line == "window" || line.starts_with("window "))
      ++count;
  return count;
}

/// Refuses what Coq would take minutes for: it goes over the classes in each window.
void check_windows(const Match &m, const std::string &certificate) {
  const std::uint64_t count = windows(certificate);
  if (count * m.gradation.classes() > max_coq_windows)
    throw InputError(fmt::format(
        "the proof has {} windows of {} classes, and Coq takes too long where windows times classes "
        "are more than {}: use {} and mdm-check-verified, or leave out {}",
        count, m.gradation.classes(), max_coq_windows, option("proof"), option("coq")));
}

void check_bytes(const CoqSource &source) {
  const std::size_t bytes = source.gradation.size() + source.certificate.size();
  if (bytes > max_coq_bytes)
    throw InputError(
        fmt::format("gradation and certificate have {} bytes, and Coq's stack holds no more than {}: "
                    "use {} and mdm-check-verified, or leave out {}",
                    bytes, max_coq_bytes, option("proof"), option("coq")));
}

// ---- Texts ----

/// The text in a comment of Coq, in which neither a string begins nor the comment ends.
std::string in_comment(std::string_view text) {
  std::string safe(text);
  std::replace_if(
      safe.begin(), safe.end(), [](char ch) { return ch == '"' || ch == '*'; }, '?');
  return safe;
}

/// As a string of Coq, in which a quote is doubled.
std::string coq_string(std::string_view bytes) {
  std::string text = "\"";
  for (const char ch : bytes)
    text += ch == '"' ? std::string("\"\"") : std::string(1, ch);
  return text + "\"";
}

} // namespace

std::string coq_file(const Match &m, const CoqSource &source) {
  check_powers(m);
  check_bytes(source);
  check_windows(m, source.certificate);
  return fmt::format(R"((* A theorem about the gradation {}, checked by Coq's kernel:

     {}

   The folder is where exactmdm installs its Coq development (README.md there says how to compile it where it has no
   .vo files). The strings are the bytes of the gradation file and of its certificate, each quote twice. Coq evaluates
   the verified checker on them, prints the line of its verdict, and proves that this line is true of the gradation:
   true_of_line in LineTheorem.v, in the words of Spec.v. *)

From Coq Require Import String.
From Mdm Require Import Judge LineTheorem Answer.
Open Scope string_scope.

Definition gradation : file := File {}
{}.

Definition certificate : file := File "certificate"
{}.

Definition line : string := Eval vm_compute in verdict_line (judge gradation certificate).
Print line.

Theorem answer : true_of_line gradation line.
Proof. apply (proved gradation certificate). vm_cast_no_check (eq_refl (Proved line)). Qed.

Print Assumptions answer.
)",
                     in_comment(source.name), in_comment(source.command), coq_string(source.name),
                     coq_string(source.gradation), coq_string(source.certificate));
}

} // namespace mdm
