// The proof of an exact match for VIPR checkers (Theorem 10). What comes in is a match with its chain, its
// law rational at the openings; what goes out is a file with the integer program A q_j - B q_i >= 1, the
// solution, and the derivation.
//
// A raise of class j by the level of class i is one rounding (`rnd`) of the constraint of i and j, with the
// bound of q_i that is known: this replays the chain. From the last level each class has a bound, and `lin`
// adds them up to sum q >= N. With at least M particles two assumptions split the cases (Theorem 7). There
// is a constraint for every pair of classes, so that the file grows with their square.

#include "proof/vipr.hpp"

#include "match/at_least.hpp"
#include "match/problem_of.hpp"
#include "proof/linear_classes.hpp"
#include "proof/tolerant_vipr.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>

namespace mdm {
namespace {

[[noreturn]] void refuse_length() {
  throw InputError(option("vipr") + ": the proof has too many steps for an export: leave it out");
}

/// A q_j - B q_i >= 1: q_j F_j m_i > q_i f_i m_j in lowest terms (for i = j one variable, A - B).
struct Pair {
  Integer A, B;
};

Pair pair_of(const LinearClass &i, const LinearClass &j) {
  Pair p{j.F * i.mass, i.f * j.mass};
  const Integer common = gcd(p.A, p.B);
  p.A /= common;
  p.B /= common;
  return p;
}

/// Writes the file section by section; derived constraints are numbered behind those of the problem.
class ChainWriter {
public:
  explicit ChainWriter(const Match &m)
      : m_(m), problem_(problem_of(m)), particles_(*m.particles()),
        classes_(linear_classes(problem_, option("vipr"))) {}

  std::string text() {
    derive();
    const std::size_t k = classes_.size();
    out("% mdm: the smallest number of particles that match exactly\nVER 1.0\nVAR {}\n", k);
    for (std::size_t j = 0; j < k; ++j)
      out("{}q{}", separator(j), problem_.classes()[j].index + 1);
    out("\nINT {}\n", k);
    for (std::size_t j = 0; j < k; ++j)
      out("{}{}", separator(j), j);
    out("\nOBJ min\n{}", k);
    for (std::size_t j = 0; j < k; ++j)
      out(" {} 1", j);
    constraints();
    const std::string n = to_string(particles_);
    out("RTP range {} {}\nSOL 1\nmatch {}", n, n, k);
    for (std::size_t j = 0; j < k; ++j)
      out(" {} {}", j, to_string(m_.sample->quantities[problem_.classes()[j].index]));
    out("\nDER {}\n", derived_);
    return fmt::to_string(file_) + fmt::to_string(derivation_);
  }

private:
  /// A derived lower bound of one count, and the constraint that states it.
  struct Bound {
    Integer value;
    std::size_t constraint;
  };

  static const char *separator(std::size_t j) { return j == 0 ? "" : " "; }

  template <class... Args>
  void out(fmt::format_string<Args...> format, Args &&...args) {
    fmt::format_to(std::back_inserter(file_), format, std::forward<Args>(args)...);
  }

  bool asks_for_number() const { return m_.question.at_least > 1; }

  // Order of the constraints: k floors, k^2 pairs (i, j), the asked number.
  std::size_t pair_index(std::size_t i, std::size_t j) const { return classes_.size() * (i + 1) + j; }
  std::size_t number_index() const { return pair_index(classes_.size(), 0); }
  std::size_t given() const { return number_index() + (asks_for_number() ? 1 : 0); }

  void constraints() {
    const std::size_t k = classes_.size();
    out("\nCON {} {}\n", given(), k);
    for (std::size_t j = 0; j < k; ++j)
      out("f{} G {} 1 {} 1\n", j + 1, to_string(classes_[j].floor), j);
    for (std::size_t i = 0; i < k; ++i)
      for (std::size_t j = 0; j < k; ++j) {
        const Pair p = pair_of(classes_[i], classes_[j]);
        if (i == j)
          out("p{}_{} G 1 1 {} {}\n", i + 1, j + 1, j, to_string(Integer(p.A - p.B)));
        else if (p.B == 0)
          out("p{}_{} G 1 1 {} {}\n", i + 1, j + 1, j, to_string(p.A));
        else
          out("p{}_{} G 1 2 {} {} {} {}\n", i + 1, j + 1, j, to_string(p.A), i, to_string(Integer(-p.B)));
      }
    if (asks_for_number())
      out("n G {} OBJ\n", to_string(m_.question.at_least));
  }

  /// Appends a derived constraint and returns its number.
  template <class... Args>
  std::size_t derive(fmt::format_string<Args...> format, Args &&...args) {
    const std::size_t index = given() + derived_++;
    fmt::format_to(std::back_inserter(derivation_), "d{} ", index);
    fmt::format_to(std::back_inserter(derivation_), format, std::forward<Args>(args)...);
    fmt::format_to(std::back_inserter(derivation_), " -1\n");
    return index;
  }

