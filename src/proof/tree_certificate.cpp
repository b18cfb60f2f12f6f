// The certificate of a match within a tolerance as text (certificate-format.md, section 6). What comes in
// is a match with its tree; what goes out are the tolerance's lines, the witness with exact masses, and the
// tree in preorder.
//
// The problem's masses are in a unit in which all f and F are integers, the format's are those of the
// gradation: multiples of conditions on masses are those of the problem times the unit, and each leaf is
// divided by what its multiples have in common. The version is the least that has all that is written: 2
// for sums of classes, 3 for windows. What the checker's work depends on is summed up on the way. Where a
// certificate is beyond the format's limits, less is proved: fewer windows show a smaller bound, and that a
// match has as many particles as were asked for is shown by nothing.

#include "match/problem_of.hpp"
#include "match/sizes.hpp"
#include "match/tolerant_chain_proof.hpp"
#include "match/window_evidence.hpp"
#include "number/common_denominator.hpp"
#include "proof/certificate_parts.hpp"
#include "proof/question_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace mdm {
namespace {

using Text = std::back_insert_iterator<std::string>;

/// The match's size of class j, precise enough for the format.
Enclosure certified_size(const Match &m, std::size_t j, const Rational &mass) {
  const Enclosure &size = *m.sample->sizes[j];
  if (is_precise(m, size))
    return size;
  const MassLaw &law = m.question.law;
  const Rational power_b =
      power(Rational(mass / (Rational(m.sample->quantities[j]) * m.gradation.factor(j))), law.b);
  return enclose_size(m.gradation, j, law, law.a, numerator(power_b), denominator(power_b), least_digits);
}

/// The letter of a condition.
char letter(TolerantCondition condition) {
  switch (condition) {
  case TolerantCondition::above_lower:
    return 'f';
  case TolerantCondition::up_to_upper:
    return 'F';
  case TolerantCondition::least_count:
    return 'q';
  case TolerantCondition::most_count:
    return 'Q';
  case TolerantCondition::retained_lo:
    return 'r';
  case TolerantCondition::retained_hi:
    return 'R';
  case TolerantCondition::passing_lo:
    return 'p';
  case TolerantCondition::passing_hi:
    return 'P';
  case TolerantCondition::excess:
    return 'e';
  case TolerantCondition::excess_sign:
    return 'x';
  case TolerantCondition::excess_total:
    return 'E';
  case TolerantCondition::some_mass:
    return 'm';
  case TolerantCondition::weight:
    return 'w';
  case TolerantCondition::at_least:
    return 'n';
  case TolerantCondition::least_sum:
    return 's';
  case TolerantCondition::most_sum:
    return 'S';
  case TolerantCondition::above_lowers:
    return 'd';
  case TolerantCondition::whole_lo:
    return 't';
  case TolerantCondition::whole_hi:
    return 'T';
  default:
    return 'N';
  }
}

/// True if the condition is about counts alone, so that the unit of masses is nothing to it.
bool is_of_counts(char letter) {
  return std::string_view("qQnNsS").find(letter) != std::string_view::npos;
}

/// `3` or `2-3`, as the format counts.
std::string classes_text(std::size_t i, std::size_t j) {
  return i == j ? std::to_string(j + 1) : fmt::format("{}-{}", i + 1, j + 1);
}

/// The condition with its classes, if it has some.
std::string name_of(const Multiple &multiple) {
  const char name = letter(multiple.condition);
  if (std::string_view("EmwnNtT").find(name) != std::string_view::npos)
    return {name};
  const bool of_sum = std::string_view("sSd").find(name) != std::string_view::npos;
  return name + classes_text(of_sum ? multiple.i : multiple.j, multiple.j);
}

/// True if the tree needs version 2 of the format.
bool has_sums(const Tree &tree) {
  return std::any_of(tree.begin(), tree.end(),
                     [](const TreeNode &node) { return node.is_split() && node.i < node.j; });
}

/// True if the tree needs version 3 of the format.
bool has_windows(const Tree &tree) {
  return std::any_of(tree.begin(), tree.end(),
                     [](const TreeNode &node) { return node.mass || node.is_window; });
}

/// Writes witness and tree, and sums up what the checker's work depends on.
class TreeWriter {
public:
  TreeWriter(const Match &m, const TolerantProblem &problem)
      : m_(m), problem_(problem), unit_(numerator(problem_.unit())) {}

