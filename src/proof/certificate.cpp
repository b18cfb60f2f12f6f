// The certificate of an exact match as text (certificate-format.md, sections 1 to 3). What comes in is a
// match with its chain; what goes out are the question, the claim, the counts, sizes and scale, and the
// chain.
//
// Nothing is decided here but what fits: the format limits the work of a checker, so the steps that may be
// written are estimated from above, and where a sweep was longer, or was ended by a limit, its first steps
// are replayed for the bound that they prove (Theorem 5). Sizes are enclosed anew where the match's are too
// wide or too long for the format. A text whose numbers no checker would read is refused with what to do.

#include "match/least_match.hpp"
#include "match/problem_of.hpp"
#include "match/sizes.hpp"
#include "number/common_denominator.hpp"
#include "proof/certificate_parts.hpp"
#include "proof/question_text.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/proof/certificate.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
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

std::size_t longest_opening(const Gradation &g) {
  return (longest_part(g.powers()) + g.root() - 1) / g.root();
}

std::uint64_t highest_power(const MassLaw &law, unsigned root) {
  constexpr std::uint64_t of_table = 5; // a value is made of a size and two nodes
  std::uint64_t of_sum = 0;
  for (const LawTerm &term : law.sum)
    of_sum += term.exponent;
  return law.is_power() ? std::uint64_t{std::max(law.a, law.b)} * root : law.sum.empty() ? of_table : of_sum;
}

std::size_t longest_part(const MassLaw &law) {
  std::size_t bits = 1;
  for (const LawNode &node : law.table)
    bits = std::max({bits, longest_part(node.size), longest_part(node.mass)});
  for (const LawTerm &term : law.sum)
    bits = std::max({bits, longest_part(term.coefficient), bit_length(term.exponent)});
  return bits;
}

std::uint64_t highest_power(const Match &m) {
  return highest_power(m.question.law, m.gradation.root());
}

bool is_precise(const Match &m, const Enclosure &size) {
  return (size.hi - size.lo) * power_of_ten(least_digits - 1) <= size.lo &&
         bit_length(size.hi) * highest_power(m) <= max_power_bits;
}

