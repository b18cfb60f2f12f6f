// A question as an integer program (Theorem 26). What comes in is a gradation with a question, its law
// rational at the openings; what goes out are rows with integer coefficients.
//
// An exact match has a scale s with q_j f_j < s m_j <= q_j F_j for every class. In integers alone the scale
// goes: q_j F_j m_i > q_i f_i m_j for every pair of classes, and a difference of integers above 0 is at least
// 1. With real numbers but without strict inequalities the largest scale for given counts is s = q_i F_i /
// m_i for some class i, and there s m_j - q_j f_j is a multiple of 1 / m_i: at least 1 / max m.
//
// Within a tolerance the masses t_j are variables (Theorem 12). For given counts the largest slack of the
// strict rows is a corner of a polyhedron with integer coefficients, so that it is at least one over the
// largest determinant (Cramer), which is at most the product of the longest rows (Hadamard). The step is
// spread over the particles of a class, of which there are at most as many as in a match that is known: then
// a class without particles needs no case of its own.

#include "crosscheck/integer_program.hpp"

#include "match/tolerant_problem.hpp"
#include "number/common_denominator.hpp"
#include "proof/linear_classes.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/number/integer.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace mdm {
namespace {

/// A match that is known without a search: so many particles are enough.
struct KnownMatch {
  Rational scale;         ///< s
  std::vector<Integer> q; ///< of each class with mass
  Integer particles = 0;
};

/// At a scale at which every class has room for a whole number between s m / F and s m / f.
KnownMatch known_match(const std::vector<LinearClass> &classes, const Integer &at_least) {
  KnownMatch known;
  Rational a_scale = 0; // the sum of m / F
  for (const LinearClass &c : classes) {
    known.scale = std::max(known.scale, Rational(ratio(c.f * c.F, c.mass * (c.F - c.f))));
    known.scale = std::max(known.scale, Rational(ratio(c.floor * c.F, c.mass)));
    a_scale += ratio(c.mass, c.F);
  }
  known.scale = std::max(known.scale, Rational(at_least / a_scale));
  for (const LinearClass &c : classes) {
    known.q.push_back(ceil(Rational(known.scale * c.mass / c.F)));
    known.particles += known.q.back();
  }
  return known;
}

void add_term(ProgramRow &row, std::size_t variable, const Integer &coefficient) {
  if (coefficient != 0)
    row.terms.emplace_back(variable, coefficient);
}

/// sum q >= n.
void add_number(IntegerProgram &program, const Integer &n) {
  ProgramRow row{"number", {}, n};
  for (std::size_t j = 0; j < program.counts; ++j)
    row.terms.emplace_back(j, 1);
  program.rows.push_back(std::move(row));
}

std::string exact_text(const Rational &r) {
  return exact_decimal(r).value_or(to_string(r));
}

std::string name_of_count(std::size_t index) {
  return fmt::format("q{}", index + 1);
}

/// What the counts are, in comments.
void describe_counts(IntegerProgram &program, const Gradation &g, const Question &question,
                     const std::vector<std::size_t> &classes) {
  std::vector<std::string> &comments = program.comments;
  comments.push_back(fmt::format("The smallest set of particles that matches {}: minimise the sum of all q.",
                                 in_quotes(g.id())));
  const std::string asked = in_words(question, g.unit());
  if (!asked.empty())
    comments.push_back("Asked: " + asked + ".");
  const std::string all = exact_text(sum(g.masses()));
  for (const std::size_t j : classes)
    comments.push_back(fmt::format("{}: particles above {} and up to {} {}, which hold {} of {} of the mass.",
                                   name_of_count(j), g.opening_text(j), g.opening_text(j + 1), name(g.unit()),
                                   exact_text(g.mass(j)), all));
  if (classes.size() < g.classes())
    comments.push_back("Classes without mass have no particles, and no variable.");
}

IntegerProgram with_counts(const std::vector<LinearClass> &classes) {
  IntegerProgram program;
  for (const LinearClass &c : classes)
    program.variables.push_back({name_of_count(c.index), true, c.floor, std::nullopt});
  program.counts = classes.size();
  return program;
}

/// The counts of an exact match, without a scale.
void add_pairs(IntegerProgram &program, const std::vector<LinearClass> &classes, const KnownMatch &known) {
  Integer floors = 0;
  for (const LinearClass &c : classes)
    floors += c.floor;
  for (std::size_t j = 0; j < classes.size(); ++j) {
    program.variables[j].most = known.particles - floors + classes[j].floor;
    for (std::size_t i = 0; i < classes.size(); ++i) {
      if (i == j || classes[i].f == 0)
        continue;
      const Integer A = classes[j].F * classes[i].mass, B = classes[i].f * classes[j].mass;
      const Integer common = gcd(A, B);
      program.rows.push_back({fmt::format("pair{}_{}", classes[j].index + 1, classes[i].index + 1),
                              {{j, A / common}, {i, -(B / common)}},
                              1});
    }
  }
  program.comments.push_back(
      "Of each pair of classes the largest mass of one, over its share, is above the smallest of the other.");
  program.comments.push_back(
      fmt::format("There is a match of {} particles, so that no count is above its bound in a smallest one.",
                  to_string(known.particles)));
}

/// The counts of an exact match, and its scale.
void add_scale(IntegerProgram &program, const std::vector<LinearClass> &classes, bool is_strict) {
  const std::size_t s = program.variables.size();
  program.variables.push_back({"s", false, 0, std::nullopt});
  Integer step = 1; // s is the scale times this
  if (!is_strict)
    for (const LinearClass &c : classes)
      step = std::max(step, c.mass);
  for (std::size_t j = 0; j < classes.size(); ++j) {
    const LinearClass &c = classes[j];
    ProgramRow upper{fmt::format("upper{}", c.index + 1), {{j, c.F * step}, {s, -c.mass}}};
    ProgramRow lower{fmt::format("lower{}", c.index + 1), {{s, c.mass}}, is_strict ? 0 : 1, is_strict};
    add_term(lower, j, -(c.f * step));
    program.rows.push_back(std::move(upper));
    program.rows.push_back(std::move(lower));
  }
  program.comments.push_back("s times its share is the mass of a class: above q of its smallest particles, "
                             "at most q of its largest.");
  if (!is_strict)
    program.comments.push_back("Where s can be had with > 0 it can be had with >= 1 (Theorem 26).");
}

/// The rows of a tolerance in integers.
class TolerantRows {
public:
  TolerantRows(const TolerantProblem &problem, IntegerProgram &program)
      : problem_(problem), program_(program), k_(problem.classes()) {}