  /// \param bound  that the tree proves; nothing: all that the match says
  /// \return nothing if it is beyond the format's limits
  std::optional<std::string> text(const Tree &tree, const std::optional<Integer> &bound) {
    const std::string claim = claimed(bound);
    std::string text = fmt::format("mdm-certificate {}\n", version(tree, claim));
    text += question_lines(m_);
    write_tolerance(text);
    text += "particles " + claim + "\n";
    if (m_.sample)
      write_witness(text);
    for (const TreeNode &node : tree)
      write(node, text);
    return within_limits() ? std::optional<std::string>(text + "end\n") : std::nullopt;
  }

private:
  /// The first version of the format that has all that is written.
  static int version(const Tree &tree, const std::string &claim) {
    return has_windows(tree) ? 3 : has_sums(tree) || claim.find("..") != std::string::npos ? 2 : 1;
  }

  /// `N`, `none`, or what is certain of a search that a limit ended: `B..N`, `B..`.
  std::string claimed(const std::optional<Integer> &bound) const {
    const std::optional<Integer> n = m_.particles();
    if (bound && bound != n)
      return to_string(*bound) + ".." + (n ? to_string(*n) : "");
    return n ? to_string(*n) : "none";
  }

  void write_tolerance(std::string &text) {
    const ToleranceLines lines = tolerance_lines(m_.question, m_.gradation);
    text += lines.text;
    count_ = std::max(count_, lines.longest);
    bands_ = lines.bands;
  }

  void write_witness(std::string &text) {
    const std::vector<Integer> &q = m_.sample->quantities;
    const std::vector<Rational> all = class_masses(m_);
    std::vector<Rational> masses;
    for (std::size_t j = 0; j < q.size(); ++j) {
      if (q[j] == 0)
        continue;
      masses.push_back(all[j]);
      const Enclosure size = certified_size(m_, j, masses.back());
      fmt::format_to(Text(text), "class {} {} {} {} {}\n", j + 1, to_string(q[j]), to_string(masses.back()),
                     size.lower_text(), size.upper_text());
      see(q[j]);
      see(size.hi);
      see(power_of_ten(size.places));
    }
    count_ = std::max(count_, longest_part(masses));
    witness_unit_ = bit_length(CommonDenominator(masses).denominator);
  }

  /// In the problem's units a mass is a multiple of what it is in the format's: so is a condition on masses.
  void write(const TreeNode &node, std::string &text) {
    ++size_;
    if (node.mass)
      return write_mass_split(*node.mass, text);
    if (node.is_window)
      return write_window(node.leaf, text);
    if (node.is_split()) {
      fmt::format_to(Text(text), "split {} {}\n", classes_text(node.i, node.j), to_string(node.v));
      see(node.v);
      return;
    }
    std::vector<Integer> multipliers;
    Integer common = 0;
    for (const Multiple &multiple : node.leaf) {
      const bool of_counts = is_of_counts(letter(multiple.condition));
      multipliers.push_back(of_counts ? multiple.multiplier : Integer(multiple.multiplier * unit_));
      common = gcd(common, multipliers.back());
    }
    text += "leaf";
    for (std::size_t i = 0; i < node.leaf.size(); ++i) {
      fmt::format_to(Text(text), " {} {}", to_string(Integer(multipliers[i] / common)),
                     name_of(node.leaf[i]));
      if (node.leaf[i].condition == TolerantCondition::above_lowers)
        size_ += node.leaf[i].j - node.leaf[i].i;
      see(Integer(multipliers[i] / common));
    }
    text += "\n";
    size_ += node.leaf.size();
  }

  void write_mass_split(const Rational &mass, std::string &text) {
    const Rational v = mass / problem_.unit();
    fmt::format_to(Text(text), "split M {}\n", to_string(v));
    count_ = std::max(count_, longest_part(v));
  }

  /// Its conditions are on shares and counts, which have no unit. Its work is that of a pass over the
  /// classes.
  void write_window(const std::vector<Multiple> &leaf, std::string &text) {
    text += "window";
    for (const Multiple &multiple : leaf) {
      fmt::format_to(Text(text), " {} {}", to_string(multiple.multiplier), name_of(multiple));
      see(multiple.multiplier);
    }
    text += "\n";
    size_ += leaf.size();
    window_work_ += 64 * problem_.classes();
  }