  std::vector<Bound> floors() const {
    std::vector<Bound> bounds;
    for (std::size_t j = 0; j < classes_.size(); ++j)
      bounds.push_back({classes_[j].floor, j});
    return bounds;
  }

  /// Raises the bound of class j by that of class i, if it does: one rounding.
  void raise(std::vector<Bound> &bounds, std::size_t i, std::size_t j) {
    const Pair p = pair_of(classes_[i], classes_[j]);
    const Integer least = floor_div(Integer(p.B * bounds[i].value), p.A) + 1;
    if (i == j || least <= bounds[j].value)
      return;
    if (p.B == 0)
      bounds[j].constraint = derive("G {} 1 {} 1 {{ rnd 1 {} {} }}", to_string(least), j, pair_index(i, j),
                                    to_string(ratio(1, p.A)));
    else
      bounds[j].constraint =
          derive("G {} 1 {} 1 {{ rnd 2 {} {} {} {} }}", to_string(least), j, pair_index(i, j),
                 to_string(ratio(1, p.A)), bounds[i].constraint, to_string(ratio(p.B, p.A)));
    bounds[j].value = least;
  }

  /// Follows the chain from the bounds given, then states that the sum is at least N.
  std::size_t follow(std::vector<Bound> bounds, const Steps &chain) {
    for (std::size_t step = 1; step < chain.size(); ++step)
      raise(bounds, chain[step - 1], chain[step]);
    for (std::size_t j = 0; !chain.empty() && j < bounds.size(); ++j)
      raise(bounds, chain.back(), j);
    std::string terms;
    for (const Bound &b : bounds)
      terms += fmt::format(" {} 1", b.constraint);
    return derive("G {} OBJ {{ lin {}{} }}", to_string(particles_), bounds.size(), terms);
  }

  void derive() {
    const Chain &chain = std::get<Chain>(m_.evidence().value());
    if (asks_for_number() && particles_ == m_.question.at_least)
      derive("G {} OBJ {{ lin 1 {} 1 }}", to_string(particles_), number_index());
    else if (chain.above)
      split(*chain.above);
    else
      follow(floors(), places_of(chain));
  }

  /// The steps of the chain as places in the problem.
  Steps places_of(const Chain &chain) const {
    std::vector<std::uint32_t> place(m_.gradation.classes());
    for (std::uint32_t i = 0; i < classes_.size(); ++i)
      place[problem_.classes()[i].index] = i;
    Steps steps;
    for (const std::uint32_t j : chain.steps)
      steps.push_back(place[j]);
    return steps;
  }

  /// At least M particles, N > M (Theorem 7): either all q_j <= h_j, the most at the scale z, which is too
  /// few in sum, or some q_j >= h_j + 1, which puts the scale above z.
  void split(const Rational &above) {
    const std::vector<std::optional<Integer>> most =
        largest_counts(problem_, Rational(above / problem_.scale_unit()), false);
    std::vector<std::size_t> few;
    std::string terms = fmt::format(" {} 1", number_index());
    for (std::size_t j = 0; j < most.size(); ++j) {
      few.push_back(derive("L {} 1 {} 1 {{ asm }}", to_string(*most[j]), j));
      terms += fmt::format(" {} -1", few[j]);
    }
    const std::string n = to_string(particles_);
    std::size_t proved = derive("G {} OBJ {{ lin {}{} }}", n, most.size() + 1, terms);
    for (std::size_t j = 0; j < most.size(); ++j) {
      const Integer more = *most[j] + 1;
      std::vector<Bound> bounds = floors();
      const std::size_t many = derive("G {} 1 {} 1 {{ asm }}", to_string(more), j);
      if (more > bounds[j].value)
        bounds[j] = {more, many};
      const LeastMatch least = least_match(problem_.with_floor(j, more));
      if (!least.complete)
        refuse_length();
      const std::size_t branch = follow(std::move(bounds), least.chain);
      proved = derive("G {} OBJ {{ uns {} {} {} {} }}", n, branch, many, proved, few[j]);
    }
  }

  const Match &m_;
  const Problem problem_;
  const Integer particles_;
  std::vector<LinearClass> classes_;
  fmt::memory_buffer file_, derivation_;
  std::size_t derived_ = 0;
};

} // namespace

std::string vipr(const Match &m) {
  assert(m.complete);
  const auto has_mass = [](const Rational &mass) { return mass != 0; };
  const std::vector<Rational> &masses = m.gradation.masses();
  if (static_cast<std::size_t>(std::count_if(masses.begin(), masses.end(), has_mass)) > most_vipr_classes)
    throw InputError(
        option("vipr") +
        ": more than 200 classes have mass, the export has a constraint for each pair: leave it out");
  if (m.tolerance && !m.evidence())
    refuse_length();
  return m.tolerance ? tolerant_vipr(m) : ChainWriter(m).text();
}

} // namespace mdm
