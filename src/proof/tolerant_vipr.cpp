// The proof within a tolerance for VIPR checkers (Theorem 15). VIPR has no strict inequalities, so one
// variable d stands for what all strict conditions exceed their bounds by, and the claim is d <= 0 for
// fewer than N particles; y_j says that class j is not empty.
//
// The derivation follows the tree: `asm` lines for the two cases of a split, `lin` lines for its leaves,
// `uns` lines where both cases are done. Behind a split at which a class becomes certain to hold a
// particle, its strict condition is derived once and used below. Where only some class of several is, that
// is shown class by class. Subtrees come in the order of the tree, so that a walk over it writes the file.

#include "proof/tolerant_vipr.hpp"

#include "match/leaf_sum.hpp"
#include "match/problem_of.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <map>

namespace mdm {
namespace {

/// Writes the file section by section; derived constraints are numbered behind those of the problem.
class TreeVipr {
public:
  explicit TreeVipr(const Match &m)
      : problem_(tolerant_problem_of(m)), tree_(std::get<Tree>(m.evidence().value())), k_(problem_.classes()),
        variables_(problem_.variables()), least_(k_), least_value_(k_), most_(k_), strict_(k_), filled_(k_) {
    if (m.sample)
      fewer_ = *m.particles() - 1;
    for (std::size_t j = 0; j < k_; ++j)
      least_value_[j] = problem_.least(j);
  }

  std::string text() {
    constraints();
    next_ = given_;
    subtree();
    header();
    return fmt::to_string(header_) + fmt::to_string(constraints_) +
           fmt::format("RTP range -inf 0\nSOL 0\nDER {}\n", next_ - given_) + fmt::to_string(derivation_);
  }

private:
  using Terms = std::vector<std::pair<std::size_t, Rational>>;

  // Variables: those of the problem, d, and y_j, 1 where class j holds particles and may be empty.
  std::size_t d() const { return variables_; }
  std::size_t y(std::size_t j) const { return variables_ + 1 + j; }
  bool has_y() const { return fewer_.has_value(); }
  bool is_optional(std::size_t j) const { return problem_.least(j) < 1; }

  static std::string to_text(const Terms &terms) {
    std::string text = fmt::format("{}", terms.size());
    for (const auto &[variable, coefficient] : terms)
      text += fmt::format(" {} {}", variable, to_string(coefficient));
    return text;
  }

  template <class... Args>
  void out(fmt::format_string<Args...> format, Args &&...args) {
    fmt::format_to(std::back_inserter(header_), format, std::forward<Args>(args)...);
  }

  void header() {
    if (fewer_)
      out("% mdm: no {} particles or fewer match within the tolerance: d > 0 is impossible\n",
          to_string(*fewer_));
    else
      out("% mdm: no particles match within the tolerance: d > 0 is impossible\n");
    out("VER 1.0\nVAR {}\n", variables_ + 1 + (has_y() ? k_ : 0));
    for (const char *name : {"q", "t", "p"})
      for (std::size_t j = 0; j < k_ && (*name != 'p' || variables_ == 3 * k_); ++j)
        out("{}{} ", name, j + 1);
    out("d");
    for (std::size_t j = 0; j < k_ && has_y(); ++j)
      out(" y{}", j + 1);
    out("\nINT {}\n", has_y() ? 2 * k_ : k_);
    for (std::size_t j = 0; j < k_; ++j)
      out("{} ", j);
    for (std::size_t j = 0; j < k_ && has_y(); ++j)
      out("{} ", y(j));
    out("\nOBJ max\n1 {} 1\nCON {} {}\n", d(), given_, bounds_);
  }

  std::size_t given(const std::string &name, char sense, const Rational &constant, const Terms &terms) {
    fmt::format_to(std::back_inserter(constraints_), "{} {} {} {}\n", name, sense, to_string(constant),
                   to_text(terms));
    return given_++;
  }

