#include "check.hpp"

#include "certificate.hpp"
#include "gradation.hpp"

#include <algorithm>

namespace mdm_check {
namespace {

using Rationals = std::vector<mpq_class>;

/// A fraction without sign, not in lowest terms, so that no loop pays for a gcd.
struct Ratio {
  mpz_class numerator = 0, denominator = 1;
};

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

/// Refuses the certificate where a condition does not hold, in class j (from 1) if that is given.
void demand(bool holds, const char *condition, std::uint64_t j = 0) {
  if (!holds)
    throw Refused(std::string(condition) + " fails" + (j > 0 ? " at class " + std::to_string(j) : ""));
}

/// Applies pan-size, cut-below and size-factor, in this order.
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
    for (Rationals *column : {&gradation.openings, &gradation.masses, &gradation.factors})
      column->erase(column->begin(), column->begin() + dropped);
    demand(*std::max_element(gradation.masses.begin(), gradation.masses.end()) > 0,
           "cut-below: mass is left");
  }
  if (!certificate.size_factor.empty())
    for (mpq_class &opening : x)
      opening *= certificate.size_factor[0].value;
}

std::uint64_t bits(const mpq_class &value) {
  return std::max(mpz_sizeinbase(value.get_num_mpz_t(), 2), mpz_sizeinbase(value.get_den_mpz_t(), 2));
}

void demand_within(std::uint64_t work, std::uint64_t most, const Certificate &certificate) {
  demand_form(
      work <= most, certificate.law[0].text,
      "numbers as long as these, or so many, take too long: use a simpler law, fewer digits or steps");
}

/// The limits 1 and 2 of section 2: bounds time and memory before the first power is computed.
void demand_small(const Gradation &gradation, const Certificate &certificate) {
  std::uint64_t longest = 0;
  for (const Rationals *column : {&gradation.openings, &gradation.masses, &gradation.factors})
    for (const mpq_class &value : *column)
      longest = std::max(longest, bits(value));
  std::uint64_t longest_count = 0;
  for (const Numbers *line : {&certificate.min_per_class, &certificate.at_least, &certificate.particles})
    for (const Number &number : *line)
      longest_count = std::max(longest_count, bits(number.value));
  for (const ClassWitness &witness : certificate.classes)
    longest_count = std::max({longest_count, bits(witness.quantity), bits(witness.lo), bits(witness.hi)});
  const mpq_class &law = certificate.law[0].value;
  const std::uint64_t exponent = mpz_class(std::max(law.get_num(), law.get_den())).get_ui();
  const std::uint64_t steps = certificate.chain ? certificate.chain->size() : 0;
  demand_within(exponent * std::max(longest, longest_count), limit::power_bits, certificate);
  demand_within((64 * gradation.openings.size() + steps) * exponent * (longest + longest_count),
                limit::work_of_steps, certificate);
}

mpz_class common_denominator(const Rationals &values) {
  mpz_class common = 1;
  for (const mpq_class &value : values)
    common = lcm(common, value.get_den());
  return common;
}

/// value * unit, an integer.
mpz_class in_units(const mpq_class &value, const mpz_class &unit) {
  return value.get_num() * mpz_class(unit / value.get_den());
}

