// The certificate of a blend (certificate-format.md, section 11). The search leaves its splits; here each
// leaf of the tree gets its multipliers. The box of a leaf is set in the relaxation with less demanded of
// the aim than the claim, which it cannot have, and the contradiction's multiples are written: `none` where
// they do not need the aim, else `leaf`. Of squares it is the relaxation of a tangent: the one that touches
// at the least value of the box, with slopes as short as will do. What the checker can see by itself, a box
// whose counts cannot sum to the whole, needs none.

#include "blend/blend_certificate.hpp"

#include "blend/relaxation.hpp"
#include "blend/tangent.hpp"

#include <mdm/number/integer.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>

namespace mdm {
namespace {

/// Writes the tree of a search, with multipliers at its leaves (Theorem 22).
class BlendTreeWriter {
public:
  BlendTreeWriter(const BlendProblem &problem, const BlendAnswer &answer, fmt::memory_buffer &out)
      : problem_(problem), tree_(answer.tree), relaxation_(problem), out_(out) {
    if (answer.best.empty())
      return;
    value_ = answer.best.front().value;
    if (problem.aim != BlendAim::squares)
      relaxation_.demand_less(*value_);
  }

  void write() {
    std::vector<Box> open = {whole()};
    while (!open.empty()) {
      Box box = std::move(open.back());
      open.pop_back();
      const BlendNode &node = tree_[box.number];
      if (node.first == 0) {
        write_leaf(std::move(box));
        continue;
      }
      fmt::format_to(std::back_inserter(out_), "split {} {}\n", node.stockpile + 1, node.at);
      Box below = box;
      below.most[node.stockpile] = std::min(below.most[node.stockpile], node.at);
      below.number = node.first;
      box.least[node.stockpile] = std::max(box.least[node.stockpile], node.at + 1);
      box.number = node.first + 1;
      open.push_back(std::move(box));
      open.push_back(std::move(below));
    }
  }

private:
  struct Box {
    std::vector<std::uint64_t> least, most;
    std::size_t number;
  };

  Box whole() const {
    Box box{{}, {}, 0};
    for (const Stockpile &s : problem_.stockpiles) {
      box.least.push_back(ceil(s.least * problem_.steps).convert_to<std::uint64_t>());
      box.most.push_back(floor(s.most * problem_.steps).convert_to<std::uint64_t>());
    }
    return box;
  }

  /// Takes out of a box what has too many stockpiles. False if nothing is left of it.
  bool restrict(Box &box) const {
    const auto used = static_cast<std::size_t>(
        std::count_if(box.least.begin(), box.least.end(), [](std::uint64_t n) { return n > 0; }));
    for (std::size_t i = 0; i < box.least.size(); ++i) {
      if (problem_.at_most && used == *problem_.at_most && box.least[i] == 0)
        box.most[i] = 0;
      if (box.least[i] > box.most[i])
        return false;
    }
    return !problem_.at_most || used <= *problem_.at_most;
  }

  void write_leaf(Box box) {
    if (!restrict(box)) {
      out_.append(std::string_view("none\n"));
      return;
    }
    bound_shares(relaxation_, box);
    if (problem_.aim == BlendAim::squares && relaxation_.least_value()) {
      write_squares(box);
      return;
    }
    write_conflict(relaxation_);
    out_.push_back('\n');
  }

  void bound_shares(BlendRelaxation &relaxation, const Box &box) const {
    for (std::size_t i = 0; i < box.least.size(); ++i)
      relaxation.bound_share(i, ratio(box.least[i], problem_.steps), ratio(box.most[i], problem_.steps));
  }

  void write_conflict(BlendRelaxation &relaxation) {
    [[maybe_unused]] const bool possible = relaxation.is_feasible();
    assert(!possible);
    out_.append(std::string_view(relaxation.needs_aim() ? "leaf" : "none"));
    for (const BlendMultiple &m : relaxation.multiples()) {
      using Kind = BlendLimit::Kind;
      if (m.limit.kind == Kind::passing || m.limit.kind == Kind::target)
        write_multiplier(m.multiplier, m.limit);
    }
  }