  void add() {
    for (std::size_t v = k_; v < problem_.variables(); ++v)
      program_.variables.push_back(
          {fmt::format("{}{}", v < 2 * k_ ? "t" : "p", v % k_ + 1), false, 0, std::nullopt});
    for (const LinearRow &row : problem_.rows())
      if (row.condition != TolerantCondition::some_mass && row.condition != TolerantCondition::at_least)
        add_row(row);
  }

  /// An integer of which no slack that is above 0 is below its inverse.
  Integer determinant() const {
    const std::size_t columns = problem_.variables() - k_ + 1;
    std::vector<Integer> lengths(columns, Integer(1)); // t >= 0, p >= 0 and the slack at most 1
    for (const ProgramRow &row : program_.rows) {
      Integer length = row.is_strict ? 1 : 0; // the column of the slack
      for (const auto &[variable, coefficient] : row.terms)
        if (variable >= k_)
          length += coefficient * coefficient;
      lengths.push_back(std::move(length));
    }
    std::partial_sort(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(columns), lengths.end(),
                      std::greater<>());
    Integer square = 1;
    for (std::size_t i = 0; i < columns; ++i)
      square *= lengths[i];
    return floor_root(square, 2) + 1;
  }

  /// Makes strict rows steps. \param most  particles that are enough
  void step(const Integer &most) {
    const Integer steps = determinant() * most;
    for (ProgramRow &row : program_.rows) {
      if (!row.is_strict)
        continue;
      row.is_strict = false;
      row.where.reset();
      const std::size_t j =
          row.terms.front().first < k_ ? row.terms.front().first : row.terms.front().first - k_;
      for (auto &[variable, coefficient] : row.terms)
        coefficient *= steps;
      if (row.terms.front().first < k_)
        row.terms.front().second -= 1;
      else
        row.terms.emplace(row.terms.begin(), j, -1);
    }
    program_.comments.push_back(fmt::format(
        "The mass of a class is above that of q of its smallest particles; where it is, it can be so by q/{} "
        "(Theorem 26).",
        to_string(steps)));
  }

private:
  void add_row(const LinearRow &row) {
    std::vector<Rational> numbers = {row.constant};
    for (const auto &term : row.terms)
      numbers.push_back(term.second);
    const std::vector<Integer> cleared = CommonDenominator(numbers).numerators;
    ProgramRow made{fmt::format("r{}", program_.rows.size() + 1), {}, cleared.front()};
    for (std::size_t t = 0; t < row.terms.size(); ++t)
      add_term(made, row.terms[t].first, cleared[t + 1]);
    made.is_strict = row.condition == TolerantCondition::above_lower;
    if (made.is_strict && problem_.least(row.j) < 1)
      made.where = row.j;
    program_.rows.push_back(std::move(made));
  }

