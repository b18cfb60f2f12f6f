#include "number/common_denominator.hpp"

#include <numeric>

namespace mdm {
namespace {

/// The least common denominator, if it and all that lead to it are machine words.
std::optional<unsigned long> short_denominator(const std::vector<Rational> &fractions) {
  unsigned long common = 1;
  for (const Rational &r : fractions) {
    const mpz_srcptr d = mpq_denref(r.backend().data());
    if (mpz_fits_ulong_p(d) == 0)
      return std::nullopt;
    const unsigned long own = mpz_get_ui(d);
    if (common % own != 0 && __builtin_mul_overflow(common, own / std::gcd(common, own), &common))
      return std::nullopt;
  }
  return common;
}

} // namespace

CommonDenominator::CommonDenominator(const std::vector<Rational> &fractions) : numerators(fractions.size()) {
  if (const std::optional<unsigned long> common = short_denominator(fractions)) {
    denominator = *common;
    for (std::size_t i = 0; i < fractions.size(); ++i) {
      const mpq_srcptr r = fractions[i].backend().data();
      mpz_mul_ui(numerators[i].backend().data(), mpq_numref(r), *common / mpz_get_ui(mpq_denref(r)));
    }
    return;
  }
  const mpz_ptr common = denominator.backend().data();
  for (const Rational &r : fractions)
    if (mpz_divisible_p(common, mpq_denref(r.backend().data())) == 0)
      mpz_lcm(common, common, mpq_denref(r.backend().data()));
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    const mpz_ptr n = numerators[i].backend().data();
    mpz_divexact(n, common, mpq_denref(fractions[i].backend().data()));
    mpz_mul(n, n, mpq_numref(fractions[i].backend().data()));
  }
}

Rational sum(const std::vector<Rational> &fractions) {
  const CommonDenominator common(fractions);
  Integer n = 0;
  for (const Integer &numerator : common.numerators)
    n += numerator;
  return ratio(n, common.denominator);
}

} // namespace mdm
