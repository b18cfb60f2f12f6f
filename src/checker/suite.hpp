#pragma once

#include <string>

namespace mdm::checker {

/// Checks the certificates NUMBER.proof and NUMBER-ID.proof of a folder, each against the line NUMBER of the
/// suite (JSON Lines), and writes the verdicts and their numbers. Without `verbose`, accepted ones are only
/// counted. Returns the worst code; a line without a certificate counts as refused, a certificate without a
/// line as malformed. Throws std::runtime_error where suite or folder cannot be read.
int check_suite(const std::string &suite, const std::string &folder, bool verbose);

/// The same of each NAME.proof against the gradation file NAME.gradation beside it.
int check_folder(const std::string &folder, bool verbose);

} // namespace mdm::checker
