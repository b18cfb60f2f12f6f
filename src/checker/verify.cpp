#include "verify.hpp"

#include "text.hpp"

#include <cstddef>
#include <string>

namespace mdm_check {
namespace {

/// arctan(1/m) in the given unit, off by less than terms + 1 units: each term is a floor, and the rest of the
/// series is below 1.
struct Arctangent {
  mpz_class value = 0;
  mpz_class terms = 0;

  Arctangent(unsigned long m, const mpz_class &unit) {
    mpz_class power_term = unit / m;
    for (unsigned long n = 1; power_term > 0; n += 2, power_term /= m * m, ++terms) {
      const mpz_class term = power_term / n;
      value += n % 4 == 1 ? term : mpz_class(-term);
    }
  }
};

/// p < pi < r by Machin: pi = 16 arctan(1/5) - 4 arctan(1/239). p and r have at most 1000 digits after the
/// point; nowhere there has pi 90 digits 0 or 9 in a row, so that the unit decides each comparison.
void verify_pi(const mpq_class &p, const mpq_class &r) {
  const mpz_class unit = power(10, 1100);
  const Arctangent fifth(5, unit);
  const Arctangent other(239, unit);
  const mpz_class pi = 16 * fifth.value - 4 * other.value;
  const mpz_class error = 16 * (fifth.terms + 1) + 4 * (other.terms + 1);
  if (p * unit > pi - error)
    throw Refused("pi: p < pi fails");
  if (r * unit < pi + error)
    throw Refused("pi: pi < r fails");
}

std::string class_name(std::size_t j) {
  return "class " + std::to_string(j + 1);
}

void verify_class(const Problem &problem, std::size_t j, const ClassWitness &witness) {
  const Class &c = problem.classes[j];
  const Ratio &S = problem.scale;
  const mpz_class &q = witness.quantity;
  const auto demand = [j](bool holds, const char *what) {
    if (!holds)
      throw Refused(class_name(j) + ": " + what + " fails");
  };
  const bool linear = problem.b == 1;
  const mpz_class q_to_b = power(q, problem.b);
  const mpz_class scaled_mass = S.numerator * c.M;
  const mpz_class particles = q_to_b * S.denominator;
  demand(particles * c.f < scaled_mass, linear ? "q A < S" : "q^b A < S");
  demand(scaled_mass <= particles * c.F, linear ? "S <= q B" : "S <= q^b B");

  const mpq_class &lo = witness.lo;
  const mpq_class &hi = witness.hi;
  demand(problem.openings[j] < lo, "x_j < lo");
  demand(hi <= problem.openings[j + 1], "hi <= x_{j+1}");
  demand(1'000'000'000 * (hi - lo) <= lo, "10^9 (hi - lo) <= lo");
  // size^a <=> T, both times the opening unit to the power a and the denominators.
  const auto compare = [&](const mpq_class &size) {
    const mpz_class left = power(size.get_num() * problem.opening_unit, problem.a) * particles * c.C;
    const mpz_class right = scaled_mass * power(size.get_den(), problem.a);
    return cmp(left, right);
  };
  if (lo == hi) {
    demand(compare(lo) == 0, "lo^a = T");
    return;
  }
  demand(compare(lo) <= 0, "lo^a <= T");
  demand(compare(hi) > 0, "T < hi^a");
}

void verify_witness(const Problem &problem, const Certificate &certificate) {
  const Question &question = certificate.question;
  const Ratio &S = problem.scale;
  const Ratio &least = problem.least_scale;
  if (S.numerator * least.denominator < least.numerator * S.denominator)
    throw Refused("scale: the solids of the witness do not fill the volume");
  mpz_class sum = 0;
  auto witness = certificate.classes.begin();
  for (std::size_t j = 0; j < problem.classes.size(); ++j) {
    const bool named = witness != certificate.classes.end() && witness->index == j + 1;
    if (named != problem.classes[j].has_mass)
      throw Refused(class_name(j) +
                    (named ? ": it has no mass, but a witness" : ": it has mass, but no witness"));
    if (!named)
      continue;
    if (question.min_per_class && witness->quantity < *question.min_per_class)
      throw Refused(class_name(j) + ": q >= R fails");
    verify_class(problem, j, *witness);
    sum += witness->quantity;
    ++witness;
  }
  if (witness != certificate.classes.end())
    throw Refused("class " + std::to_string(witness->index) + ": the gradation has no such class");
  if (sum != certificate.particles)
    throw Refused("particles: the sum of the quantities is not N");
  if (question.at_least && certificate.particles < *question.at_least)
    throw Refused("particles: N >= M fails");
}

/// Replays the chain of forced raises (Theorem 5). Each L is below the scale of every match. A count above N
/// ends the replay: it is a lower bound, so that no continuation can be accepted.
void verify_chain(const Problem &problem, const Certificate &certificate) {
  Ratio L{0, 1};
  for (const std::uint32_t index : *certificate.chain) {
    if (index == 0 || index > problem.classes.size())
      throw Refused("chain: there is no class " + std::to_string(index));
    const Class &c = problem.classes[index - 1];
    if (!c.has_mass)
      throw Refused("chain: class " + std::to_string(index) + " has no mass");
    const mpz_class q = count(c, L, problem.b);
    if (q > certificate.particles)
      throw Refused("chain: class " + std::to_string(index) + " needs more than N particles");
    L.numerator = power(q, problem.b) * c.f;
    L.denominator = c.M;
  }
  mpz_class sum = 0;
  for (std::size_t j = 0; j < problem.classes.size(); ++j) {
    const Class &c = problem.classes[j];
    if (!c.has_mass)
      continue;
    const mpz_class q = count(c, L, problem.b);
    if (power(q, problem.b) * c.f * L.denominator > c.M * L.numerator)
      throw Refused("chain: it is not closed at " + class_name(j));
    sum += q;
  }
  if (sum != certificate.particles)
    throw Refused("chain: the sum of the least counts is not N");
}

/// M particles do not fit at any scale up to z (Theorem 7): the most that are possible, h_j with h_j^b A_j <
/// z, are fewer.
void verify_above(const Problem &problem, const mpz_class &M) {
  const Ratio &z = problem.above;
  mpz_class sum = 0;
  for (std::size_t j = 0; j < problem.classes.size(); ++j) {
    const Class &c = problem.classes[j];
    if (!c.has_mass)
      continue;
    if (c.f == 0)
      throw Refused("above: " + class_name(j) + " holds any number of particles, at each scale");
    mpz_class quotient = z.numerator * c.M;
    const mpz_class divisor = z.denominator * c.f;
    mpz_cdiv_q(quotient.get_mpz_t(), quotient.get_mpz_t(), divisor.get_mpz_t());
    sum += integer_root(quotient - 1, problem.b);
  }
  if (sum >= M)
    throw Refused("above: M particles fit at the scale z or below it");
}

} // namespace

void verify(const Problem &problem, const Certificate &certificate) {
  if (certificate.question.pi_high > 0)
    verify_pi(certificate.question.pi_low, certificate.question.pi_high);
  verify_witness(problem, certificate);
  if (certificate.chain)
    verify_chain(problem, certificate);
  if (certificate.above)
    verify_above(problem, *certificate.question.at_least);
}

} // namespace mdm_check
