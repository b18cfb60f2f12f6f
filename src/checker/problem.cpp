#include "problem.hpp"

#include "text.hpp"

#include <algorithm>
#include <cstdint>

namespace mdm_check {
namespace {

using Rationals = std::vector<mpq_class>;

/// Applies pan-size, cut-below and size-factor, in this order.
void apply_question(Gradation &gradation, const Question &question) {
  Rationals &x = gradation.openings;
  if (question.pan_size) {
    if (x[0] != 0)
      throw Refused("pan-size: the gradation has no pan");
    if (question.pan_size->value >= x[1])
      throw Refused("pan-size: the pan is not smaller than the finest sieve");
    x[0] = question.pan_size->value;
  }
  if (question.cut_below) {
    const auto cut = std::lower_bound(x.begin(), x.end(), question.cut_below->value);
    if (cut == x.end() || *cut != question.cut_below->value || cut + 1 == x.end())
      throw Refused("cut-below: no sieve below the largest has this opening");
    const auto dropped = cut - x.begin();
    for (Rationals *column : {&gradation.openings, &gradation.masses, &gradation.factors})
      column->erase(column->begin(), column->begin() + dropped);
    if (std::all_of(gradation.masses.begin(), gradation.masses.end(),
                    [](const mpq_class &m) { return m == 0; }))
      throw Refused("cut-below: no mass is left");
  }
  if (question.size_factor)
    for (mpq_class &opening : x)
      opening *= question.size_factor->value;
}

std::uint64_t bits(const mpz_class &value) {
  return mpz_sizeinbase(value.get_mpz_t(), 2);
}
std::uint64_t bits(const mpq_class &value) {
  return std::max(bits(value.get_num()), bits(value.get_den()));
}

void demand_within(std::uint64_t work, std::uint64_t limit) {
  constexpr std::size_t law_line = 2;
  if (work > limit)
    throw Malformed(law_line, "powers of numbers as long as these, or so many of them, take too long: "
                              "use a simpler law, fewer digits, fewer classes or fewer steps");
}

/// Bounds time and memory before the first power is computed (section 2).
void demand_small(const Gradation &gradation, const Certificate &certificate) {
  std::uint64_t longest = 0;
  for (const Rationals *column : {&gradation.openings, &gradation.masses, &gradation.factors})
    for (const mpq_class &value : *column)
      longest = std::max(longest, bits(value));
  std::uint64_t longest_quantity = bits(certificate.particles);
  for (const std::optional<mpz_class> &quantity :
       {certificate.question.min_per_class, certificate.question.at_least})
    if (quantity)
      longest_quantity = std::max(longest_quantity, bits(*quantity));
  for (const ClassWitness &witness : certificate.classes)
    longest_quantity =
        std::max({longest_quantity, bits(witness.quantity), bits(witness.lo), bits(witness.hi)});
  const std::uint64_t exponent = std::max(certificate.question.a, certificate.question.b);
  demand_within(exponent * longest, 1U << 20U);
  demand_within(exponent * longest_quantity, 1U << 20U);
  const std::uint64_t steps = certificate.chain ? certificate.chain->size() : 0;
  demand_within((64 * gradation.openings.size() + steps) * exponent * (longest + longest_quantity),
                std::uint64_t{1} << 34U);
}

mpz_class common_denominator(const Rationals &values) {
  mpz_class common = 1;
  for (const mpq_class &value : values)
    mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), value.get_den_mpz_t());
  return common;
}

/// value * unit, an integer.
mpz_class in_units(const mpq_class &value, const mpz_class &unit) {
  return value.get_num() * mpz_class(unit / value.get_den());
}

Ratio ratio(const mpq_class &value) {
  return {value.get_num(), value.get_den()};
}

/// W, the sum of m_j / c_j, in the units of M and C; with the sphere's law these are no powers. Factors of
/// many digits would make the common denominator grow with the classes: its bound is that of powers.
mpq_class solids_of_unit_scale(const std::vector<Class> &classes) {
  mpz_class common = 1;
  for (const Class &c : classes)
    if (c.has_mass && mpz_divisible_p(common.get_mpz_t(), c.C.get_mpz_t()) == 0) {
      mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), c.C.get_mpz_t());
      demand_within(bits(common), 1U << 20U);
    }
  mpz_class sum = 0;
  for (const Class &c : classes)
    if (c.has_mass)
      sum += c.M * mpz_class(common / c.C);
  mpq_class result(sum, common);
  result.canonicalize();
  return result;
}

