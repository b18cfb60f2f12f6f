// The proof of a blend for VIPR checkers (Theorem 22, remark): `asm` lines for the two sides of a split, a
// `lin` line for each leaf, `uns` where both sides are done. A leaf's line takes its multipliers; what they
// leave of the shares, e_i n_i / M, it takes from the sum of all n_i with the e of the stockpile at which the
// sum is reached, and from the bounds of the box with what the other e differ from it.

#include "blend/blend_vipr.hpp"

#include "blend/blend_leaves.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <map>
#include <numeric>
#include <tuple>

namespace mdm {
namespace {

/// Writes the file section by section; derived constraints are numbered behind those of the problem.
class BlendVipr {
public:
  BlendVipr(const BlendProblem &problem, const BlendAnswer &answer)
      : problem_(problem), answer_(answer), leaves_(problem, answer), k_(problem.stockpiles.size()) {
    if (!aims_at_target(problem.aim))
      return;
    targets_ = static_cast<std::size_t>(std::count_if(problem.sieves.begin(), problem.sieves.end(),
                                                      [](const BlendSieve &s) { return s.is_sieve(); }));
    deviations_ = problem.aim == BlendAim::max_deviation ? 1 : targets_;
  }

  std::string text() {
    constraints();
    next_ = given_;
    derive_all();
    header();
    return fmt::to_string(header_) + fmt::to_string(constraints_) + claim() +
           fmt::format("DER {}\n", next_ - given_) + fmt::to_string(derivation_);
  }

private:
  using Terms = std::vector<std::pair<std::size_t, Rational>>; ///< numbers of variables or constraints

  /// A box, with the constraints that bound it.
  struct Bounds {
    BlendBox box;
    std::vector<std::size_t> least, most;
  };
  /// A node whose subtree is being derived.
  struct Open {
    Bounds bounds;
    enum class Stage { begun, below, above } stage = Stage::begun;
    std::size_t few = 0, below = 0, many = 0; ///< constraints: n_i <= v, what it leads to, n_i > v
  };

  Rational per_step(const Rational &x) const { return x / problem_.steps; }
  /// Of what passes a sieve, counted from 0; the largest is that of all.
  std::size_t deviation(std::size_t sieve) const { return deviations_ == 1 ? 0 : sieve; }

  static std::string to_text(const Terms &terms) {
    std::string text = fmt::format("{}", terms.size());
    for (const auto &[number, coefficient] : terms)
      text += fmt::format(" {} {}", number, to_string(coefficient));
    return text;
  }

  void header() {
    const auto end = std::back_inserter(header_);
    fmt::format_to(end, "% mdm: {}\nVER 1.0\nVAR {}\n",
                   answer_.best.empty() ? "there is no blend" : "the best blend, in steps of each stockpile",
                   k_ + deviations_);
    for (std::size_t i = 0; i < k_ + deviations_; ++i)
      fmt::format_to(end, "{}{}{}", i == 0 ? "" : " ", i < k_ ? 'n' : 'd', (i < k_ ? i : i - k_) + 1);
    fmt::format_to(end, "\nINT {}\n", k_);
    for (std::size_t i = 0; i < k_; ++i)
      fmt::format_to(end, "{}{}", i == 0 ? "" : " ", i);
    fmt::format_to(end, "\nOBJ min\n{}\nCON {} {}\n", to_text(objective()), given_, bounds_);
  }

  Terms objective() const {
    Terms terms;
    for (std::size_t i = 0; i < k_ && problem_.aim == BlendAim::cost; ++i)
      if (problem_.stockpiles[i].cost != 0)
        terms.emplace_back(i, per_step(problem_.stockpiles[i].cost));
    for (std::size_t d = 0; d < deviations_; ++d)
      terms.emplace_back(k_ + d, 1);
    return terms;
  }

  std::size_t given(const std::string &name, char sense, const Rational &constant, const Terms &terms) {
    fmt::format_to(std::back_inserter(constraints_), "{} {} {} {}\n", name, sense, to_string(constant),
                   to_text(terms));
    return given_++;
  }

