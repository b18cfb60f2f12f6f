// The certificate of a blend (certificate-format.md, section 11). The search leaves its splits; here each
// leaf of the tree gets its multipliers. The box of a leaf is set in the relaxation with less demanded of
// the aim than the claim, which it cannot have, and the contradiction's multiples are written: `none` where
// they do not need the aim, else `leaf`. What the checker can see by itself, a box whose counts cannot sum
// to the whole, needs none.

#include "blend/blend_certificate.hpp"

#include "blend/relaxation.hpp"

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
    if (!answer.best.empty())
      relaxation_.demand_less(answer.best.front().value);
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
    for (std::size_t i = 0; i < box.least.size(); ++i)
      relaxation_.bound_share(i, ratio(box.least[i], problem_.steps), ratio(box.most[i], problem_.steps));
    [[maybe_unused]] const bool possible = relaxation_.is_feasible();
    assert(!possible);
    out_.append(std::string_view(relaxation_.needs_aim() ? "leaf" : "none"));
    for (const BlendMultiple &m : relaxation_.multiples()) {
      using Kind = BlendLimit::Kind;
      if (m.limit.kind == Kind::passing || m.limit.kind == Kind::target)
        fmt::format_to(std::back_inserter(out_), " {} {}{}", to_string(m.multiplier), letter(m.limit),
                       m.limit.index + 1);
    }
    out_.push_back('\n');
  }
  static char letter(const BlendLimit &limit) {
    return limit.kind == BlendLimit::Kind::passing ? (limit.is_upper ? 'u' : 'l')
                                                   : (limit.is_upper ? 'b' : 'a');
  }

  const BlendProblem &problem_;
  const std::vector<BlendNode> &tree_;
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
  fmt::format_to(end, "minimise {}", name(p.aim));
  if (p.aim == BlendAim::cost)
    for (const Stockpile &s : p.stockpiles)
      fmt::format_to(end, " {}", to_string(s.cost));
  else if (p.aim != BlendAim::none)
    for (const BlendSieve &s : p.sieves)
      if (!s.modulus)
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
