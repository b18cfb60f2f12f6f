#include "law.hpp"
#include "verify.hpp"

#include <algorithm>

namespace mdm::checker {
namespace {

/// Class j, which has mass. By Theorem 1 q particles can hold the mass s m_j iff q^n A < s^n <= q^n B, where
/// n is the degree b d.
struct Class {
  std::uint64_t j;
  mpq_class mass; ///< m_j / c_j
  Ratio A, B;
  mpz_class floor; ///< r_j: no match has fewer particles in the class
};

/// The problem of section 2, with openings, masses and factors as integers, each column in its own unit.
/// Scales are to the power of the degree.
struct Problem {
  unsigned long degree; ///< b d
  std::vector<Class> classes;
  mpz_class opening_unit; ///< to the power a
  Ratio S, z, S0, Z;      ///< the witness's scale; those of `above` and the solids, or 0
};

/// Multiplies the values with their common denominator, and returns that.
mpz_class make_integers(Rationals &values) {
  const mpz_class unit = common_denominator(values);
  for (mpq_class &value : values)
    value = in_units(value, unit);
  return unit;
}

mpz_class root(const mpz_class &value, unsigned long degree) {
  if (degree == 1)
    return value;
  mpz_class result;
  mpz_root(result.get_mpz_t(), value.get_mpz_t(), degree);
  return result;
}

/// The least count q >= r_j with q^n B_j > L.
mpz_class count(const Class &c, const Ratio &L, unsigned long degree) {
  const Ratio quotient = L / c.B;
  const mpz_class least = root(quotient.num / quotient.den, degree) + 1;
  return std::max(c.floor, least);
}

/// Sets S0, which is enough for the witness, and Z: with bounds of pi every match has a larger scale, because
/// r > pi. Factors of many digits make the denominator of W grow with the classes: limit 4.
void apply_solids(Problem &problem, const Gradation &integers, const Certificate &certificate) {
  const Solids demanded = solids(certificate);
  if (demanded.enough == 0)
    return;
  mpz_class common = 1;
  mpq_class W = 0;
  for (const Class &c : problem.classes) {
    include(common, integers.factors[c.j - 1].get_num(), certificate);
    W += c.mass;
  }
  const auto scale_of = [&](const mpq_class &volume) {
    const mpq_class scale = volume / W;
    demand_within(bits(scale) * problem.degree * (integers.openings.size() - 1), 28, certificate); // limit 3
    return Ratio(raised(scale, problem.degree)) * problem.opening_unit;
  };
  problem.S0 = scale_of(demanded.enough);
  if (!certificate.pi.empty())
    problem.Z = scale_of(demanded.below);
}

Problem derive(Gradation gradation, const Certificate &certificate) {
  const unsigned long a = certificate.a, degree = certificate.b * gradation.root;
  const mpz_class least = std::max<mpz_class>(1, integer_of(certificate.min_per_class));
  Problem problem;
  problem.degree = degree;
  gradation.openings = measured_openings(gradation, certificate);
  problem.opening_unit = power(make_integers(gradation.openings), a);
  const Ratio unit(problem.opening_unit * power(make_integers(gradation.factors), degree),
                   power(make_integers(gradation.masses), degree));
  for (std::size_t j = 0; j < gradation.masses.size(); ++j)
    if (gradation.masses[j] > 0) {
      const mpq_class mass = gradation.masses[j] / gradation.factors[j];
      const Ratio of_mass = raised(mass, degree);
      problem.classes.push_back({j + 1, mass, power(gradation.openings[j], a) / of_mass,
                                 power(gradation.openings[j + 1], a) / of_mass, least});
    }
  problem.S = unit * certificate.scale[0].value;
  if (!certificate.above.empty())
    problem.z = unit * certificate.above[0].value;
  apply_solids(problem, gradation, certificate);
  std::uint64_t longest = 0;
  for (const Ratio *scale : {&problem.S, &problem.z, &problem.S0, &problem.Z})
    longest = std::max({longest, bits(scale->num), bits(scale->den)});
  demand_within(longest * (gradation.openings.size() - 1), 28, certificate); // limit 3
  for (Class &c : problem.classes) {
    if (!certificate.cylinder.empty()) {
      const Ratio quotient = problem.S0 / c.B;
      c.floor = std::max<mpz_class>(c.floor, root((quotient.num - 1) / quotient.den, degree) + 1);
    }
    c.floor = std::max(count(c, problem.Z, degree), count(c, problem.z, degree));
  }
  return problem;
}

void verify_witness(const Problem &problem, const Gradation &gradation, const Certificate &certificate) {
  demand(compare(problem.S, problem.S0) >= 0, "scale: the volume of the solids");
  demand(certificate.classes.size() == problem.classes.size(), "witness: one line a class with mass");
  mpz_class sum = 0;
  for (std::size_t i = 0; i < problem.classes.size(); ++i) {
    const Class &c = problem.classes[i];
    const ClassWitness &witness = certificate.classes[i];
    demand(witness.index == c.j, "witness: one line a class with mass", c.j);
    demand(witness.quantity >= integer_of(certificate.min_per_class), "q >= R", c.j);
    // That the size is in (x_j, x_{j+1}] says that q^n A < S <= q^n B.
    const Ratio one = Ratio(c.mass) / witness.quantity;
    const Ratio T = power(one, problem.degree) * problem.S / problem.opening_unit;
    verify_size(gradation, certificate, witness, T, certificate.a * gradation.root);
    sum += witness.quantity;
  }
  demand(sum == integer_of(certificate.particles), "sum of q = N");
  demand(sum >= integer_of(certificate.at_least), "N >= M");
}

/// Replays the chain of forced raises (Theorem 5). Each L is below the scale of every match. A count above
/// the bound ends the replay: it is a lower bound, so that no continuation can be accepted. The chain of a
/// smallest match goes on to its end.
void verify_chain(const Problem &problem, const Certificate &certificate) {
  const mpz_class bound = integer_of(certificate.bound);
  const bool ends = bound == integer_of(certificate.particles);
  const unsigned long degree = problem.degree;
  std::vector<const Class *> class_of(problem.classes.back().j + 1);
  for (const Class &c : problem.classes)
    class_of[c.j] = &c;
  Ratio L;
  for (const std::uint32_t j : *certificate.chain) {
    demand(j < class_of.size() && class_of[j] != nullptr, "chain: every step is a class with mass", j);
    const mpz_class q = count(*class_of[j], L, degree);
    demand(q <= bound, "chain: count(j, L) <= N", j);
    L = class_of[j]->A * power(q, degree);
  }
  mpz_class sum = 0;
  for (const Class &c : problem.classes) {
    const mpz_class q = count(c, L, degree);
    demand(!ends || compare(c.A * power(q, degree), L) <= 0, "chain: count(j, L)^n A <= L", c.j);
    sum += q;
  }
  demand(sum == bound, "chain: sum of count(j, L) = N");
}

/// M particles do not fit at any scale up to z (Theorem 7): the most that are possible, h_j with h_j^n A_j <
/// z, are fewer.
void verify_above(const Problem &problem, const Certificate &certificate) {
  mpz_class sum = 0;
  for (const Class &c : problem.classes) {
    demand(c.A.num > 0, "above: A > 0", c.j);
    const Ratio quotient = problem.z / c.A;
    sum += root((quotient.num - 1) / quotient.den, problem.degree);
  }
  demand(sum < integer_of(certificate.at_least), "above: sum of h < M");
}

} // namespace

void verify_exact(Gradation gradation, const Certificate &certificate) {
  apply_question(gradation, certificate);
  const Problem problem = derive(gradation, certificate);
  verify_pi(certificate);
  verify_witness(problem, gradation, certificate);
  if (certificate.chain)
    verify_chain(problem, certificate);
  if (!certificate.above.empty())
    verify_above(problem, certificate);
}

} // namespace mdm::checker
