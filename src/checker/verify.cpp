#include "verify.hpp"

#include "law.hpp"

#include <algorithm>

namespace mdm::checker {

void demand(bool holds, const char *condition, std::uint64_t j) {
  if (!holds)
    throw Refused(std::string(condition) + " fails" + (j > 0 ? " at class " + std::to_string(j) : ""));
}

void demand_within(std::uint64_t work, unsigned most, const Certificate &certificate) {
  demand_form(
      work <= std::uint64_t{1} << most, certificate.law[0].text,
      "numbers as long as these, or so many, take too long: use a simpler law, fewer digits or steps");
}

std::uint64_t work_of(const Gradation &gradation, const Certificate &certificate, std::uint64_t n) {
  const std::uint64_t bands = certificate.band.size() / 3 + gradation.limits.size();
  std::uint64_t steps = 64 * (n + bands) + (certificate.chain ? certificate.chain->size() : 0);
  for (const TreeNode &node : certificate.tree) {
    steps += node.kind == TreeNode::window ? 64 * (gradation.openings.size() - 1) : 1;
    for (const Multiple &multiple : node.multiples)
      steps += multiple.terms();
  }
  return steps;
}

mpq_class to_power(const mpq_class &length, unsigned long d, const Certificate &certificate) {
  demand_within(bits(length) * d, 20, certificate);
  return raised(length, d);
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
  demand_within(bits(common), 20, certificate);
}

mpz_class integer_of(const Numbers &line) {
  return line.empty() ? mpz_class(0) : line[0].value.get_num();
}

std::optional<mpq_class> rational_root(const mpq_class &value, unsigned long degree) {
  mpz_class numerator, denominator;
  const bool exact = mpz_root(numerator.get_mpz_t(), value.get_num_mpz_t(), degree) != 0 &&
                     mpz_root(denominator.get_mpz_t(), value.get_den_mpz_t(), degree) != 0;
  return exact ? std::optional<mpq_class>(mpq_class(numerator, denominator)) : std::nullopt;
}

namespace {

/// The unit of the 15th significant digit of a decimal.
mpq_class unit_of_15_digits(const Number &number) {
  const Decimal d = split_decimal(number.text);
  const auto digits_before = [](std::string_view digits, const char *set) {
    return static_cast<long>(std::min(digits.find_first_not_of(set), digits.size()));
  };
  return ten_to((d.whole == "0" ? -digits_before(d.fraction, "0") : digits_before(d.whole, "0123456789")) -
                15);
}

/// The opening that S is, or that S is the nearest decimal to, where S has at most 15 digits and the opening
/// is irrational.
Rationals::iterator find_opening(Gradation &gradation, const Certificate &certificate) {
  const Number &S = certificate.cut_below[0];
  const unsigned long d = gradation.root;
  const mpq_class unit = unit_of_15_digits(S), exact = to_power(S.value, d, certificate);
  const bool may_be_near = d > 1 && mpq_class(S.value / unit).get_den() == 1;
  const mpq_class below = may_be_near ? raised(S.value - unit / 2, d) : exact;
  const mpq_class above = may_be_near ? raised(S.value + unit / 2, d) : exact;
  return std::find_if(gradation.openings.begin(), gradation.openings.end(), [&](const mpq_class &Y) {
    return Y == exact || (below < Y && Y < above && !rational_root(Y, d));
  });
}

} // namespace

void apply_question(Gradation &gradation, const Certificate &certificate) {
  demand(gradation.limits.empty() == certificate.band_file.empty(),
         "band file: there with the file of a band, and only there");
  demand(gradation.materials.empty() || (certificate.pan_size.empty() && certificate.cut_below.empty()),
         "materials: without pan-size and cut-below");
  Rationals &x = gradation.openings;
  const unsigned long d = gradation.root;
  const auto columns = {&gradation.masses, &gradation.factors, &gradation.tolerances, &gradation.openings};
  if (!certificate.pan_size.empty()) {
    const mpq_class size = to_power(certificate.pan_size[0].value, d, certificate);
    demand(x[0] == 0 && size < x[1], "pan-size: x_1 = 0, P < x_2");
    x[0] = size;
  }
  if (!certificate.cut_below.empty()) {
    const auto cut = std::min(find_opening(gradation, certificate), x.end() - 1);
    demand(cut != x.end() - 1, "cut-below: S is an opening below x_n");
    const auto dropped = cut - x.begin();
    for (Rationals *column : columns)
      column->erase(column->begin(), column->begin() + (column->empty() ? 0 : dropped));
    demand(*std::max_element(gradation.masses.begin(), gradation.masses.end()) > 0,
           "cut-below: mass is left");
  }
  const std::uint64_t e = certificate.law_work * d;
  std::uint64_t count = certificate.longest_count, longest = 0;
  for (const auto &[opening, least, most] : gradation.limits)
    count = std::max({count, bits(opening), bits(least), bits(most)});
  // The limits 1 and 2 bound time and memory before the first power is computed.
  const auto include_length = [&](std::uint64_t length) {
    longest = std::max(longest, length);
    demand_within(e * std::max(longest, count), 20, certificate);
  };
  const mpq_class factor = certificate.size_factor.empty()
                               ? mpq_class(1)
                               : to_power(certificate.size_factor[0].value, d, certificate);
  for (mpq_class &opening : x) {
    opening *= factor;
    include_length((bits(opening) + d - 1) / d);
  }
  for (const Rationals *column : {&gradation.masses, &gradation.factors, &gradation.tolerances})
    for (const mpq_class &value : *column)
      include_length(bits(value));
  demand_within(work_of(gradation, certificate, x.size()) * e * (longest + count), 34, certificate);
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

/// By Machin: pi = 16 arctan(1/5) - 4 arctan(1/239), with fewer than 800 and 240 terms. p and r have at most
/// 1000 digits after the point; nowhere there has pi 90 digits 0 or 9 in a row, so that the unit decides each
/// comparison.
void verify_pi(const Certificate &certificate) {
  if (certificate.pi.empty())
    return;
  const mpz_class unit = power(10, 1100);
  // Each term is a floor and the rest of the series is below 1: k terms are off by less than k + 1.
  const auto arctangent_of_one_over = [&](unsigned long m) {
    mpz_class sum = 0;
    mpz_class odd_power = unit / m;
    for (unsigned long n = 1; odd_power > 0; n += 2, odd_power /= m * m)
      sum += n % 4 == 1 ? mpz_class(odd_power / n) : mpz_class(-(odd_power / n));
    return sum;
  };
  const mpz_class pi = 16 * arctangent_of_one_over(5) - 4 * arctangent_of_one_over(239);
  const mpz_class error = 16 * 800 + 4 * 240;
  demand(certificate.pi[0].value * unit <= pi - error, "p < pi");
  demand(certificate.pi[1].value * unit >= pi + error, "pi < r");
}

void verify_size(const Gradation &gradation, const Certificate &certificate, const ClassWitness &witness,
                 const Ratio &T, unsigned long degree) {
  const std::uint64_t j = witness.index;
  const mpq_class &lo = witness.lo, &hi = witness.hi;
  demand(gradation.openings[j - 1] < raised(lo, gradation.root), "x_j < lo", j);
  demand(raised(hi, gradation.root) <= gradation.openings[j], "hi <= x_{j+1}", j);
  demand(1'000'000'000 * (hi - lo) <= lo, "10^9 (hi - lo) <= lo", j);
  if (is_power(certificate)) {
    demand(compare(raised(lo, degree), T) <= 0, "lo^a <= T", j);
    demand(compare(T, raised(hi, degree)) < (lo == hi ? 1 : 0), lo == hi ? "T = hi^a" : "T < hi^a", j);
    return;
  }
  demand(compare(value_of_law(certificate, lo), T) <= 0, "f(lo) <= T", j);
  demand(compare(T, value_of_law(certificate, hi)) < (lo == hi ? 1 : 0), lo == hi ? "T = f(hi)" : "T < f(hi)",
         j);
}

} // namespace mdm::checker
