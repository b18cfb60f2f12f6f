#pragma once
/// \file
/// The certificate of a sample, with the files beside it that mdm-check reads where it cannot read the user's
/// own.

#include "files/output.hpp"
#include "particles/sample_certifier.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <optional>
#include <string>
#include <vector>

namespace mdm {

/// PROOF, and where they are needed PROOF.sample.csv and PROOF.gradation.csv.
class SampleProofFiles {
public:
  /// Refuses a PROOF that is standard output, or of which a file is one of the others.
  static void check(const std::string &proof, const std::vector<std::string> &others);

  /// \param gradation  the file that was read
  /// \param sample  the file of a canonical sample, which is not written again
  /// \throws InputError if a file cannot be written
  SampleProofFiles(std::string proof, std::string gradation, const UnderstoodGradation &read,
                   std::optional<std::string> sample);

  /// What takes the canonical sample; empty if it is there. It must not outlive the files.
  SampleCertifier::Begin begin();

  /// Writes the certificate, or says in the notes why there is none.
  void write(const std::string &certificate, const std::string &missing, std::vector<std::string> &notes);
  /// Makes all files final, if there is a certificate.
  void commit();

private:
  std::string path_, gradation_path_;
  std::optional<std::string> sample_path_;
  Output proof_;
  std::optional<Output> gradation_, sample_;
  bool has_proof_ = false;
};

} // namespace mdm
