#include <mdm/error.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/proof/certificate.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace mdm {
namespace {

/// The format asks for ten significant digits.
constexpr unsigned least_digits = 10;
/// Limit of the format on the bits of powers of quantities and sizes.
constexpr std::size_t max_power_bits = std::size_t{1} << 20;

/// True if the format allows the power of n.
bool fits(const Match &m, const Integer &n) {
  return bit_length(n) * std::max(m.question.law.a, m.question.law.b) <= max_power_bits;
}

void check_powers(const Match &m) {
  const auto fit = [&m](const Integer &n) { return fits(m, n); };
  if (!fit(m.question.at_least) || !fit(m.particles()) || !std::all_of(m.q.begin(), m.q.end(), fit))
    throw InputError("the exponent " + m.question.law.exponent() +
                     " is too large for a certificate of quantities this long");
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

std::string question_lines(const Match &m) {
  const Question &q = m.question;
  std::string text = fmt::format("law {}\n", q.law.exponent());
  if (q.pan_size)
    text += fmt::format("pan-size {}\n", to_decimal(*q.pan_size));
  if (q.cut_below)
    text += fmt::format("cut-below {}\n", to_decimal(*q.cut_below));
  if (q.size_factor != 1)
    text += fmt::format("size-factor {}\n", to_decimal(q.size_factor));
  if (q.min_per_class > 1)
    text += fmt::format("min-per-class {}\n", to_string(q.min_per_class));
  if (q.solids)
    text += solids_line(*q.solids);
  if (m.pi)
    text += fmt::format("pi {} {}\n", m.pi->lower_text(), m.pi->upper_text());
  if (q.at_least > 1)
    text += fmt::format("at-least {}\n", to_string(q.at_least));
  return text;
}

std::string witness_lines(const Match &m) {
  const bool precise = std::all_of(m.sizes.begin(), m.sizes.end(), [&m](const Enclosure &x) {
    return (x.hi - x.lo) * power_of_ten(least_digits - 1) <= x.lo && fits(m, x.hi);
  });
  const std::vector<Enclosure> sizes =
      precise ? m.sizes : enclose_sizes(m.gradation, m.problem, m.q, m.scale, least_digits);
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

std::string certificate(const Match &m) {
  check_powers(m);
  return "mdm-certificate 1\n" + question_lines(m) + witness_lines(m) + chain_lines(m) + "end\n";
}

} // namespace mdm