  void constraints() {
    for (std::size_t j = 0; j < k_; ++j)
      least_[j] = given(fmt::format("q{}", j + 1), 'G', Rational(problem_.least(j)), {{j, 1}});
    for (std::size_t p = 2 * k_; p < variables_; ++p)
      row_[{TolerantCondition::excess_sign, p - 2 * k_}] =
          given(fmt::format("p{}", p - 2 * k_ + 1), 'G', 0, {{p, 1}});
    for (std::size_t j = 0; j < k_ && has_y(); ++j)
      given(fmt::format("y{}", j + 1), 'L', 1, {{y(j), 1}});
    bounds_ = given_;
    for (const LinearRow &row : problem_.rows())
      row_[{row.condition, row.j}] = given(fmt::format("r{}", given_), 'G', row.constant, with_slack(row));
    for (std::size_t j = 0; j < k_ && has_y(); ++j)
      fill(j);
    if (!fewer_)
      return;
    Terms counts;
    for (std::size_t j = 0; j < k_; ++j)
      counts.emplace_back(j, 1);
    row_[{TolerantCondition::fewer, 0}] = given("fewer", 'L', Rational(*fewer_), counts);
  }

  /// A condition that is always strict, less d.
  Terms with_slack(const LinearRow &row) {
    Terms terms = row.terms;
    const bool strict = row.condition == TolerantCondition::some_mass ||
                        (row.condition == TolerantCondition::above_lower && !is_optional(row.j));
    if (strict)
      terms.emplace_back(d(), -1);
    if (strict && row.condition == TolerantCondition::above_lower)
      strict_[row.j] = given_;
    return terms;
  }

  /// Where class j is not empty, y_j = 1 and its lower bound is strict.
  void fill(std::size_t j) {
    if (!is_optional(j))
      return;
    Integer widest = 0;
    for (std::size_t i = 0; i < k_; ++i)
      widest = std::max(widest, Integer(problem_.F(i) - problem_.f(i)));
    most_excess_ = Rational(widest * *fewer_);
    given(fmt::format("a{}", j + 1), 'G', 0, {{j, 1}, {y(j), -1}});
    filled_[j] = given(fmt::format("b{}", j + 1), 'G', 0, {{j, -1}, {y(j), Rational(*fewer_)}});
    Terms strict = mass_above(j);
    strict.emplace_back(y(j), Rational(-most_excess_));
    given(fmt::format("s{}", j + 1), 'G', Rational(-most_excess_), strict);
  }

  /// t_j - f_j q_j - d
  Terms mass_above(std::size_t j) const {
    Terms terms = {{k_ + j, 1}, {d(), -1}};
    if (problem_.f(j) != 0)
      terms.emplace(terms.begin(), j, Rational(-problem_.f(j)));
    return terms;
  }

  /// Appends a derived constraint and returns its number.
  template <class... Args>
  std::size_t derive(fmt::format_string<Args...> format, Args &&...args) {
    fmt::format_to(std::back_inserter(derivation_), "d{} ", next_);
    fmt::format_to(std::back_inserter(derivation_), format, std::forward<Args>(args)...);
    fmt::format_to(std::back_inserter(derivation_), " -1\n");
    return next_++;
  }

  /// Derives d <= 0 in the subtree of the next node, and returns the number of that.
  std::size_t subtree() {
    const TreeNode &node = tree_[node_++];
    if (!node.is_split())
      return leaf(node.leaf);
    return node.i == node.j ? split(node.j, node.v) : split_sum(node.i, node.j, node.v);
  }

  /// What is in force for the count of classes i to j, i < j.
  struct Sum {
    std::optional<std::size_t> most, least, strict; ///< strict: the sum of t_b - f_b q_b - d is >= 0
  };

  std::size_t split_sum(std::size_t i, std::size_t j, const Integer &v) {
    Terms counts;
    for (std::size_t b = i; b <= j; ++b)
      counts.emplace_back(b, 1);
    const Sum before = sums_[{i, j}];
    const std::size_t few = derive("L {} {} {{ asm }}", to_string(Integer(v - 1)), to_text(counts));
    sums_[{i, j}].most = few;
    const std::size_t first = subtree();
    const std::size_t many = derive("G {} {} {{ asm }}", to_string(v), to_text(counts));
    sums_[{i, j}] = {before.most, many, before.strict};
    if (!before.strict && !has_strict_class(i, j))
      sums_[{i, j}].strict = strict_sum(i, j, many, v);
    const std::size_t second = subtree();
    sums_[{i, j}] = before;
    return derive("L 0 OBJ {{ uns {} {} {} {} }}", first, few, second, many);
  }

