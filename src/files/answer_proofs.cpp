#include "files/answer_proofs.hpp"

#include "files/output.hpp"
#include "files/paths.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/write_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {

AnswerProofs::AnswerProofs(std::string folder, const CrosscheckQuestion &question, Rational size_tolerance)
    : folder_(std::move(folder)), question_(question), size_tolerance_(std::move(size_tolerance)) {
  make_folder(folder_);
}

void AnswerProofs::add(const SuiteLine &entry, const Gradation &asked, const OtherAnswer &answer,
                       unsigned number) {
  if (answer.failure)
    return;
  ++answers_;
  const std::optional<AnswerProof> proof = made(asked, answer);
  if (!proof)
    return;
  ++proofs_;
  const std::string name =
      folder_ + "/" + std::to_string(entry.line) + (number > 1 ? "-" + std::to_string(number) : "");
  write_output(name + ".gradation.json", gradation_json(entry.gradation));
  write_output(name + ".sample.csv", proof->sample);
  write_output(name + ".proof", proof->certificate);
}

std::string AnswerProofs::note() const {
  const std::uint64_t missing = answers_ - proofs_;
  return fmt::format("{} certificates are in {}; check them with: mdm-check {} {}{}", proofs_.load(),
                     printable(folder_), option("suite", OptionSpelling::program), shell_word(folder_),
                     missing > 0
                         ? fmt::format("; of {} answers there is none: sizes that are not stated, or have "
                                       "a tolerance, leave it open whether they match",
                                       missing)
                         : "");
}

std::optional<AnswerProof> AnswerProofs::made(const Gradation &asked, const OtherAnswer &answer) const {
  try {
    return answer_proof(asked, question_.question(asked), answer, size_tolerance_);
  } catch (const InputError &) {
    return std::nullopt;
  }
}

} // namespace mdm
