#include "verify.hpp"

#include <algorithm>

namespace mdm_check {
namespace {

/// Class j, which has mass, in integers: A_j = u f / M and B_j = u F / M with the problem's scale unit u.
struct Class {
  std::uint64_t j;
  mpz_class f, F, M;
  mpz_class C;     ///< the factor to the power b, in its own unit
  mpz_class floor; ///< r_j: no match has fewer particles in the class
};

/// The problem of section 2. All scales are to the power b, and divided by the scale unit.
struct Problem {
  unsigned long a, b;
  mpz_class R, M; ///< 0 where the question has none
  Rationals openings;
  mpz_class opening_unit; ///< the openings times this are integers
  std::vector<Class> classes;
  Ratio scale;       ///< the witness's
  Ratio least_scale; ///< 0, or what the solids demand of the witness
  Ratio above;       ///< z, or 0
};

/// W, the sum of m_j / c_j, in the units of M and C; with the sphere's law these are no powers. Factors of
/// many digits would make the common denominator grow with the classes: limit 4.
mpq_class solids_of_unit_scale(const std::vector<Class> &classes, const Certificate &certificate) {
  mpz_class common = 1;
  for (const Class &c : classes)
    include(common, c.C, certificate);
  mpz_class sum = 0;
  for (const Class &c : classes)
    sum += c.M * mpz_class(common / c.C);
  mpq_class result(sum, common);
  result.canonicalize();
  return result;
}

/// Sets what the solids demand of the witness, and returns what their volume excludes: Z, or 0. The unit of
/// scales is with the sphere's law that of W times the opening unit to the power -3.
Ratio apply_solids(Problem &problem, const Certificate &certificate) {
  const Solids demanded = solids(certificate);
  if (demanded.enough == 0)
    return {0, 1};
  const mpq_class unit = power(problem.opening_unit, 3) / solids_of_unit_scale(problem.classes, certificate);
  const mpq_class below = demanded.below * unit, enough = demanded.enough * unit;
  problem.least_scale = {enough.get_num(), enough.get_den()};
  // With bounds of pi every match has a larger scale, because r > pi.
  return certificate.pi.empty() ? Ratio{0, 1} : Ratio{below.get_num(), below.get_den()};
}

mpz_class integer_root(const mpz_class &value, unsigned long degree) {
  if (degree == 1)
    return value;
  mpz_class root;
  mpz_root(root.get_mpz_t(), value.get_mpz_t(), degree);
  return root;
}

/// The least count q >= r_j with q^b B_j > L (Theorem 1).
mpz_class count(const Class &class_j, const Ratio &L, unsigned long b) {
  const mpz_class numerator = L.numerator * class_j.M;
  const mpz_class denominator = L.denominator * class_j.F;
  const mpz_class least = integer_root(numerator / denominator, b) + 1;
  return std::max(class_j.floor, least);
}

/// Derives the problem; what does not fit together is Refused, what would take too long is Malformed.
Problem derive(Gradation gradation, const Certificate &certificate) {
  apply_question(gradation, certificate);

  Problem problem;
  const unsigned long a = problem.a = certificate.law[0].value.get_num().get_ui();
  const unsigned long b = problem.b = certificate.law[0].value.get_den().get_ui();
  problem.R = integer_of(certificate.min_per_class);
  problem.M = integer_of(certificate.at_least);
  problem.opening_unit = common_denominator(gradation.openings);
  const mpz_class mass_unit = common_denominator(gradation.masses);
  const mpz_class factor_unit = common_denominator(gradation.factors);
  const auto size = [&](std::size_t i) {
    return power(in_units(gradation.openings[i], problem.opening_unit), a);
  };
  for (std::size_t j = 1; j < gradation.openings.size(); ++j) {
    const mpz_class M = power(in_units(gradation.masses[j - 1], mass_unit), b);
    const mpz_class C = power(in_units(gradation.factors[j - 1], factor_unit), b);
    if (M > 0)
      problem.classes.push_back({j, C * size(j - 1), C * size(j), M, C, 0});
  }
  problem.openings = std::move(gradation.openings);

  const mpz_class per_unit = power(factor_unit, b) * power(problem.opening_unit, a);
  const mpz_class unit = power(mass_unit, b);
  const auto in_scale_units = [&](const mpq_class &scale) {
    return Ratio{scale.get_num() * per_unit, scale.get_den() * unit};
  };
  problem.scale = in_scale_units(certificate.scale[0].value);
  if (!certificate.above.empty())
    problem.above = in_scale_units(certificate.above[0].value);
  Ratio excluded = apply_solids(problem, certificate);
  std::uint64_t longest = 0;
  for (const Ratio *scale : {&problem.scale, &problem.least_scale, &problem.above, &excluded})
    longest = std::max({longest, bits(scale->numerator), bits(scale->denominator)});
  demand_within((problem.openings.size() - 1) * longest, limit::work_of_scales, certificate); // limit 3

  for (Class &c : problem.classes) {
    c.floor = std::max<mpz_class>(1, problem.R);
    if (!certificate.cylinder.empty()) {
      const mpz_class needed = problem.least_scale.numerator * c.M - 1;
      c.floor = std::max<mpz_class>(c.floor, needed / (problem.least_scale.denominator * c.F) + 1);
    }
    c.floor = std::max(count(c, excluded, b), count(c, problem.above, b));
  }
  return problem;
}

void verify_class(const Problem &problem, const Class &c, const ClassWitness &witness) {
  const std::uint64_t j = c.j;
  const mpz_class &q = witness.quantity;
  const mpz_class particles = power(q, problem.b) * problem.scale.denominator;
  const mpz_class scaled_mass = problem.scale.numerator * c.M;
  demand(witness.index == j, "witness: one line a class with mass", j);
  demand(q >= problem.R, "q >= R", j);
  demand(particles * c.f < scaled_mass, "q^b A < S", j);
  demand(scaled_mass <= particles * c.F, "S <= q^b B", j);
  const Ratio T{scaled_mass, particles * c.C * power(problem.opening_unit, problem.a)};
  verify_size(problem.openings, witness, T, problem.a);
}

void verify_witness(const Problem &problem, const Certificate &certificate, const mpz_class &N) {
  const Ratio &S = problem.scale, &least = problem.least_scale;
  demand(S.numerator * least.denominator >= least.numerator * S.denominator,
         "scale: the volume of the solids");
  demand(certificate.classes.size() == problem.classes.size(), "witness: one line a class with mass");
  mpz_class sum = 0;
  for (std::size_t i = 0; i < problem.classes.size(); ++i) {
    verify_class(problem, problem.classes[i], certificate.classes[i]);
    sum += certificate.classes[i].quantity;
  }
  demand(sum == N, "sum of q = N");
  demand(N >= problem.M, "N >= M");
}

/// Replays the chain of forced raises (Theorem 5). Each L is below the scale of every match. A count above N
/// ends the replay: it is a lower bound, so that no continuation can be accepted.
void verify_chain(const Problem &problem, const std::vector<std::uint32_t> &chain, const mpz_class &N) {
  std::vector<const Class *> class_of(problem.openings.size());
  for (const Class &c : problem.classes)
    class_of[c.j] = &c;
  Ratio L;
  for (const std::uint32_t j : chain) {
    demand(j < class_of.size() && class_of[j] != nullptr, "chain: every step is a class with mass", j);
    const Class &c = *class_of[j];
    const mpz_class q = count(c, L, problem.b);
    demand(q <= N, "chain: count(j, L) <= N", j);
    L.numerator = power(q, problem.b) * c.f;
    L.denominator = c.M;
  }
  mpz_class sum = 0;
  for (const Class &c : problem.classes) {
    const mpz_class q = count(c, L, problem.b);
    demand(power(q, problem.b) * c.f * L.denominator <= c.M * L.numerator, "chain: count(j, L)^b A <= L",
           c.j);
    sum += q;
  }
  demand(sum == N, "chain: sum of count(j, L) = N");
}

/// M particles do not fit at any scale up to z (Theorem 7): the most that are possible, h_j with h_j^b A_j <
/// z, are fewer.
void verify_above(const Problem &problem) {
  mpz_class sum = 0;
  for (const Class &c : problem.classes) {
    demand(c.f > 0, "above: A > 0", c.j);
    const mpz_class below = (problem.above.numerator * c.M - 1) / (problem.above.denominator * c.f);
    sum += integer_root(below, problem.b);
  }
  demand(sum < problem.M, "above: sum of h < M");
}

} // namespace

void verify_exact(Gradation gradation, const Certificate &certificate) {
  const Problem problem = derive(std::move(gradation), certificate);
  const mpz_class N = integer_of(certificate.particles);
  verify_pi(certificate);
  verify_witness(problem, certificate, N);
  if (certificate.chain)
    verify_chain(problem, *certificate.chain, N);
  if (!certificate.above.empty())
    verify_above(problem);
}

} // namespace mdm_check
