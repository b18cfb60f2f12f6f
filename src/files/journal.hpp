#pragma once
/// \file
/// A solver's answers so far, kept for a run that is interrupted.

#include "crosscheck/other_answer.hpp"
#include "files/journal_file.hpp"

#include <mdm/gradation/gradation.hpp>

#include <cstdint>

namespace mdm {

/// A file of JSON Lines, each an answer that json_answer reads with the keys `solver`, `line` (of the suite)
/// and `gradation` (a digest of what the solver was asked) before it. Each answer is written as a whole when
/// it comes; a last line without its end, of a run that was killed while writing, is dropped. Lines of other
/// solvers stay and are not used.
class Journal {
public:
  /// Opens or makes the file. \throws InputError if that fails, it is no such file, or another run has it
  /// open
  Journal(std::string path, std::string solver);

  /// The last answer of this solver to the gradation g in that line of the suite; null where there is none,
  /// or it is to a gradation that was corrected since.
  /// \throws InputError if the answer there is to one with another id
  const OtherAnswer *find(std::uint64_t line, const Gradation &g) const;
  /// Adds an answer; several threads may. \throws InputError if it cannot be written
  void add(std::uint64_t line, const Gradation &g, const OtherAnswer &answer);

private:
  struct Kept {
    std::string gradation; ///< digest
    OtherAnswer answer;
  };

  void take(std::string_view text, std::size_t number);

  JournalFile file_;
  std::string solver_;
  std::map<std::uint64_t, Kept> answers_; ///< of this solver, by line of the suite
};

} // namespace mdm
