#pragma once
/// \file
/// Another solver, as a program that is asked.

#include "files/journal.hpp"

#include <mdm/gradation/gradation.hpp>

#include <chrono>
#include <memory>

namespace mdm {

/// What a program wrote when it was asked, or why there is nothing.
struct ProgramAnswer {
  std::string text;
  std::optional<AnswerVerdict> failure; ///< timeout, garbage, crashed or no_answer
  std::string reason;
};

/// Runs a command of /bin/sh with the question on its standard input; whatever it does is an answer or a
/// failure.
/// \throws InputError if it cannot be started
ProgramAnswer ask_program(const std::string &command, const std::string &question,
                          std::chrono::milliseconds time_limit);

/// A program that reads a gradation as JSON and writes its answer as JSON; its journal remembers answers.
class Solver {
public:
  /// \param command for /bin/sh
  /// \throws InputError if the journal cannot be used
  Solver(std::string command, std::chrono::milliseconds time_limit,
         const std::optional<std::string> &journal);

  /// The answer to the gradation in that line of the suite; whatever the program does is an answer or a
  /// failure of it. Several threads may ask at once.
  /// \throws InputError if the program cannot be started, or the journal not be written
  OtherAnswer answer(const Gradation &g, std::uint64_t line);

private:
  OtherAnswer ask(const Gradation &g) const;

  std::string command_;
  std::chrono::milliseconds time_limit_;
  std::unique_ptr<Journal> journal_;
};

} // namespace mdm