  const TolerantProblem &problem_;
  IntegerProgram &program_;
  std::size_t k_;
};

/// The particles of the match whose shares are those of the gradation.
Integer known_particles(const TolerantProblem &problem, const std::vector<LinearClass> &classes,
                        const Integer &at_least, const std::string &form_name) {
  const KnownMatch known = known_match(classes, at_least);
  std::vector<Integer> q(problem.classes());
  std::vector<Rational> t(problem.classes());
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const std::size_t j = classes[i].index;
    q[j] = known.q[i];
    // From the unit of the one problem to that of the other.
    t[j] = known.scale * classes[i].mass * problem.F(j) / classes[i].F;
  }
  if (!problem.is_match(q, t))
    throw InputError(form_name +
                     ": the gradation itself is not within what is asked, and without a match "
                     "that is known there is no step for its strict inequalities: ask for smt2 or "
                     "json, which have them");
  return known.particles;
}

IntegerProgram exact_program(const Gradation &g, const Question &question, ProgramForm form,
                             const std::string &form_name) {
  const Problem problem(g, question.law, question.min_per_class);
  const std::vector<LinearClass> classes = linear_classes(problem, form_name);
  IntegerProgram program = with_counts(classes);
  std::vector<std::size_t> with_mass;
  for (const LinearClass &c : classes)
    with_mass.push_back(c.index);
  describe_counts(program, g, question, with_mass);
  if (form == ProgramForm::integers)
    add_pairs(program, classes, known_match(classes, question.at_least));
  else
    add_scale(program, classes, form == ProgramForm::strict);
  return program;
}

IntegerProgram tolerant_program(const Gradation &g, const Question &question, ProgramForm form,
                                const std::string &form_name) {
  if (form == ProgramForm::integers)
    throw InputError(form_name + ": masses within a tolerance are real numbers, and this form has integers "
                                 "alone: ask for smt2, lp, mps or json");
  const TolerantProblem problem(g, question.law,
                                tolerance_of(g, question.tolerances, question.band, question.size_factor),
                                {question.min_per_class, question.at_least, std::nullopt});
  IntegerProgram program;
  std::vector<std::size_t> all;
  for (std::size_t j = 0; j < problem.classes(); ++j) {
    program.variables.push_back({name_of_count(j), true, problem.least(j), std::nullopt});
    all.push_back(j);
  }
  program.counts = problem.classes();
  describe_counts(program, g, question, all);
  program.comments.push_back("t is the mass of a class" +
                             std::string(problem.variables() > 2 * problem.classes()
                                             ? ", p what its share is above its target."
                                             : "."));
  TolerantRows rows(problem, program);
  rows.add();
  if (form == ProgramForm::stepped)
    rows.step(known_particles(problem,
                              linear_classes(Problem(g, question.law, question.min_per_class), form_name),
                              question.at_least, form_name));
  return program;
}

} // namespace

IntegerProgram integer_program(const Gradation &g, const Question &question, ProgramForm form,
                               const std::string &form_name) {
  if (question.solids)
    throw InputError(form_name +
                     ": a volume of solids is not written, as that of a box has the factor pi and such a "
                     "program rational numbers: leave it out, or ask for " +
                     option("at-least") + " so many particles");
  const Gradation asked = asked_gradation(g, question);
  IntegerProgram program = question.is_tolerant() ? tolerant_program(asked, question, form, form_name)
                                                  : exact_program(asked, question, form, form_name);
  program.id = g.id();
  if (question.is_tolerant() || question.at_least > 1) // an exact match has particles anyhow
    add_number(program, question.at_least);
  return program;
}

} // namespace mdm