/// W, the sum of m_j / c_j, in the units of M and C; with the sphere's law these are no powers. Factors of
/// many digits would make the common denominator grow with the classes: limit 4.
mpq_class solids_of_unit_scale(const std::vector<Class> &classes, const Certificate &certificate) {
  mpz_class common = 1;
  for (const Class &c : classes)
    if (!mpz_divisible_p(common.get_mpz_t(), c.C.get_mpz_t())) {
      common = lcm(common, c.C);
      demand_within(bits(common), limit::power_bits, certificate);
    }
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
  const Numbers &cylinder = certificate.cylinder, &box = certificate.box, &pi = certificate.pi;
  if (cylinder.empty() && pi.empty())
    return {0, 1};
  mpq_class volume; // over pi for a cylinder
  if (!cylinder.empty())
    volume = cylinder[0].value * cylinder[0].value * cylinder[1].value / (4 * (1 + cylinder[2].value));
  else if (!box.empty())
    volume = box[0].value * box[1].value * box[2].value / (1 + box[3].value);
  else
    volume = certificate.solids_volume[0].value;
  const mpq_class scale =
      6 * volume * power(problem.opening_unit, 3) / solids_of_unit_scale(problem.classes, certificate);
  const auto over = [&](const mpq_class &divisor) {
    const mpq_class value = scale / divisor;
    return Ratio{value.get_num(), value.get_den()};
  };
  problem.least_scale = over(pi.empty() ? mpq_class(1) : pi[0].value);
  return pi.empty() ? Ratio{0, 1} : over(pi[1].value); // every match has a larger scale, because r > pi
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
  demand_small(gradation, certificate);

  Problem problem;
  const unsigned long a = problem.a = certificate.law[0].value.get_num().get_ui();
  const unsigned long b = problem.b = certificate.law[0].value.get_den().get_ui();
  problem.R = certificate.min_per_class.empty() ? mpq_class(0) : certificate.min_per_class[0].value;
  problem.M = certificate.at_least.empty() ? mpq_class(0) : certificate.at_least[0].value;
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

/// p < pi < r by Machin: pi = 16 arctan(1/5) - 4 arctan(1/239), with fewer than 800 and 240 terms. p and r
/// have at most 1000 digits after the point; nowhere there has pi 90 digits 0 or 9 in a row, so that the unit
/// decides each comparison.
void verify_pi(const mpq_class &p, const mpq_class &r) {
  const mpz_class unit = power(10, 1100);
  const mpz_class pi = 16 * arctangent(5, unit) - 4 * arctangent(239, unit);
  const mpz_class error = 16 * 800 + 4 * 240;
  demand(p * unit <= pi - error, "p < pi");
  demand(r * unit >= pi + error, "pi < r");
}

void verify_class(const Problem &problem, const Class &c, const ClassWitness &witness) {
  const std::uint64_t j = c.j;
  const mpz_class &q = witness.quantity;
  const mpq_class &lo = witness.lo, &hi = witness.hi;
  const mpz_class particles = power(q, problem.b) * problem.scale.denominator;
  const mpz_class scaled_mass = problem.scale.numerator * c.M;
  demand(witness.index == j, "witness: one line a class with mass", j);
  demand(q >= problem.R, "q >= R", j);
  demand(particles * c.f < scaled_mass, "q^b A < S", j);
  demand(scaled_mass <= particles * c.F, "S <= q^b B", j);
  demand(problem.openings[j - 1] < lo, "x_j < lo", j);
  demand(hi <= problem.openings[j], "hi <= x_{j+1}", j);
  demand(1'000'000'000 * (hi - lo) <= lo, "10^9 (hi - lo) <= lo", j);
  // size^a <=> T, both times the opening unit to the power a and the denominators.
  const auto compare = [&](const mpq_class &size) {
    const mpz_class left = power(size.get_num() * problem.opening_unit, problem.a) * particles * c.C;
    const mpz_class right = scaled_mass * power(size.get_den(), problem.a);
    return cmp(left, right);
  };
  if (lo == hi) {
    demand(compare(lo) == 0, "lo^a = T", j);
  } else {
    demand(compare(lo) <= 0, "lo^a <= T", j);
    demand(compare(hi) > 0, "T < hi^a", j);
  }
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

/// Verifies the claim (section 3). Throws Refused at the first thing that fails.
void verify(const Problem &problem, const Certificate &certificate) {
  const mpz_class &N = certificate.particles[0].value.get_num();
  if (!certificate.pi.empty())
    verify_pi(certificate.pi[0].value, certificate.pi[1].value);
  verify_witness(problem, certificate, N);
  if (certificate.chain)
    verify_chain(problem, *certificate.chain, N);
  if (!certificate.above.empty())
    verify_above(problem);
}

/// The verdict repeats the question: its reader sees what was proved.
std::string accepted(const Certificate &certificate, const std::string &file) {
  std::string text;
  const auto say = [&](std::string_view words, const Numbers &numbers) {
    auto number = numbers.begin();
    for (const char c : numbers.empty() ? std::string_view() : words)
      text += c == '#' ? std::string((number++)->text) : std::string{c};
  };
  say("accepted: N = # is the least number of particles", certificate.particles);
  say(" from # up", certificate.at_least);
  text += " that matches " + printable(file) + " exactly (";
  say(certificate.law[0].value.get_den() == 1 ? "law x^#" : "law x^(#)", certificate.law);
  say("; at least # particles in each class", certificate.min_per_class);
  say("; solids of the cylinder # x # at void ratio #", certificate.cylinder);
  say("; solids of the box # x # x # at void ratio #", certificate.box);
  say("; solids of at least the volume #", certificate.solids_volume);
  say("; openings multiplied by #", certificate.size_factor);
  say("; classes below # left out", certificate.cut_below);
  say("; pan counted as size #", certificate.pan_size);
  return text + ")";
}

} // namespace

Verdict check(const Input &gradation_file, const Input &certificate_file) {
  const Input *reading = &gradation_file;
  try {
    Gradation gradation = read_gradation(gradation_file.text);
    reading = &certificate_file;
    const Certificate certificate = read_certificate(certificate_file.text);
    verify(derive(std::move(gradation), certificate), certificate);
    return {Verdict::accepted, accepted(certificate, gradation_file.name)};
  } catch (const Refused &reason) {
    return {Verdict::refused, std::string("refused: ") + reason.what()};
  } catch (const Malformed &error) {
    const auto line = 1 + std::count(reading->text.data(), error.at, '\n');
    return {Verdict::malformed, printable(reading->name) + ":" + std::to_string(line) + ": " + error.what()};
  }
}

} // namespace mdm_check
