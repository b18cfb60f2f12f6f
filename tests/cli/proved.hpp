#pragma once
/// \file
/// A gradation that mdm solve has proved something of.

#include "run.hpp"

namespace cli_test {

/// The gradation and its proof in files, the report, and what mdm-check says of them.
struct ProvedGradation {
  TemporaryFolder folder;
  std::string gradation, proof, text;

  /// \param name  of the gradation's file, without its ending
  ProvedGradation(const std::string &name, const std::string &content, const Arguments &options,
                  int exit_code) {
    gradation = folder.write(name + ".csv", content);
    proof = folder / name + ".proof";
    Arguments arguments{"solve", gradation, "--proof", proof};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = mdm(arguments);
    INFO(outcome.err);
    CHECK(outcome.exit_code == exit_code);
    text = outcome.out;
  }
  Outcome verdict() const { return mdm_check(gradation, proof); }
  /// The exit code for the proof with a part replaced.
  int forged(const std::string &part, const std::string &by) const {
    std::string certificate = read_file(proof);
    const std::size_t at = certificate.find(part);
    INFO(certificate);
    REQUIRE(at != std::string::npos);
    certificate.replace(at, part.size(), by);
    return mdm_check(gradation, folder.write("forged.proof", certificate)).exit_code;
  }
};

} // namespace cli_test