/// The scale that fills the volume, times pi for box and volume, in the scale unit. With the sphere's law
/// that unit is the unit of W times the opening unit to the power -3.
mpq_class solids_scale(const Problem &problem, const Question &question) {
  const std::vector<Number> &d = question.dimensions;
  mpq_class volume = d[0].value;
  if (question.solids == Solids::cylinder)
    volume = d[0].value * d[0].value * d[1].value / (4 * (1 + d[2].value));
  if (question.solids == Solids::box)
    volume = d[0].value * d[1].value * d[2].value / (1 + d[3].value);
  return 6 * volume * power(problem.opening_unit, 3) / solids_of_unit_scale(problem.classes);
}

} // namespace

mpz_class integer_root(const mpz_class &value, unsigned long degree) {
  if (degree == 1)
    return value;
  mpz_class root;
  mpz_root(root.get_mpz_t(), value.get_mpz_t(), degree);
  return root;
}

mpz_class count(const Class &class_j, const Ratio &L, unsigned long b) {
  mpz_class quotient = L.numerator * class_j.M;
  const mpz_class divisor = L.denominator * class_j.F;
  mpz_fdiv_q(quotient.get_mpz_t(), quotient.get_mpz_t(), divisor.get_mpz_t());
  mpz_class least = integer_root(quotient, b) + 1;
  return std::max(class_j.floor, least);
}

Problem derive(Gradation gradation, const Certificate &certificate) {
  const Question &question = certificate.question;
  apply_question(gradation, question);
  demand_small(gradation, certificate);

  Problem problem{question.a, question.b, {}, common_denominator(gradation.openings), {}, {}, {0, 1}, {0, 1}};
  const unsigned long a = question.a;
  const unsigned long b = question.b;
  const mpz_class mass_unit = common_denominator(gradation.masses);
  const mpz_class factor_unit = common_denominator(gradation.factors);
  mpz_class lower = power(in_units(gradation.openings[0], problem.opening_unit), a);
  for (std::size_t j = 0; j + 1 < gradation.openings.size(); ++j) {
    const mpz_class upper = power(in_units(gradation.openings[j + 1], problem.opening_unit), a);
    const mpz_class M = power(in_units(gradation.masses[j], mass_unit), b);
    const mpz_class C = power(in_units(gradation.factors[j], factor_unit), b);
    problem.classes.push_back({M > 0, C * lower, C * upper, M, C, 1});
    lower = upper;
  }
  problem.openings = std::move(gradation.openings);

  const mpz_class per_unit = power(factor_unit, b) * power(problem.opening_unit, a);
  const mpz_class unit = power(mass_unit, b);
  const auto in_scale_units = [&](const mpq_class &scale) {
    return Ratio{scale.get_num() * per_unit, scale.get_den() * unit};
  };
  problem.scale = in_scale_units(certificate.scale);
  if (certificate.above)
    problem.above = in_scale_units(*certificate.above);
  Ratio excluded{0, 1}; // Z: every match has a larger scale, because r > pi
  if (question.solids != Solids::none) {
    const mpq_class S0 = solids_scale(problem, question);
    problem.least_scale = ratio(question.solids == Solids::cylinder ? S0 : mpq_class(S0 / question.pi_low));
    if (question.solids != Solids::cylinder)
      excluded = ratio(S0 / question.pi_high);
  }
  std::uint64_t longest = 0;
  for (const Ratio *scale : {&problem.scale, &problem.least_scale, &problem.above, &excluded})
    longest = std::max({longest, bits(scale->numerator), bits(scale->denominator)});
  demand_within(problem.classes.size() * longest, std::uint64_t{1} << 32U);

  for (Class &c : problem.classes) {
    if (!c.has_mass)
      continue;
    if (question.min_per_class)
      c.floor = *question.min_per_class;
    if (question.solids == Solids::cylinder) {
      const mpz_class needed = problem.least_scale.numerator * c.M;
      const mpz_class per_particle = problem.least_scale.denominator * c.F;
      mpz_class least;
      mpz_cdiv_q(least.get_mpz_t(), needed.get_mpz_t(), per_particle.get_mpz_t());
      c.floor = std::max(c.floor, least);
    }
    c.floor = std::max(count(c, excluded, b), count(c, problem.above, b));
  }
  return problem;
}

} // namespace mdm_check
