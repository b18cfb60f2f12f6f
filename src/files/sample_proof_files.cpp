#include "files/sample_proof_files.hpp"

#include "files/byte_source.hpp"
#include "files/paths.hpp"
#include "text/filesystem_path.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/write_gradation.hpp>

#include <filesystem>

namespace mdm {
namespace {

constexpr const char *sample_ending = ".sample.csv", *gradation_ending = ".gradation.csv";

} // namespace

void SampleProofFiles::check(const std::string &proof, const std::vector<std::string> &others) {
  if (proof == "-")
    throw InputError(option("proof") + " needs a file: standard output has the report");
  for (const char *const ending : {"", sample_ending, gradation_ending}) {
    for (const std::string &other : others)
      check_distinct({other, proof + ending});
    refuse_protected(proof + ending);
  }
}

SampleProofFiles::SampleProofFiles(std::string proof, std::string gradation, const UnderstoodGradation &read,
                                   std::optional<std::string> sample)
    : path_(std::move(proof)), gradation_path_(std::move(gradation)), sample_path_(std::move(sample)),
      proof_(path_) {
  if (read.is_canonical && gradation_path_ != "-" && is_plain_file(gradation_path_))
    return;
  gradation_path_ = path_ + gradation_ending;
  gradation_.emplace(gradation_path_);
  gradation_->write(gradation_csv(read.gradation));
}

SampleCertifier::Begin SampleProofFiles::begin() {
  if (sample_path_ && !sample_)
    return {};
  sample_path_ = path_ + sample_ending;
  return [this] {
    sample_.reset();
    sample_.emplace(*sample_path_);
    return Sink([this](std::string_view text) { sample_->write(text); });
  };
}

void SampleProofFiles::write(const std::string &certificate, const std::string &missing,
                             std::vector<std::string> &notes) {
  if (!missing.empty()) {
    notes.push_back(
        "no proof was written to " + printable(path_) + ": " + missing +
        (std::filesystem::exists(filesystem_path(path_)) ? "; the file that is there is older" : ""));
    return;
  }
  proof_.write(certificate);
  has_proof_ = true;
  notes.push_back("check the proof with: mdm-check " + shell_word(gradation_path_) + " " +
                  shell_word(*sample_path_) + " " + shell_word(path_));
}

void SampleProofFiles::commit() {
  if (!has_proof_)
    return;
  if (gradation_)
    gradation_->commit();
  if (sample_)
    sample_->commit();
  proof_.commit();
}

} // namespace mdm
