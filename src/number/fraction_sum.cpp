#include "number/fraction_sum.hpp"

namespace mdm {

void FractionSum::add(const Integer &n, const Integer &d) {
  const mpz_ptr sum = numerator_.backend().data();
  const mpz_ptr common = denominator_.backend().data();
  const mpz_srcptr own = d.backend().data();
  Integer factor;
  const mpz_ptr f = factor.backend().data();
  if (mpz_divisible_p(common, own) == 0) {
    mpz_lcm(f, common, own);
    mpz_divexact(common, f, common); // by how much the denominator grows
    mpz_mul(sum, sum, common);
    mpz_swap(common, f);
  }
  mpz_divexact(f, common, own);
  mpz_addmul(sum, n.backend().data(), f);
}

} // namespace mdm
