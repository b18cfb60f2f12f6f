#pragma once

#include "program_files.hpp"

#include <gmpxx.h>

#include <memory>

namespace mdm::checker {

/// A class of an answer: openings, the quantity, and the bounds of a particle's size, where it has any.
struct AnswerClass {
  mpq_class lower, upper;
  mpz_class quantity;
  std::optional<mpq_class> lo, hi;
};

/// Bounds on shares that an answer gives, a pair a class.
using ShareRanges = std::vector<std::pair<mpq_class, mpq_class>>;

/// What only JSON says of an answer.
struct AnswerQuestion {
  std::string status; ///< optimal, feasible, none, unknown or error
  std::optional<mpz_class> particles, lower_bound;
  bool is_tolerant = false;
  ShareRanges retained, passing; ///< empty: none
  std::optional<mpq_class> total;
  std::string words, tolerances; ///< the options that change the problem; those of them that are tolerances
};

/// An answer of mdm batch: a line of JSON (mdm-answer-1) or the rows of CSV.
struct Answer {
  std::string place; ///< file:line, for messages
  std::string id;    ///< of CSV alone, whose rows are of the lines that have one
  std::string unit;  ///< of lengths; empty: it is not said
  std::vector<AnswerClass> classes;
  bool has_no_particles = false; ///< of CSV alone: its quantities are empty
  bool has_powers =
      false; ///< openings are to the power of the root; without, and with a root, they are rounded
  std::optional<AnswerQuestion> question;
};
using SharedAnswer = std::shared_ptr<const Answer>;

/// The answers of a file, one after the other.
class Answers {
public:
  /// A file that is not what it should be. What follows cannot be read.
  struct Broken : std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  /// Throws std::runtime_error where the file cannot be read, as next() does.
  explicit Answers(const std::string &path) : lines_(path) {}

  /// The next one; nothing at the end. Throws Broken.
  SharedAnswer next();
  /// The next one, if it is of this line of the suite; nothing where it is of a later one, or at the end of
  /// CSV, which has no rows of a line that is no gradation. Throws Broken at the end of JSON, which has one
  /// of every line.
  SharedAnswer of(const Input &line, std::uint64_t number);
  const std::string &name() const { return lines_.name(); }

private:
  std::optional<Input> next_line();

  InputLines lines_;
  std::optional<Input> row_; ///< of CSV, the first of the next answer
  SharedAnswer later_;       ///< of CSV, one that is of a later line
  std::string unit_;         ///< of CSV
  bool is_csv_ = false;
};

/// What an answer says that an accepted certificate does not; empty if both say the same.
std::string difference(const Answer &answer, std::string_view gradation, std::string_view certificate);

} // namespace mdm::checker
