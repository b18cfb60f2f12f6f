// Mass laws as users write them, and their values. A power is x^(a/b) in lowest terms. A law by table or sum
// is one of sizes in mm; of a gradation in another unit it becomes one of that unit, exactly: sizes of nodes
// are multiplied, coefficients divided by powers.

#include "number/typed_number.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/mass_law.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <map>

namespace mdm {
namespace {

[[noreturn]] void refuse_law(std::string_view text) {
  throw InputError(fmt::format("{} is no mass law: write 'sphere', or 'power:a/b' with whole a and b "
                               "from 1 to {}, for example 'power:2' or 'power:5/2', or 'sum:2*x^3+0.5*x^2' "
                               "of x in mm, or 'table:FILE'",
                               in_quotes(text), max_law_exponent));
}

/// a/b or a decimal; nothing if it is neither.
std::optional<Rational> parse_ratio(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) {
    try {
      return parse_typed_decimal(text);
    } catch (const InputError &) {
      return std::nullopt;
    }
  }
  const std::optional<Integer> a = parse_typed_natural(text.substr(0, slash));
  const std::optional<Integer> b = parse_typed_natural(text.substr(slash + 1));
  if (!a || !b || *b == 0)
    return std::nullopt;
  return ratio(*a, *b);
}

MassLaw parse_power(std::string_view text, std::string_view exponent_text) {
  const std::optional<Rational> exponent = parse_ratio(exponent_text);
  if (!exponent || *exponent <= 0)
    refuse_law(text);
  const Integer a = numerator(*exponent);
  const Integer b = denominator(*exponent);
  if (a > max_law_exponent || b > max_law_exponent)
    refuse_law(text);
  return {a.convert_to<unsigned>(), b.convert_to<unsigned>()};
}

/// `c*x^n`, or `x^n`, `c*x`, `x`.
LawTerm parse_term(std::string_view text, std::string_view term) {
  const auto refuse = [&] {
    throw InputError(fmt::format("{}: {} is no term c*x^n with a fraction c from 0 on and a whole n from 1 "
                                 "to {}: write, for example, 'sum:2*x^3+1/2*x^2'",
                                 in_quotes(text), in_quotes(term), max_law_exponent));
  };
  LawTerm read{1, 1};
  const std::size_t star = term.find('*');
  if (star != std::string_view::npos) {
    const std::optional<Rational> c = parse_ratio(trimmed(term.substr(0, star)));
    if (!c || *c < 0)
      refuse();
    read.coefficient = *c;
  }
  const std::string_view power = trimmed(term.substr(star == std::string_view::npos ? 0 : star + 1));
  if (power == "x")
    return read;
  const std::optional<Integer> n =
      power.starts_with("x^") ? parse_typed_natural(power.substr(2)) : std::nullopt;
  if (!n || *n < 1 || *n > max_law_exponent)
    refuse();
  read.exponent = n->convert_to<unsigned>();
  return read;
}

MassLaw parse_sum(std::string_view text, std::string_view terms) {
  std::map<unsigned, Rational, std::greater<>> coefficients;
  for (std::size_t from = 0; from <= terms.size();) {
    const std::size_t plus = std::min(terms.find('+', from), terms.size());
    const LawTerm term = parse_term(text, trimmed(terms.substr(from, plus - from)));
    if (term.coefficient > 0)
      coefficients[term.exponent] += term.coefficient;
    from = plus + 1;
  }
  if (coefficients.empty())
    throw InputError(
        fmt::format("{} is 0 for every size: give one of its terms a number above 0", in_quotes(text)));
  if (coefficients.size() > max_law_terms)
    throw InputError(
        fmt::format("{} has more than {} powers: leave out the smallest", in_quotes(text), max_law_terms));
  MassLaw law{1, 1};
  for (const auto &[exponent, coefficient] : coefficients)
    law.sum.push_back({coefficient, exponent});
  return law;
}

/// y on the line through two points.
Rational between(const Rational &x, const Rational &x0, const Rational &y0, const Rational &x1,
                 const Rational &y1) {
  return y0 + (x - x0) * (y1 - y0) / (x1 - x0);
}

} // namespace

Rational MassLaw::powered(const Rational &x) const {
  if (is_power())
    return power(x, a);
  if (table.empty()) {
    Rational mass = 0;
    for (const LawTerm &term : sum)
      mass += term.coefficient * power(x, term.exponent);
    return mass;
  }
  const auto node =
      std::partition_point(table.begin(), table.end(), [&x](const LawNode &n) { return n.size < x; });
  if (node == table.end())
    throw InputError(fmt::format("the size {} is beyond the table of the mass law, which ends at {}: add a "
                                 "row to the table",
                                 approximate(x, 15), approximate(table.back().size, 15)));
  const LawNode before = node == table.begin() ? LawNode{0, 0} : *(node - 1);
  return between(x, before.size, before.mass, node->size, node->mass);
}

std::string MassLaw::exponent() const {
  return b == 1 ? std::to_string(a) : std::to_string(a) + "/" + std::to_string(b);
}

std::string MassLaw::formula(SizeUnit unit) const {
  if (is_power())
    return "x^(" + exponent() + ")";
  std::string text;
  for (const LawNode &node : table)
    text += fmt::format("{}{} {}: {}", text.empty() ? "by the table " : ", ", to_decimal(node.size),
                        name(unit), to_decimal(node.mass));
  for (const LawTerm &term : sum)
    text += fmt::format("{}{}*x^{}", text.empty() ? "" : " + ", to_string(term.coefficient), term.exponent);
  return sum.empty() ? text : text + ", x in " + std::string(name(unit));
}

MassLaw MassLaw::scaled(const Rational &factor) const {
  MassLaw law = *this;
  for (LawNode &node : law.table)
    node.size *= factor;
  for (LawTerm &term : law.sum)
    term.coefficient /= power(factor, term.exponent);
  return law;
}

Rational MassLaw::steepness() const {
  if (is_power())
    return ratio(a, b);
  if (table.empty())
    return sum.front().exponent;
  // On a segment x f'(x) / f(x) is monotone: it is largest at an end.
  Rational steepest = 1;
  for (std::size_t i = 1; i < table.size(); ++i) {
    const LawNode &from = table[i - 1], &to = table[i];
    const Rational slope = (to.mass - from.mass) / (to.size - from.size);
    steepest =
        std::max({steepest, Rational(slope * from.size / from.mass), Rational(slope * to.size / to.mass)});
  }
  return steepest;
}

MassLaw parse_mass_law(std::string_view text) {
  constexpr std::string_view power = "power:", sum = "sum:";
  if (text == "sphere")
    return {};
  if (text.starts_with(power))
    return parse_power(text, text.substr(power.size()));
  if (text.starts_with(sum))
    return parse_sum(text, text.substr(sum.size()));
  refuse_law(text);
}

} // namespace mdm