  /// Derives that the sum of t_b - f_b q_b - d over classes i to j is at least 0, as one of them is not
  /// empty: class by class, it is the one or it is not.
  /// \pre no class's own condition is strict
  std::size_t strict_sum(std::size_t i, std::size_t j, std::size_t many, const Integer &v) {
    std::vector<std::pair<std::size_t, std::size_t>>
        cases; // d as y_b >= 1 shows, under the assumption of that
    std::string none = fmt::format("{} 1", many);
    std::vector<std::size_t> empty;
    for (std::size_t b = i; b <= j; ++b) {
      const std::size_t full = derive("G 1 1 {} 1 {{ asm }}", y(b));
      cases.emplace_back(sum_above(i, j, b, full), full);
      empty.push_back(derive("L 0 1 {} 1 {{ asm }}", y(b)));
      none += fmt::format(" {} 1 {} {}", filled_[b], empty.back(), to_string(Integer(-*fewer_)));
    }
    std::size_t rest = derive("G {} 0 {{ lin {} {} }}", to_string(v), 1 + 2 * empty.size(), none);
    for (std::size_t b = j + 1; b-- > i;)
      rest = derive("G 0 {} {{ uns {} {} {} {} }}", to_text(masses_above(i, j)), rest, empty[b - i],
                    cases[b - i].first, cases[b - i].second);
    return rest;
  }

  /// The same where class `one` is not empty, y >= 1.
  std::size_t sum_above(std::size_t i, std::size_t j, std::size_t one, std::size_t full) {
    std::string terms = fmt::format("{} 1 {} {}", filled_[one] + 1, full, to_string(most_excess_));
    for (std::size_t b = i; b <= j; ++b)
      if (b != one)
        terms += fmt::format(" {} 1", row_.at({TolerantCondition::above_lower, b}));
    return derive("G 0 {} {{ lin {} {} }}", to_text(masses_above(i, j)), j - i + 2, terms);
  }

  Terms masses_above(std::size_t i, std::size_t j) const {
    Terms terms;
    for (std::size_t b = i; b <= j; ++b) {
      if (problem_.f(b) != 0)
        terms.emplace_back(b, Rational(-problem_.f(b)));
      terms.emplace_back(k_ + b, 1);
    }
    terms.emplace_back(d(), -1);
    std::sort(terms.begin(), terms.end());
    return terms;
  }

  std::size_t split(std::size_t j, const Integer &v) {
    const std::size_t most = most_[j], least = least_[j], strict = strict_[j];
    const Integer least_value = least_value_[j];
    const std::size_t few = most_[j] = derive("L {} 1 {} 1 {{ asm }}", to_string(Integer(v - 1)), j);
    const std::size_t first = subtree();
    most_[j] = most;
    const std::size_t many = least_[j] = derive("G {} 1 {} 1 {{ asm }}", to_string(v), j);
    least_value_[j] = v;
    if (least_value < 1)
      strict_[j] = strict_bound(j, many);
    const std::size_t second = subtree();
    least_[j] = least;
    least_value_[j] = least_value;
    strict_[j] = strict;
    return derive("L 0 OBJ {{ uns {} {} {} {} }}", first, few, second, many);
  }

  /// t_j - f_j q_j - d >= 0 where class j is not empty.
  std::size_t strict_bound(std::size_t j, std::size_t many) {
    const std::string part = to_string(ratio(1, *fewer_));
    const std::size_t full = derive("G 1 1 {} 1 {{ rnd 2 {} {} {} {} }}", y(j), many, part, filled_[j], part);
    return derive("G 0 {} {{ lin 2 {} 1 {} {} }}", to_text(mass_above(j)), filled_[j] + 1, full,
                  to_string(most_excess_));
  }

  static bool is_of_sum(TolerantCondition condition) {
    return condition == TolerantCondition::least_sum || condition == TolerantCondition::most_sum ||
           condition == TolerantCondition::above_lowers;
  }

  bool has_strict_class(std::size_t i, std::size_t j) const {
    return std::any_of(least_value_.begin() + static_cast<std::ptrdiff_t>(i),
                       least_value_.begin() + static_cast<std::ptrdiff_t>(j) + 1,
                       [](const Integer &least) { return least >= 1; });
  }

