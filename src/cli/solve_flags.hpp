#pragma once
/// \file
/// The options of solving, and those of them that more commands share.

#include "ask/solve_options.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace mdm::cli {

/// Adds the options that say how a gradation is to be taken, for every command that weighs particles.
void add_gradation_options(CLI::App &command, GradationTexts &texts);

/// The envelope in a file. \throws InputError naming it
Envelope band_in_file(const std::string &path);

/// All options of solving.
struct SolveFlags : SolveTexts {
  void add_to(CLI::App &command);
  /// Without those that only change the sizes of an answer.
  void add_problem(CLI::App &command);
  /// What is asked alone, without limits.
  void add_asked(CLI::App &command);

  /// The source of the gradation: FILE, or else the band alone.
  const std::string &source(const OptionText &file) const { return file ? *file : *band; }
  /// \param reading an option of reading that is given, or an empty text
  /// \throws InputError if there is neither, or if they do not go together
  void check_source(const OptionText &file, const std::string &reading, const std::string &command) const;
  /// Those of the texts, with the band read from its file.
  AskedQuestion question() const;
  AskedQuestion question_of_both() const;
  /// The options that were given, in one order, as a command has them; the band by its SHA-256.
  /// \throws InputError if the band cannot be read, or there is no libcrypto
  std::string words() const;

private:
  void add_question(CLI::App &command);
  void add_limits(CLI::App &command);
};

} // namespace mdm::cli
