#include "verify.hpp"

#include <algorithm>

namespace mdm_check {

void demand(bool holds, const char *condition, std::uint64_t j) {
  if (!holds)
    throw Refused(std::string(condition) + " fails" + (j > 0 ? " at class " + std::to_string(j) : ""));
}

void demand_within(std::uint64_t work, std::uint64_t most, const Certificate &certificate) {
  demand_form(
      work <= most, certificate.law[0].text,
      "numbers as long as these, or so many, take too long: use a simpler law, fewer digits or steps");
}

std::uint64_t bits(const mpq_class &value) {
  return std::max(mpz_sizeinbase(value.get_num_mpz_t(), 2), mpz_sizeinbase(value.get_den_mpz_t(), 2));
}

mpz_class common_denominator(const Rationals &values) {
  mpz_class common = 1;
  for (const mpq_class &value : values)
    common = lcm(common, value.get_den());
  return common;
}

mpz_class in_units(const mpq_class &value, const mpz_class &unit) {
  return value.get_num() * mpz_class(unit / value.get_den());
}

void include(mpz_class &common, const mpz_class &divisor, const Certificate &certificate) {
  if (mpz_divisible_p(common.get_mpz_t(), divisor.get_mpz_t()))
    return;
  common = lcm(common, divisor);
  demand_within(bits(common), limit::power_bits, certificate);
}

std::uint64_t work_of(const Certificate &certificate, std::uint64_t n) {
  std::uint64_t steps = 64 * n + (certificate.chain ? certificate.chain->size() : 0);
  for (const TreeNode &node : certificate.tree)
    steps += node.leaf.empty() ? 1 : n + node.leaf.size();
  return steps;
}

mpz_class integer_of(const Numbers &line) {
  return line.empty() ? mpz_class(0) : line[0].value.get_num();
}

namespace {

/// The limits 1 and 2 of section 2: bounds time and memory before the first power is computed.
void demand_small(const Gradation &gradation, const Certificate &c) {
  std::uint64_t longest = 0;
  for (const Rationals *column :
       {&gradation.openings, &gradation.masses, &gradation.factors, &gradation.tolerances})
    for (const mpq_class &value : *column)
      longest = std::max(longest, bits(value));
  std::uint64_t longest_count = 0;
  for (const Numbers *line : {&c.min_per_class, &c.at_least, &c.particles, &c.retained, &c.passing,
                              &c.passing_each, &c.total, &c.band})
    for (const Number &number : *line)
      longest_count = std::max(longest_count, bits(number.value));
  for (const ClassWitness &witness : c.classes)
    longest_count = std::max(
        {longest_count, bits(witness.quantity), bits(witness.mass), bits(witness.lo), bits(witness.hi)});
  for (const TreeNode &node : c.tree) {
    longest_count = std::max(longest_count, bits(node.v));
    for (const Multiple &multiple : node.leaf)
      longest_count = std::max(longest_count, bits(multiple.m));
  }
  const mpq_class &law = c.law[0].value;
  const std::uint64_t exponent = mpz_class(std::max(law.get_num(), law.get_den())).get_ui();
  demand_within(exponent * std::max(longest, longest_count), limit::power_bits, c);
  demand_within(work_of(c, gradation.openings.size()) * exponent * (longest + longest_count),
                limit::work_of_steps, c);
}

} // namespace

void apply_question(Gradation &gradation, const Certificate &certificate) {
  Rationals &x = gradation.openings;
  if (!certificate.pan_size.empty()) {
    const mpq_class &size = certificate.pan_size[0].value;
    demand(x[0] == 0 && size < x[1], "pan-size: x_1 = 0, P < x_2");
    x[0] = size;
  }
  if (!certificate.cut_below.empty()) {
    const mpq_class &size = certificate.cut_below[0].value;
    const auto cut = std::lower_bound(x.begin(), x.end(), size);
    demand(cut != x.end() && *cut == size && size < x.back(), "cut-below: S is an opening below x_n");
    const auto dropped = cut - x.begin();
    for (Rationals *column :
         {&gradation.masses, &gradation.factors, &gradation.tolerances, &gradation.openings})
      if (!column->empty())
        column->erase(column->begin(), column->begin() + dropped);
    demand(*std::max_element(gradation.masses.begin(), gradation.masses.end()) > 0,
           "cut-below: mass is left");
  }
  if (!certificate.size_factor.empty())
    for (mpq_class &opening : x)
      opening *= certificate.size_factor[0].value;
  demand_small(gradation, certificate);
}

Solids solids(const Certificate &certificate) {
  const Numbers &cylinder = certificate.cylinder, &box = certificate.box, &pi = certificate.pi;
  mpq_class volume = 0; // over pi for a cylinder
  if (!cylinder.empty())
    volume = cylinder[0].value * cylinder[0].value * cylinder[1].value / (4 * (1 + cylinder[2].value));
  else if (!box.empty())
    volume = box[0].value * box[1].value * box[2].value / (1 + box[3].value);
  else if (!pi.empty())
    volume = certificate.solids_volume[0].value;
  volume *= 6;
  return pi.empty() ? Solids{volume, volume} : Solids{volume / pi[1].value, volume / pi[0].value};
}

namespace {

/// arctan(1/m) in the given unit. Each term is a floor and the rest of the series is below 1: with k terms
/// the sum is off by less than k + 1 units.
mpz_class arctangent(unsigned long m, const mpz_class &unit) {
  mpz_class sum = 0;
  mpz_class odd_power = unit / m;
  for (unsigned long n = 1; odd_power > 0; n += 2, odd_power /= m * m) {
    const mpz_class term = odd_power / n;
    sum += n % 4 == 1 ? term : mpz_class(-term);
  }
  return sum;
}

} // namespace

/// By Machin: pi = 16 arctan(1/5) - 4 arctan(1/239), with fewer than 800 and 240 terms. p and r have at most
/// 1000 digits after the point; nowhere there has pi 90 digits 0 or 9 in a row, so that the unit decides each
/// comparison.
void verify_pi(const Certificate &certificate) {
  if (certificate.pi.empty())
    return;
  const mpz_class unit = power(10, 1100);
  const mpz_class pi = 16 * arctangent(5, unit) - 4 * arctangent(239, unit);
  const mpz_class error = 16 * 800 + 4 * 240;
  demand(certificate.pi[0].value * unit <= pi - error, "p < pi");
  demand(certificate.pi[1].value * unit >= pi + error, "pi < r");
}

void verify_size(const Rationals &openings, const ClassWitness &witness, const Ratio &T, unsigned long a) {
  const std::uint64_t j = witness.index;
  const mpq_class &lo = witness.lo, &hi = witness.hi;
  demand(openings[j - 1] < lo, "x_j < lo", j);
  demand(hi <= openings[j], "hi <= x_{j+1}", j);
  demand(1'000'000'000 * (hi - lo) <= lo, "10^9 (hi - lo) <= lo", j);
  // size^a <=> T
  const auto compare = [&](const mpq_class &size) {
    const mpz_class left = power(size.get_num(), a) * T.denominator;
    const mpz_class right = T.numerator * power(size.get_den(), a);
    return cmp(left, right);
  };
  if (lo == hi) {
    demand(compare(lo) == 0, "lo^a = T", j);
  } else {
    demand(compare(lo) <= 0, "lo^a <= T", j);
    demand(compare(hi) > 0, "T < hi^a", j);
  }
}

} // namespace mdm_check