  void constraints() {
    whole_.box = whole_box(problem_);
    for (std::size_t i = 0; i < k_; ++i) {
      whole_.least.push_back(given(fmt::format("g{}", i + 1), 'G', whole_.box.least[i], {{i, 1}}));
      whole_.most.push_back(given(fmt::format("m{}", i + 1), 'L', whole_.box.most[i], {{i, 1}}));
    }
    for (std::size_t d = 0; d < deviations_; ++d)
      no_deviation_.push_back(given(fmt::format("d{}", d + 1), 'G', 0, {{k_ + d, 1}}));
    bounds_ = given_;
    Terms all;
    for (std::size_t i = 0; i < k_; ++i)
      all.emplace_back(i, 1);
    at_least_whole_ = given("atleast", 'G', problem_.steps, all);
    at_most_whole_ = given("atmost", 'L', problem_.steps, all);
    for (const BlendLimit &limit : limits_of(problem_))
      if (limit.kind == BlendLimit::Kind::passing)
        row_[{'p', limit.index, limit.is_upper}] =
            given(fmt::format("{}{}", limit.is_upper ? 'u' : 'l', limit.index + 1),
                  limit.is_upper ? 'L' : 'G', value_of(limit, problem_), passing(limit.index, 1));
    for (std::size_t s = 0; s < targets_; ++s)
      for (const bool is_upper : {false, true}) {
        const int sign = is_upper ? -1 : 1;
        Terms terms = passing(s, sign);
        terms.emplace_back(k_ + deviation(s), 1);
        row_[{'t', s, is_upper}] = given(fmt::format("{}{}", is_upper ? 'b' : 'a', s + 1), 'G',
                                         Rational(sign * *problem_.sieves[s].target), terms);
      }
  }

  /// What passes a sieve, of either sign.
  Terms passing(std::size_t sieve, int sign) const {
    Terms terms;
    for (std::size_t i = 0; i < k_; ++i)
      if (const Rational &percent = problem_.stockpiles[i].passing[sieve]; percent != 0)
        terms.emplace_back(i, per_step(Rational(sign * percent)));
    return terms;
  }

  std::string claim() const {
    if (answer_.best.empty())
      return "RTP infeas\nSOL 0\n";
    const Blend &best = answer_.best.front();
    Terms values;
    for (std::size_t i = 0; i < k_; ++i)
      if (best.shares[i] != 0)
        values.emplace_back(i, Rational(best.shares[i] * problem_.steps));
    for (std::size_t d = 0; d < deviations_; ++d)
      values.emplace_back(k_ + d, problem_.aim == BlendAim::max_deviation
                                      ? best.value
                                      : abs(Rational(best.passing[d] - *problem_.sieves[d].target)));
    const std::string value = to_string(best.value);
    return fmt::format("RTP range {} {}\nSOL 1\nblend {}\n", value, value, to_text(values));
  }

  /// Appends a derived constraint and returns its number.
  std::size_t derive(const std::string &what) {
    fmt::format_to(std::back_inserter(derivation_), "c{} {} -1\n", next_, what);
    return next_++;
  }
  /// What each leaf is to lead to: a value that is no lower, or a contradiction.
  std::string goal() const {
    return answer_.best.empty() ? "G 1 0" : fmt::format("G {} OBJ", to_string(answer_.best.front().value));
  }
  std::size_t derive_sum(const Terms &multiples) {
    return derive(fmt::format("{} {{ lin {} }}", goal(), to_text(multiples)));
  }

  void derive_all() {
    if (problem_.aim == BlendAim::none && !answer_.best.empty()) { // no value is lower than 0
      derive_sum(Terms{});
      return;
    }
    std::vector<Open> open(1);
    open.back().bounds = whole_;
    for (std::size_t last = 0; !open.empty();) {
      Open &node = open.back();
      const BlendNode &split = answer_.tree[node.bounds.box.number];
      if (split.first == 0) {
        last = leaf(node.bounds);
        open.pop_back();
        continue;
      }
      const auto side = [&](char sense, std::uint64_t at) {
        return derive(fmt::format("{} {} 1 {} 1 {{ asm }}", sense, at, split.stockpile));
      };
      switch (node.stage) {
      case Open::Stage::begun:
        node.stage = Open::Stage::below;
        node.few = side('L', split.at);
        open.push_back({half(node.bounds, leaves_.halves(node.bounds.box).first, split.stockpile, node.few)});
        break;
      case Open::Stage::below:
        node.stage = Open::Stage::above;
        node.below = last;
        node.many = side('G', split.at + 1);
        open.push_back(
            {half(node.bounds, leaves_.halves(node.bounds.box).second, split.stockpile, node.many)});
        break;
      case Open::Stage::above:
        last = derive(fmt::format("{} {{ uns {} {} {} {} }}", goal(), node.below, node.few, last, node.many));
        open.pop_back();
      }
    }
  }

  /// The bounds of half of a box, where `constraint` bounds stockpile i.
  static Bounds half(const Bounds &of, BlendBox box, std::size_t i, std::size_t constraint) {
    Bounds half{std::move(box), of.least, of.most};
    if (half.box.least[i] != of.box.least[i])
      half.least[i] = constraint;
    if (half.box.most[i] != of.box.most[i])
      half.most[i] = constraint;
    return half;
  }