  /// \pre the relaxation has found the least value of the box
  void write_squares(const Box &box) {
    const std::vector<Rational> slopes =
        slopes_at(problem_, blend_of(problem_, relaxation_.some_shares()).passing);
    for (const unsigned places : {1U, 3U})
      if (write_tangent(box, rounded(slopes, places)))
        return;
    [[maybe_unused]] const bool is_written = write_tangent(box, slopes);
    assert(is_written);
  }

  /// False if the tangent may be below the claim in the box.
  bool write_tangent(const Box &box, const std::vector<Rational> &slopes) {
    const Tangent tangent = tangent_with(problem_, slopes);
    BlendRelaxation relaxation(tangent.problem);
    bound_shares(relaxation, box);
    if (*relaxation.least_value() < *value_ + tangent.raised)
      return false;
    relaxation.demand_less(*value_ + tangent.raised);
    write_conflict(relaxation);
    for (std::size_t s = 0; s < slopes.size(); ++s)
      if (slopes[s] != 0)
        write_multiplier(abs(slopes[s]), {BlendLimit::Kind::target, s, slopes[s] > 0});
    out_.push_back('\n');
    return true;
  }

  static std::vector<Rational> rounded(std::vector<Rational> numbers, unsigned places) {
    const Integer unit = power_of_ten(places);
    for (Rational &n : numbers)
      n = ratio(floor(Rational(n * unit + ratio(1, 2))), unit);
    return numbers;
  }

  void write_multiplier(const Rational &multiplier, const BlendLimit &limit) {
    fmt::format_to(std::back_inserter(out_), " {} {}{}", to_string(multiplier), letter(limit),
                   limit.index + 1);
  }
  static char letter(const BlendLimit &limit) {
    return limit.kind == BlendLimit::Kind::passing ? (limit.is_upper ? 'u' : 'l')
                                                   : (limit.is_upper ? 'b' : 'a');
  }

  const BlendProblem &problem_;
  const std::vector<BlendNode> &tree_;
  std::optional<Rational> value_; ///< of the claim; nothing where there is no blend
  BlendRelaxation relaxation_;
  fmt::memory_buffer &out_;
};

void write_blend_question(const BlendProblem &p, fmt::memory_buffer &out) {
  const auto end = std::back_inserter(out);
  fmt::format_to(end, "mdm-certificate blend 1\nsteps {}\n", p.steps);
  for (std::size_t i = 0; i < p.stockpiles.size(); ++i)
    if (const Stockpile &s = p.stockpiles[i]; s.least > 0 || s.most < 1)
      fmt::format_to(end, "share {} {} {}\n", i + 1, to_string(s.least), to_string(s.most));
  if (p.at_most)
    fmt::format_to(end, "at-most {}\n", *p.at_most);
  for (const BlendSieve &s : p.sieves)
    if (s.modulus)
      fmt::format_to(end, "modulus {} {} {}\n", *s.modulus == FinenessModulus::astm ? "astm" : "en",
                     to_string(modulus_of_mean(*s.modulus, s.most)),
                     to_string(modulus_of_mean(*s.modulus, s.least)));
  if (p.coarseness)
    fmt::format_to(end, "coarseness {} {}\n", to_string(p.coarseness->least), to_string(p.coarseness->most));
  fmt::format_to(end, "minimise {}", name(p.aim));
  if (p.aim == BlendAim::cost)
    for (const Stockpile &s : p.stockpiles)
      fmt::format_to(end, " {}", to_string(s.cost));
  else if (p.aim != BlendAim::none)
    for (const BlendSieve &s : p.sieves)
      if (s.is_sieve())
        fmt::format_to(end, " {}", to_string(*s.target));
  out.push_back('\n');
}

} // namespace

std::string blend_certificate(const BlendProblem &problem, const BlendAnswer &answer) {
  assert(problem.aim != BlendAim::widening);
  fmt::memory_buffer out;
  write_blend_question(problem, out);
  out.append(std::string_view("blend"));
  if (answer.best.empty())
    out.append(std::string_view(" none"));
  else
    for (const Rational &share : answer.best.front().shares)
      fmt::format_to(std::back_inserter(out), " {}", to_string(Rational(share * problem.steps)));
  out.push_back('\n');
  if (answer.best.empty() || problem.aim != BlendAim::none)
    BlendTreeWriter(problem, answer, out).write();
  out.append(std::string_view("end\n"));
  return fmt::to_string(out);
}

} // namespace mdm
