#include <mdm/number/common_denominator.hpp>

namespace mdm {

CommonDenominator::CommonDenominator(const std::vector<Rational> &fractions) : numerators(fractions.size()) {
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
