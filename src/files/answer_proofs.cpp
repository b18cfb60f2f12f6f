#include "files/answer_proofs.hpp"

#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/proof_stream.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/write_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {

AnswerProofs::AnswerProofs(std::string path, const CrosscheckQuestion &question, Rational size_tolerance)
    : path_(std::move(path)), question_(question), size_tolerance_(std::move(size_tolerance)) {
  if (names_proof_stream(path_))
    stream_.emplace(path_);
  else
    make_folder(path_);
}

std::optional<AnswerProof> AnswerProofs::made(const Gradation &asked, const OtherAnswer &answer) {
  if (answer.failure)
    return std::nullopt;
  ++answers_;
  try {
    return answer_proof(asked, question_.question(asked), answer, size_tolerance_);
  } catch (const InputError &) {
    return std::nullopt;
  }
}

void AnswerProofs::write(const SuiteLine &entry, const OfGradation &proofs) {
  for (std::size_t i = 0; i < proofs.size(); ++i) {
    if (!proofs[i])
      continue;
    if (stream_)
      stream_->add(entry.line, i + 1, *proofs[i]);
    else
      write_files(entry, i + 1, *proofs[i]);
    ++proofs_;
  }
}

void AnswerProofs::write_files(const SuiteLine &entry, std::size_t number, const AnswerProof &proof) const {
  const std::string name =
      path_ + "/" + std::to_string(entry.line) + (number > 1 ? "-" + std::to_string(number) : "");
  write_output(name + ".gradation.json", gradation_json(entry.gradation));
  write_output(name + ".sample.csv", proof.sample);
  write_output(name + ".proof", proof.certificate);
}

void AnswerProofs::commit() {
  if (stream_)
    stream_->commit();
}

std::string AnswerProofs::note(const std::string &suite) const {
  const std::uint64_t missing = answers_ - proofs_;
  if (proofs_ == 0)
    return fmt::format(
        "no certificate is in {}: sizes that are not stated, or have a tolerance, leave it open "
        "whether answers match",
        printable(path_));
  return fmt::format(
      "{} certificates are in {}; check them with: mdm-check {} {}{}{}", proofs_, printable(path_),
      option("suite", OptionSpelling::program), stream_ ? shell_word(suite) + " " : "", shell_word(path_),
      missing > 0 ? fmt::format("; of {} answers there is none: sizes that are not stated, or have "
                                "a tolerance, leave it open whether they match",
                                missing)
                  : "");
}

} // namespace mdm
