#include "certificate_parts.hpp"

#include <mdm/error.hpp>
#include <mdm/number/common_denominator.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/proof/certificate.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace mdm {

std::size_t longest_part(const Rational &r) {
  return std::max(bit_length(numerator(r)), bit_length(denominator(r)));
}

std::size_t longest_part(const std::vector<Rational> &numbers) {
  std::size_t bits = 1;
  for (const Rational &r : numbers)
    bits = std::max(bits, longest_part(r));
  return bits;
}

bool is_precise(const Match &m, const Enclosure &size) {
  return (size.hi - size.lo) * power_of_ten(least_digits - 1) <= size.lo &&
         bit_length(size.hi) * std::max(m.question.law.a, m.question.law.b) <= max_power_bits;
}

namespace {

/// The format's limits on the work of a checker (certificate-format.md, section 2, Limits); they are
/// estimated from above.
bool within_limits(const Match &m, const std::vector<Enclosure> &sizes) {
  const Gradation &g = m.gradation;
  const std::uint64_t e = std::max(m.question.law.a, m.question.law.b);
  const std::uint64_t in_gradation =
      std::max({longest_part(g.sizes()), longest_part(g.masses()), longest_part(g.factors())});
  std::size_t count = std::max(bit_length(m.question.at_least), bit_length(m.particles()));
  for (const Enclosure &x : sizes)
    count = std::max({count, bit_length(x.hi), bit_length(power_of_ten(x.places))});
  std::size_t scale = longest_part(Rational(m.scale / m.problem.scale_unit()));
  scale = std::max(scale, longest_part(Rational(m.above / m.problem.scale_unit())));
  if (m.window.start)
    scale = std::max(scale, longest_part(Rational(m.window.start->lo / m.problem.scale_unit())));
  Integer factors = 1;
  if (m.question.solids)
    for (const Integer &c : CommonDenominator(g.factors()).numerators)
      factors = bit_length(factors) > max_power_bits ? factors : lcm(factors, c);
  return e * in_gradation <= max_power_bits && e * count <= max_power_bits &&
         (64 * g.sizes().size() + m.chain.size()) * e * (in_gradation + count) <= max_work &&
         g.classes() * scale <= std::uint64_t{1} << 32 && bit_length(factors) <= max_power_bits;
}

std::string solids_line(const Solids &solids) {
  if (const Cylinder *c = std::get_if<Cylinder>(&solids))
    return fmt::format("cylinder {} {} {}\n", to_decimal(c->diameter), to_decimal(c->height),
                       to_decimal(c->void_ratio));
  if (const Box *b = std::get_if<Box>(&solids))
    return fmt::format("box {} {} {} {}\n", to_decimal(b->a), to_decimal(b->b), to_decimal(b->c),
                       to_decimal(b->void_ratio));
  return fmt::format("solids-volume {}\n", to_decimal(std::get<SolidsVolume>(solids).volume));
}

} // namespace

std::string question_lines(const Match &m) {
  const Question &q = m.question;
  std::string text = fmt::format("law {}\n", q.law.exponent());
  if (q.pan_size)
    text += fmt::format("pan-size {}\n", to_decimal(*q.pan_size));
  if (q.cut_below)
    text += fmt::format("cut-below {}\n", to_decimal(*q.cut_below));
  if (q.size_factor != 1)
    text += fmt::format("size-factor {}\n", to_decimal(q.size_factor));
  if (q.min_per_class > (q.is_tolerant() ? 0 : 1))
    text += fmt::format("min-per-class {}\n", to_string(q.min_per_class));
  if (q.solids)
    text += solids_line(*q.solids);
  if (m.pi)
    text += fmt::format("pi {} {}\n", m.pi->lower_text(), m.pi->upper_text());
  if (q.at_least > 1)
    text += fmt::format("at-least {}\n", to_string(q.at_least));
  return text;
}

namespace {

/// The match's sizes if they are precise and short enough for the format, else such ones.
std::vector<Enclosure> certified_sizes(const Match &m) {
  const bool usable =
      std::all_of(m.sizes.begin(), m.sizes.end(), [&m](const Enclosure &x) { return is_precise(m, x); });
  return usable ? m.sizes : enclose_sizes(m.gradation, m.problem, m.q, m.scale, m.margin, least_digits);
}

std::string witness_lines(const Match &m, const std::vector<Enclosure> &sizes) {
  std::string text = fmt::format("particles {}\nscale {}\n", to_string(m.particles()), to_string(m.scale));
  for (std::size_t j = 0; j < m.q.size(); ++j)
    fmt::format_to(std::back_inserter(text), "class {} {} {} {}\n", m.problem.classes()[j].index + 1,
                   to_string(m.q[j]), sizes[j].lower_text(), sizes[j].upper_text());
  return text;
}

std::string chain_lines(const Match &m) {
  // With exactly as many particles as were asked for, the witness proves all.
  if (m.question.at_least > 1 && m.particles() == m.question.at_least)
    return {};
  std::string text = m.above > 0 ? fmt::format("above {}\nchain", to_string(m.above)) : "chain";
  for (const std::uint32_t j : m.chain)
    fmt::format_to(std::back_inserter(text), " {}", m.problem.classes()[j].index + 1);
  return text + "\n";
}

} // namespace

void refuse_long_numbers() {
  throw InputError("the numbers are too long for a certificate that can be checked in reasonable time: round "
                   "them, or leave out --proof");
}

std::string certificate(const Match &m) {
  if (m.tolerant)
    return tree_certificate(m);
  const std::vector<Enclosure> sizes = certified_sizes(m);
  if (!within_limits(m, sizes))
    refuse_long_numbers();
  return "mdm-certificate 1\n" + question_lines(m) + witness_lines(m, sizes) + chain_lines(m) + "end\n";
}

} // namespace mdm
