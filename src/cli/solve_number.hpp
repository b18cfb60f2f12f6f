#pragma once
/// \file
/// mdm solve of a gradation by number.

#include "cli/commands.hpp"
#include "cli/output_flags.hpp"
#include "cli/solve_flags.hpp"

#include <optional>
#include <string>

namespace mdm::cli {

/// What mdm solve was asked of such a file.
struct NumberRequest {
  const std::string &file;
  const std::string &content;
  const SolveFlags &flags;
  const OutputFlags &output;
  const std::optional<std::string> &proof;
  /// An option besides those above that was given, as messages name it; empty: none.
  std::string idle;
};

/// Refuses an option, as messages name it, beside a file of shares by number.
[[noreturn]] void refuse_beside_numbers(const std::string &given, const std::string &file);

/// Answers, and writes the proof.
/// \throws InputError where an option says nothing of shares by number
Exit solve_number(const NumberRequest &request);

} // namespace mdm::cli
