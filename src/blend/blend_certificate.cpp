// The certificate of a blend (certificate-format.md, section 11): the tree of the search, whose leaves have
// their multipliers from blend_leaves.cpp. A leaf is `none` where they do not need the aim. What the checker
// can see by itself, a box whose counts cannot sum to the whole, needs none.

#include "blend/blend_certificate.hpp"

#include "blend/blend_leaves.hpp"

#include <fmt/format.h>

#include <cassert>
#include <iterator>

namespace mdm {
namespace {

/// Writes the tree of a search, with multipliers at its leaves.
class BlendTreeWriter {
public:
  BlendTreeWriter(const BlendProblem &problem, const BlendAnswer &answer, fmt::memory_buffer &out)
      : problem_(problem), tree_(answer.tree), leaves_(problem, answer), out_(out) {}

  void write() {
    std::vector<BlendBox> open = {whole_box(problem_)};
    while (!open.empty()) {
      BlendBox box = std::move(open.back());
      open.pop_back();
      const BlendNode &node = tree_[box.number];
      if (node.first == 0) {
        write_leaf(std::move(box));
        continue;
      }
      fmt::format_to(std::back_inserter(out_), "split {} {}\n", node.stockpile + 1, node.at);
      auto [below, above] = leaves_.halves(box);
      open.push_back(std::move(above));
      open.push_back(std::move(below));
    }
  }

private:
  void write_leaf(BlendBox box) {
    const BlendLeaf leaf = restrict_box(problem_, box) ? leaves_.leaf(box) : BlendLeaf{};
    out_.append(std::string_view(leaf.is_of_aim ? "leaf" : "none"));
    for (const BlendMultiple &m : leaf.multiples)
      fmt::format_to(std::back_inserter(out_), " {} {}{}", to_string(m.multiplier), letter(m.limit),
                     m.limit.index + 1);
    out_.push_back('\n');
  }
  static char letter(const BlendLimit &limit) {
    return limit.kind == BlendLimit::Kind::passing ? (limit.is_upper ? 'u' : 'l')
                                                   : (limit.is_upper ? 'b' : 'a');
  }

  const BlendProblem &problem_;
  const std::vector<BlendNode> &tree_;
  BlendLeaves leaves_;
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