namespace {

/// A class with particles, as the certificate has it.
struct CertifiedClass {
  std::size_t number;
  const Integer &quantity;
  Enclosure size;
};

/// At most.
std::size_t bytes_of_step(const Gradation &g) {
  return std::to_string(g.classes()).size() + 1;
}

/// The steps that a chain may have within the format's limits on the work of a checker
/// (certificate-format.md, section 2, Limits), and on the length of the text; these are estimated from above.
/// \throws InputError if the other numbers alone are beyond them
std::uint64_t most_certified_steps(const Match &m, const Chain &chain,
                                   const std::vector<CertifiedClass> &classes) {
  const Gradation &g = m.gradation;
  const std::uint64_t e = highest_power(m);
  const std::uint64_t in_gradation =
      std::max({longest_opening(g), longest_part(g.masses()), longest_part(g.factors())});
  std::size_t count =
      std::max({bit_length(m.question.at_least), bit_length(*m.particles()), longest_part(m.question.law)});
  for (const CertifiedClass &c : classes)
    count = std::max({count, bit_length(c.size.hi), bit_length(power_of_ten(c.size.places))});
  const Rational unit = problem_of(m).scale_unit();
  const auto length = [&unit](const Rational &scale) { return longest_part(Rational(scale / unit)); };
  std::size_t scale = length(m.sample->scale->chosen);
  if (chain.above)
    scale = std::max(scale, length(*chain.above));
  if (const std::optional<Interval> &start = m.sample->scale->window.start)
    scale = std::max(scale, length(start->lo));
  Integer factors = 1;
  if (m.question.solids)
    for (const Integer &c : CommonDenominator(g.factors()).numerators)
      factors = bit_length(factors) > max_power_bits ? factors : lcm(factors, c);
  const std::uint64_t work = max_work / (e * (in_gradation + count)), before_steps = 64 * g.powers().size();
  if (e * in_gradation > max_power_bits || e * count > max_power_bits || work < before_steps ||
      g.classes() * scale > std::uint64_t{1} << 28 || bit_length(factors) > max_power_bits)
    refuse_long_numbers();
  constexpr std::uint64_t max_chain_bytes = std::uint64_t{250} << 20;
  return std::min(work - before_steps, max_chain_bytes / bytes_of_step(g));
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
  std::string text = law_and_openings_lines(q);
  if (q.min_per_class > (q.is_tolerant() ? 0 : 1))
    text += fmt::format("min-per-class {}\n", to_string(q.min_per_class));
  if (q.solids)
    text += solids_line(*q.solids);
  if (const std::optional<Enclosure> &pi = m.proof.pi)
    text += fmt::format("pi {} {}\n", pi->lower_text(), pi->upper_text());
  if (q.at_least > 1)
    text += fmt::format("at-least {}\n", to_string(q.at_least));
  return text;
}

std::string asked_lines(const Gradation &g, const Question &question) {
  const Match asked(question, asked_gradation(g, question));
  return question_lines(asked) +
         (question.is_tolerant() ? tolerance_lines(question, asked.gradation).text : "");
}

namespace {

/// The match's sizes if they are precise and short enough for the format, else such ones.
std::vector<CertifiedClass> certified_classes(const Match &m) {
  const MatchSample &sample = *m.sample;
  std::vector<CertifiedClass> classes;
  for (std::size_t j = 0; j < sample.sizes.size(); ++j)
    if (sample.sizes[j])
      classes.push_back({j + 1, sample.quantities[j], *sample.sizes[j]});
  if (std::all_of(classes.begin(), classes.end(),
                  [&m](const CertifiedClass &c) { return is_precise(m, c.size); }))
    return classes;
  std::vector<Integer> q;
  for (const CertifiedClass &c : classes)
    q.push_back(c.quantity);
  const std::vector<Enclosure> sizes =
      enclose_sizes(m.gradation, problem_of(m), q, sample.scale->chosen, sample.scale->margin, least_digits);
  for (std::size_t i = 0; i < classes.size(); ++i)
    classes[i].size = sizes[i];
  return classes;
}

/// The first steps of the match's sweep, and the bound that they come to.
std::pair<Chain, Integer> first_steps(const Match &m, const std::optional<Rational> &above,
                                      std::uint64_t steps) {
  const Problem problem = problem_of(m);
  const Rational from = above ? Rational(*above / problem.scale_unit()) : Rational(0);
  Limits limits;
  limits.max_steps = steps;
  LeastMatch least = least_match(problem.from_scale(from, true), limits);
  return {chain_of(std::move(least.chain), from, problem), std::max(total(least.q), m.question.at_least)};
}

std::string witness_lines(const Match &m, const Integer &bound, const std::vector<CertifiedClass> &classes) {
  const std::string n = to_string(*m.particles());
  std::string text = fmt::format("particles {}\nscale {}\n", m.proof.bound ? to_string(bound) + ".." + n : n,
                                 to_string(m.sample->scale->chosen));
  for (const CertifiedClass &c : classes)
    fmt::format_to(std::back_inserter(text), "class {} {} {} {}\n", c.number, to_string(c.quantity),
                   c.size.lower_text(), c.size.upper_text());
  return text;
}

/// What shows that no match has fewer particles than the bound.
void write_chain(const Match &m, const Chain &chain, const Integer &bound, std::string &text) {
  // That there are as many particles as were asked for is nothing to show.
  if (m.question.at_least > 1 && bound == m.question.at_least)
    return;
  if (chain.above)
    text += fmt::format("above {}\n", to_string(*chain.above));
  text += "chain";
  text.reserve(text.size() + chain.steps.size() * bytes_of_step(m.gradation) + 16);
  for (const std::uint32_t j : chain.steps)
    fmt::format_to(std::back_inserter(text), " {}", j + 1);
  text += "\n";
}

std::string exact_text(const Match &m, const std::vector<CertifiedClass> &classes, const Chain &chain,
                       const Integer &bound) {
  std::string text = m.proof.bound ? "mdm-certificate 2\n" : "mdm-certificate 1\n";
  text += question_lines(m) + witness_lines(m, bound, classes);
  write_chain(m, chain, bound, text);
  return text += "end\n";
}

Certified exact_certificate(const Match &m) {
  const std::vector<CertifiedClass> classes = certified_classes(m);
  const Chain &chain = std::get<Chain>(m.evidence().value());
  const std::optional<Integer> &bound = m.proof.bound;
  const std::uint64_t most = most_certified_steps(m, chain, classes);
  if (chain.steps.size() <= most)
    return {exact_text(m, classes, chain, bound.value_or(*m.particles())), bound};
  if (!bound)
    refuse_long_numbers();
  const auto [first, lower] = first_steps(m, chain.above, most);
  return {exact_text(m, classes, first, lower), lower};
}

} // namespace

void refuse_long_numbers() {
  throw InputError("the numbers are too long for a certificate that can be checked in reasonable time: round "
                   "sizes and masses, take a smaller exponent of the mass law, or ask for no proof");
}

namespace {

[[noreturn]] void refuse_long_number(const std::string &digits) {
  throw InputError(
      fmt::format("a number of the certificate would have {} digits, and its format allows {}: take "
                  "a law with smaller numbers or fewer digits, or ask for no proof",
                  digits, max_digits));
}

/// At most the logarithm of r > 0 to base 2, by 2 at most.
std::int64_t least_log2(const Rational &r) {
  return static_cast<std::int64_t>(bit_length(numerator(r))) - 1 -
         static_cast<std::int64_t>(bit_length(denominator(r)));
}

/// At most the logarithm to base 2 of the scale to the power b d of every exact match, nothing where the
/// question says too little. A class with q particles has S > q^bd A_j (Theorem 1): every class with q = R,
/// and some class with q = M / k, where k classes have mass.
std::optional<std::int64_t> least_log2_of_scale(const Gradation &g, const Question &question) {
  const std::int64_t a = question.law.a, power = std::int64_t{question.law.b} * g.root();
  std::optional<std::int64_t> largest, smallest; // of the A_j
  bool has_zero = false;
  Integer classes = 0;
  for (std::size_t j = 0; j < g.classes(); ++j) {
    if (g.mass(j) == 0)
      continue;
    ++classes;
    if (g.powers()[j] == 0) {
      has_zero = true;
      continue;
    }
    const std::int64_t A =
        a * least_log2(g.powers()[j]) + power * least_log2(Rational(g.factor(j) / g.mass(j)));
    largest = std::max(largest.value_or(A), A);
    smallest = std::min(smallest.value_or(A), A);
  }
  const auto at_count = [&](const Integer &q, const std::int64_t A) {
    return power * (static_cast<std::int64_t>(bit_length(q)) - 1) + A;
  };
  std::optional<std::int64_t> least;
  if (largest)
    least = at_count(std::max(Integer(1), question.min_per_class), *largest);
  if (const Integer share = floor_div(question.at_least, classes); smallest && !has_zero && share > 0)
    least = std::max(*least, at_count(share, *smallest));
  return least;
}

} // namespace

void check_short_numbers(const std::string &text) {
  std::size_t digits = 0, longest = 0;
  for (const char c : text) {
    if (c >= '0' && c <= '9')
      longest = std::max(longest, ++digits);
    else if (c != '.')
      digits = 0;
  }
  if (longest > max_digits)
    refuse_long_number(std::to_string(longest));
}

void check_certifiable(const Gradation &asked, const Question &question) {
  const std::uint64_t e = highest_power(question.law, asked.root());
  const std::uint64_t bits =
      e * std::max({longest_opening(asked), longest_part(asked.masses()), longest_part(asked.factors())});
  const std::uint64_t count =
      std::max(bit_length(std::max(question.at_least, question.min_per_class)), longest_part(question.law));
  if (bits > max_power_bits || e * count > max_power_bits || 64 * asked.powers().size() * bits > max_work)
    refuse_long_numbers();
  constexpr std::int64_t too_long = 332193; // 2^332193 > 10^max_digits
  if (!question.is_tolerant() && question.law.is_power() &&
      least_log2_of_scale(asked, question).value_or(0) >= too_long)
    refuse_long_number(fmt::format("more than {}", max_digits));
}

Certified certified(const Match &m) {
  assert(has_certificate(m));
  Certified made = m.tolerance ? tree_certificate(m) : exact_certificate(m);
  check_short_numbers(made.text);
  return made;
}

} // namespace mdm