  /// The conditions of sums that are not in force themselves are those of their classes.
  std::vector<Multiple> by_classes(const std::vector<Multiple> &multiples) {
    LeafSum all;
    for (const Multiple &m : multiples) {
      const bool is_least = m.condition == TolerantCondition::least_sum && !sums_[{m.i, m.j}].least;
      const bool is_above = m.condition == TolerantCondition::above_lowers &&
                            (!sums_[{m.i, m.j}].strict || has_strict_class(m.i, m.j));
      if (!is_least && !is_above)
        all.add(m.condition, is_of_sum(m.condition) ? m.i : m.j, m.j, Rational(m.multiplier));
      for (std::size_t b = m.i; b <= m.j && (is_least || is_above); ++b)
        all.add(is_least ? TolerantCondition::least_count : TolerantCondition::above_lower, b,
                Rational(m.multiplier));
    }
    return all.node().leaf;
  }

  std::size_t leaf(const std::vector<Multiple> &of) {
    const std::vector<Multiple> multiples = by_classes(of);
    Integer slack = 0; // of d in the sum
    for (const Multiple &m : multiples)
      if (is_strict(m))
        slack += m.multiplier;
    if (slack == 0) // the sum is a contradiction without d
      slack = 1;
    std::string terms;
    for (const Multiple &m : multiples) {
      const bool is_upper = m.condition == TolerantCondition::most_count ||
                            m.condition == TolerantCondition::most_sum ||
                            m.condition == TolerantCondition::fewer;
      terms += fmt::format(" {} {}", constraint_of(m),
                           to_string(ratio(is_upper ? m.multiplier : Integer(-m.multiplier), slack)));
    }
    return derive("L 0 OBJ {{ lin {}{} }}", multiples.size(), terms);
  }

  bool is_strict(const Multiple &m) const {
    return m.condition == TolerantCondition::some_mass || m.condition == TolerantCondition::above_lowers ||
           (m.condition == TolerantCondition::above_lower && least_value_[m.j] >= 1);
  }

  std::size_t constraint_of(const Multiple &m) const {
    if (m.condition == TolerantCondition::least_count)
      return least_[m.j];
    if (m.condition == TolerantCondition::most_count)
      return most_[m.j];
    if (m.condition == TolerantCondition::least_sum)
      return *sums_.at({m.i, m.j}).least;
    if (m.condition == TolerantCondition::most_sum)
      return *sums_.at({m.i, m.j}).most;
    if (m.condition == TolerantCondition::above_lowers)
      return *sums_.at({m.i, m.j}).strict;
    return m.condition == TolerantCondition::above_lower && is_strict(m) ? strict_[m.j]
                                                                         : row_.at({m.condition, m.j});
  }

  const TolerantProblem problem_;
  const Tree &tree_;
  std::size_t k_, variables_;
  std::optional<Integer> fewer_; ///< N - 1
  Rational most_excess_ = 0;     ///< D: no sample of so few particles has a greater d
  std::map<std::pair<TolerantCondition, std::size_t>, std::size_t> row_; ///< constraints of conditions
  /// Constraints in force on the way to a node: bounds of q_j, and the strict lower bound of t_j.
  std::vector<std::size_t> least_;
  std::vector<Integer> least_value_;
  std::vector<std::size_t> most_, strict_;
  std::map<std::pair<std::size_t, std::size_t>, Sum> sums_;
  std::vector<std::size_t> filled_; ///< q_j <= (N - 1) y_j; the next one is the strict bound where y_j = 1
  std::size_t given_ = 0, bounds_ = 0, next_ = 0, node_ = 0;
  fmt::memory_buffer header_, constraints_, derivation_;
};

} // namespace

std::string tolerant_vipr(const Match &m) {
  assert(m.complete && m.tolerance);
  const Tree &tree = std::get<Tree>(m.evidence().value());
  if (std::any_of(tree.begin(), tree.end(), [](const TreeNode &node) { return node.mass || node.is_window; }))
    throw InputError(option("vipr") +
                     ": the proof is by windows of the total mass, which the format cannot state: use " +
                     option("proof") + " and mdm-check, or leave it out");
  return TreeVipr(m).text();
}

} // namespace mdm