  std::size_t leaf(const Bounds &b) {
    if (const std::optional<Terms> none = emptiness(b))
      return derive_sum(*none);
    const BlendLeaf leaf = leaves_.leaf(b.box);
    std::vector<Rational> e(k_), of_deviation(deviations_, leaf.is_of_aim ? 1 : 0);
    for (std::size_t i = 0; i < k_ && leaf.is_of_aim && problem_.aim == BlendAim::cost; ++i)
      e[i] = problem_.stockpiles[i].cost;
    Terms sum;
    for (const BlendMultiple &m : leaf.multiples) {
      const bool is_target = m.limit.kind == BlendLimit::Kind::target;
      const Rational rises = m.limit.is_upper ? Rational(-m.multiplier) : m.multiplier;
      sum.emplace_back(row_.at({is_target ? 't' : 'p', m.limit.index, m.limit.is_upper}),
                       is_target ? m.multiplier : rises);
      for (std::size_t i = 0; i < k_; ++i)
        e[i] -= rises * problem_.stockpiles[i].passing[m.limit.index];
      if (is_target)
        of_deviation[deviation(m.limit.index)] -= m.multiplier;
    }
    for (std::size_t d = 0; d < deviations_; ++d)
      add(sum, no_deviation_[d], of_deviation[d]);
    add_shares(sum, e, b);
    return derive_sum(sum);
  }

  static void add(Terms &sum, std::size_t constraint, const Rational &multiplier) {
    if (multiplier != 0)
      sum.emplace_back(constraint, multiplier);
  }

  /// The multipliers that show that a box is empty whatever passes; nothing if it is not.
  std::optional<Terms> emptiness(const Bounds &b) const {
    Integer fewest = 0, most = 0;
    for (std::size_t i = 0; i < k_; ++i) {
      if (b.box.least[i] > b.box.most[i])
        return Terms{{b.least[i], 1}, {b.most[i], -1}};
      fewest += b.box.least[i];
      most += b.box.most[i];
    }
    if (fewest <= problem_.steps && most >= problem_.steps)
      return std::nullopt;
    const bool is_over = fewest > problem_.steps;
    Terms all = {{is_over ? at_most_whole_ : at_least_whole_, is_over ? -1 : 1}};
    for (std::size_t i = 0; i < k_; ++i)
      all.emplace_back(is_over ? b.least[i] : b.most[i], is_over ? 1 : -1);
    return all;
  }

  /// The least of the sum of e_i n_i / M in the box.
  /// \pre it is not empty
  void add_shares(Terms &sum, const std::vector<Rational> &e, const Bounds &b) const {
    std::vector<std::size_t> order(k_);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&e](std::size_t i, std::size_t j) { return e[i] < e[j]; });
    std::uint64_t left = problem_.steps;
    for (const std::uint64_t least : b.box.least)
      left -= least;
    std::size_t at = 0;
    for (; left > b.box.most[order[at]] - b.box.least[order[at]]; ++at)
      left -= b.box.most[order[at]] - b.box.least[order[at]];
    const Rational reached = e[order[at]];
    add(sum, reached > 0 ? at_least_whole_ : at_most_whole_, per_step(reached));
    for (std::size_t i = 0; i < k_; ++i)
      add(sum, e[i] > reached ? b.least[i] : b.most[i], per_step(Rational(e[i] - reached)));
  }

  const BlendProblem &problem_;
  const BlendAnswer &answer_;
  BlendLeaves leaves_;
  std::size_t k_, targets_ = 0, deviations_ = 0; ///< the sieves with targets come before what has none
  Bounds whole_;
  std::vector<std::size_t> no_deviation_;
  std::size_t at_least_whole_ = 0, at_most_whole_ = 0;
  std::map<std::tuple<char, std::size_t, bool>, std::size_t> row_; ///< of passing and of targets
  std::size_t given_ = 0, bounds_ = 0, next_ = 0;
  fmt::memory_buffer header_, constraints_, derivation_;
};

} // namespace

std::string blend_vipr(const BlendProblem &problem, const BlendAnswer &answer) {
  assert(problem.aim != BlendAim::widening);
  if (problem.aim == BlendAim::squares)
    throw InputError(option("vipr") + ": its conditions are linear, and squares are not: write " +
                     option("proof") + ", or minimise deviation or max-deviation");
  if (problem.at_most)
    throw InputError(option("vipr") + ": its conditions are linear, and " + option("at-most-stockpiles") +
                     " is none: write " + option("proof"));
  return BlendVipr(problem, answer).text();
}

} // namespace mdm
