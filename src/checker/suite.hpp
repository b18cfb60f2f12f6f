#pragma once

#include "verdicts.hpp"

#include <string>

namespace mdm::checker {

/// Checks the certificates of a suite (JSON Lines), each against its line, and writes the verdicts and their
/// numbers. Of a folder they are NUMBER.proof and NUMBER-ID.proof, each of the line NUMBER; of a stream
/// its index names the lines, and where one of them is not what it should be, this is one certificate that is
/// malformed, and the rest is not checked. Beside NUMBER.proof in a folder may be NUMBER.proof.finer, the
/// second proof of a budget. Returns the worst code; a line without a certificate counts as
/// refused, a certificate without a line as malformed. With `answers`, the name of a file, each is compared
/// with that of its line; where one is not what it should be, or there are more or fewer than lines, it is
/// malformed. Throws std::runtime_error where a file or the folder cannot be read.
int check_suite(const std::string &suite, const std::string &proofs, const Manner &manner,
                const std::optional<std::string> &answers = {});

/// Judges each NAME.proof and NAME.proof.finer of a folder against the gradation file NAME.gradation beside
/// it, a line a verdict. Returns the worst code.
int check_folder(const std::string &folder, const Manner &manner);

} // namespace mdm::checker
