// Why given counts are no match: the linear program of Theorem 12 with all counts fixed, in exact numbers.
// If it has a solution, that is the masses of a match. If not, the conditions of its contradiction (Farkas)
// are the reasons, which a report puts into words. Where sizes are stated, bounds on the mass of each class
// are conditions too, and may be among the reasons. The program is solved once and has no splits, so that
// it ends with the simplex method.

#include "match/fixed_counts.hpp"

#include "match/simplex.hpp"

namespace mdm {
namespace {

/// The linear program of the masses, where the counts are fixed.
class CountsProgram {
public:
  CountsProgram(const TolerantProblem &problem, const std::vector<Integer> &q)
      : k_(problem.classes()), variables_(problem.variables()), program_(variables_) {
    for (std::size_t j = 0; j < k_; ++j)
      fix(j, Rational(q[j]));
    for (const LinearRow &row : problem.rows()) {
      const std::size_t form = program_.add_form(row.terms);
      rows_.push_back({row.condition, row.j, 1});
      if (row.condition == TolerantCondition::at_least)
        count_ = form;
      const bool is_strict = row.condition == TolerantCondition::some_mass ||
                             (row.condition == TolerantCondition::above_lower && q[row.j] >= 1);
      program_.set_lower(form, is_strict ? Infinitesimal{0, 1} : Infinitesimal{row.constant, 0});
    }
    for (std::size_t p = 2 * k_; p < variables_; ++p)
      program_.set_lower(p, Infinitesimal{});
  }

  void state(std::size_t j, const Rational &lo, const Rational &hi) {
    program_.set_lower(k_ + j, Infinitesimal{lo, 0});
    program_.set_upper(k_ + j, Infinitesimal{hi, 0});
  }

  std::optional<CountConflict> conflict() {
    if (program_.find(count_))
      return std::nullopt;
    CountConflict found;
    for (const Simplex::Term &term : program_.conflict())
      if (term.variable >= variables_)
        found.conditions.push_back(rows_[term.variable - variables_]);
      else if (term.variable >= k_ && term.variable < 2 * k_)
        found.stated.push_back(term.variable - k_);
    return found;
  }

private:
  void fix(std::size_t variable, const Rational &value) {
    program_.set_lower(variable, Infinitesimal{value, 0});
    program_.set_upper(variable, Infinitesimal{value, 0});
  }

  std::size_t k_, variables_;
  Simplex program_;
  std::vector<Multiple> rows_; ///< condition of each form
  std::size_t count_ = 0;      ///< form of at_least
};

} // namespace

std::optional<CountConflict> conflict_of_counts(const TolerantProblem &problem, const std::vector<Integer> &q,
                                                const std::vector<std::optional<MassBounds>> &stated) {
  CountsProgram program(problem, q);
  for (std::size_t j = 0; j < problem.classes(); ++j)
    if (stated[j] && q[j] >= 1)
      program.state(j, Rational(q[j]) * stated[j]->lo, Rational(q[j]) * stated[j]->hi);
  return program.conflict();
}

} // namespace mdm
