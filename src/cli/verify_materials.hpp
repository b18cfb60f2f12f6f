#pragma once
/// \file
/// mdm verify with a gradation of several materials.

#include "ask/verifier.hpp"
#include "cli/output_flags.hpp"

#include <string>

namespace mdm::cli {

/// What mdm verify was asked of such a gradation.
struct MaterialRequest {
  const std::string &gradation, &content, &sample;
  const VerifyTexts &asked;
  const OutputFlags &output;
  /// An option besides `asked` that was given, as messages name it; empty: none.
  std::string idle;
};

/// Judges each particle in the classes of its material, and gives the exit code.
/// \throws InputError where an option or the sample says nothing of several materials
int verify_materials(const MaterialRequest &request);

} // namespace mdm::cli
