#pragma once
/// \file
/// The options of solving, and those of them that more commands share.

#include "ask/solve_options.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace mdm::cli {

/// Adds the options that say how a gradation is to be taken, for every command that weighs particles.
void add_gradation_options(CLI::App &command, GradationTexts &texts);

/// Adds all options of solving but --band and --pan-size, for a command that has these of its own.
void add_match_options(CLI::App &command, SolveTexts &texts, BudgetTexts &budget);

/// Adds what is asked alone, without limits.
void add_asked_options(CLI::App &command, SolveTexts &texts);

/// The file of a law by table, unpacked, which is read once.
std::string law_in_file(const std::string &path);

/// The envelope in a file. \throws InputError naming it
Envelope band_in_file(const std::string &path);

/// All options of solving, with those of a budget of particles.
struct SolveFlags : SolveTexts {
  BudgetTexts budget;

  void add_to(CLI::App &command);
  /// Without a budget, and without those that only change the sizes of an answer.
  void add_problem(CLI::App &command);
  /// The options that were given, in one order, as a command has them; the band and the law by a table by
  /// their SHA-256.
  /// \throws InputError if the band cannot be read, or there is no libcrypto
  std::string words() const;

private:
  void add_limits(CLI::App &command);
};

} // namespace mdm::cli