  void see(const Integer &n) { count_ = std::max<std::size_t>(count_, bit_length(n)); }

  /// Bits of the unit in which all bounds on shares are integers, and the weights where there are any.
  std::size_t share_bits() const {
    std::vector<Rational> shares_of_all = shares(m_.gradation);
    const Tolerance &tolerance = *m_.tolerance;
    for (const std::vector<ShareBounds> *bounds : {&tolerance.retained, &tolerance.passing})
      for (const ShareBounds &b : *bounds) {
        shares_of_all.push_back(b.lo);
        shares_of_all.push_back(b.hi);
      }
    shares_of_all.emplace_back(tolerance.total.value_or(Rational(2)) / 2);
    if (m_.question.solids)
      for (std::size_t j = 0; j < m_.gradation.classes(); ++j)
        shares_of_all.emplace_back(1 / m_.gradation.factor(j));
    return bit_length(CommonDenominator(shares_of_all).denominator);
  }

  /// The format's limits on the work of a checker, estimated from above.
  bool within_limits() const {
    const Gradation &g = m_.gradation;
    const std::uint64_t e = highest_power(m_);
    const std::uint64_t in_gradation = std::max({longest_opening(g), longest_part(g.masses()),
                                                 longest_part(g.factors()), longest_part(g.tolerances())});
    std::uint64_t masses = bit_length(unit_);
    for (std::size_t j = 0; j < g.classes(); ++j)
      masses = std::max<std::uint64_t>(masses, bit_length(problem_.F(j)));
    const std::uint64_t count =
        std::max({count_, bit_length(m_.question.at_least), bit_length(m_.question.min_per_class),
                  longest_part(m_.question.law)});
    const std::uint64_t of_shares = share_bits(), of_weight = m_.question.solids ? 2 * masses + count : 1;
    const std::uint64_t all =
        std::max({e * (in_gradation + count), of_shares + of_weight, std::uint64_t{witness_unit_}});
    return e * in_gradation <= max_power_bits && e * count <= max_power_bits && of_shares <= max_power_bits &&
           witness_unit_ <= max_power_bits && size_ <= longest_tree &&
           (64 * (g.powers().size() + bands_) + size_ + window_work_) * all <= max_work;
  }

  const Match &m_;
  const TolerantProblem &problem_;
  Integer unit_; ///< a mass of 1 in the problem's units
  std::size_t count_ = 1, witness_unit_ = 1, size_ = 0, window_work_ = 0, bands_ = 0;
};

} // namespace

Certified tree_certificate(const Match &m) {
  const TolerantProblem problem = tolerant_problem_of(m);
  const auto proof = [&](const Tree &tree, const std::optional<Integer> &bound) {
    return TreeWriter(m, problem).text(tree, bound);
  };
  Tree tree = m.evidence() ? std::get<Tree>(*m.evidence()) : Tree();
  if (!tree.empty())
    if (std::optional<std::string> text = proof(tree, m.proof.bound))
      return {std::move(*text), m.proof.bound};
  if (has_windows(tree) && m.particles()) {
    const MassWindows windows(problem);
    const Integer most = *m.particles();
    constexpr std::size_t most_shortened = 1000; // nodes, in a moment
    constexpr unsigned finest = 1 << 20;         // part of the particles that is given up first
    const auto next = [&](const Integer &less) {
      return std::max(Integer(2 * less + 1), Integer(most / finest));
    };
    for (Integer less = most - m.proof.bound.value_or(most); less < most - problem.at_least();
         less = next(less)) {
      const Integer bound = most - less;
      tree = for_fewer(windows, tree, least_counts(problem), bound);
      if (tree.size() <= most_shortened)
        tree = shortened(windows, tree, least_counts(problem), bound, {});
      if (std::optional<std::string> text = proof(tree, bound))
        return {std::move(*text), bound < most ? std::optional<Integer>(bound) : std::nullopt};
    }
  }
  const Integer &asked = problem.at_least();
  if (std::optional<std::string> text = proof(tree_of_question(), asked))
    return {std::move(*text), asked};
  refuse_long_numbers();
}

} // namespace mdm
