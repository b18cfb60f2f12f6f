// Real numbers are enclosed and rounded with certain digits, whether or not they are decimals.

#include "catch.hpp"
#include "number/real.hpp"

#include <mdm/number/decimal.hpp>

#include <mpfr.h>

#include <array>
#include <random>

namespace real_test {

using namespace mdm;

namespace {

/// A root that does not know whether it is a fraction.
Real root(const Rational &r, unsigned degree) {
  return Real([=](unsigned bits) { return pow(Ball(r, bits), ratio(1, degree)); });
}

/// A root that knows.
Real wise_root(const Rational &r, unsigned degree) {
  return Real([=](unsigned bits) { return pow(Ball(r, bits), ratio(1, degree)); },
              [=] { return exact_root(r, degree); });
}

std::string text(const Enclosure &e) {
  return e.lower_text() + " " + e.upper_text();
}

} // namespace

TEST_CASE("enclosures of irrational numbers are one unit wide", "[real]") {
  CHECK(text(enclose(root(2, 2), 5)) == "1.4142 1.4143");
  CHECK(text(enclose(root(2, 2), 1)) == "1 2");
  CHECK(text(enclose(root(2000000, 2), 2)) == "1414 1415");
  CHECK(text(enclose(root(ratio(2, 1000000), 2), 3)) == "0.00141 0.00142");
  CHECK(text(enclose(Real(0) - root(2, 2), 3)) == "-1.42 -1.41");
}

TEST_CASE("enclosures of many digits agree with roots in integers", "[real]") {
  std::mt19937_64 random(4);
  for (unsigned i = 0; i < 200; ++i) {
    const Integer n = 2 + random() % 1000000, d = 1 + random() % 1000000;
    const unsigned degree = 2 + i % 4, digits = 1 + i;
    const Enclosure expected = enclose_root(n, d, degree, digits),
                    e = enclose(wise_root(ratio(n, d), degree), digits);
    CHECK(e.lower() == expected.lower());
    CHECK(e.upper() == expected.upper());
  }
}

TEST_CASE("a decimal is its own enclosure, as far as that is known", "[real]") {
  CHECK(text(enclose(Real(ratio(1, 4)), 15)) == "0.25 0.25");
  CHECK(text(enclose(Real(ratio(123456789, 100000)), 3)) == "1234.56789 1234.56789");
  CHECK(text(enclose(Real(0), 3)) == "0 0");
  CHECK(text(enclose(Real(ratio(1, 3)), 4)) == "0.3333 0.3334");
  CHECK(text(enclose(Real(ratio(-1, 3)), 4)) == "-0.3334 -0.3333");
  CHECK(text(enclose(wise_root(ratio(9, 100), 2), 4)) == "0.3 0.3");
  CHECK(text(enclose(wise_root(4, 2), 4)) == "2 2");
  // Nobody tells that this root is 0.3: all bits leave both sides open.
  CHECK(text(enclose(root(ratio(9, 100), 2), 4)) == "0.2999 0.3001");
}

TEST_CASE("rounding is to the nearest, with halves away from 0", "[real]") {
  CHECK(rounded(root(2, 2), 4) == "1.414");
  CHECK(rounded(root(3, 2), 3) == "1.73");
  CHECK(rounded(root(3, 2), 2) == "1.7");
  CHECK(rounded(Real(ratio(12345, 1000)), 4) == "12.35");
  CHECK(rounded(Real(ratio(-12345, 1000)), 4) == "-12.35");
  CHECK(rounded(Real(ratio(12344999, 1000000)), 4) == "12.34");
  CHECK(rounded(wise_root(ratio(12345 * 12345, 1000000), 2), 4) == "12.35");
  CHECK(rounded(Real(ratio(99996, 10000)), 4) == "10.00");
  CHECK(rounded(Real(ratio(99996, 1)), 4) == "99996");
  CHECK(rounded(Real(ratio(2, 3)), 4) == "0.6667");
  CHECK(rounded(Real(0) - root(2, 2), 3) == "-1.41");
}

TEST_CASE("zeros at the end say that there are further digits", "[real]") {
  CHECK(rounded(Real(ratio(3, 10)), 4) == "0.3");
  CHECK(rounded(wise_root(ratio(9, 100), 2), 4) == "0.3");
  CHECK(rounded(Real(ratio(30001, 100000)), 4) == "0.3000");
  CHECK(rounded(Real(ratio(29999, 100000)), 4) == "0.3000");
  CHECK(rounded(Real(100), 1) == "100");
  CHECK(rounded(Real(0), 4) == "0");
}

TEST_CASE("very small and very large numbers have an exponent", "[real]") {
  CHECK(rounded(Real(Rational(power_of_ten(14))), 4) == "100000000000000");
  CHECK(rounded(Real(Rational(power_of_ten(15) - 1)), 4) == "999999999999999");
  CHECK(rounded(Real(Rational(power_of_ten(15))), 4) == "1e15");
  CHECK(rounded(Real(Rational(power_of_ten(20) - 1)), 4) == "1.000e20");
  CHECK(rounded(Real(Rational(Integer(125) * power_of_ten(15))), 4) == "1.25e17");
  CHECK(rounded(root(Rational(2 * power_of_ten(40)), 2), 4) == "1.414e20");
  CHECK(rounded(Real(Rational(Integer(123456789) * power_of_ten(10))), 20) == "1234567890000000000");
  CHECK(rounded(Real(Rational(-power_of_ten(20))), 2) == "-1e20");
  CHECK(rounded(Real(ratio(1, 1000000)), 4) == "0.000001");
  CHECK(rounded(Real(ratio(1, 10000000)), 4) == "1e-7");
  CHECK(rounded(root(ratio(2, power(Integer(10), 20)), 2), 4) == "1.414e-10");
}

TEST_CASE("a half that nobody knows of has one digit less", "[real]") {
  CHECK(rounded(root(ratio(12345 * 12345, 1000000), 2), 4) == "12.3");
}

TEST_CASE("rounded digits agree with MPFR", "[real]") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 200; ++i) {
    const long n = static_cast<long>(2 + random() % 100000);
    mpfr_t y;
    mpfr_init2(y, 400);
    mpfr_set_si(y, n, MPFR_RNDN);
    mpfr_log(y, y, MPFR_RNDN);
    std::array<char, 100> digits{};
    mpfr_snprintf(digits.data(), digits.size(), "%.30Rf", y);
    mpfr_clear(y);
    const Real log_n([n](unsigned bits) { return log(Ball(n, bits)); });
    const unsigned before = n < 3 ? 0 : n < 22027 ? 1 : 2; // digits before the point; e^10 = 22026.5
    CHECK(rounded(log_n, 30 + before) == digits.data());
  }
}

TEST_CASE("comparisons are decided by digits or by exact values", "[real]") {
  CHECK(compare(root(2, 2), Real(ratio(14142, 10000))) == Order::greater);
  CHECK(compare(root(2, 2), Real(ratio(14143, 10000))) == Order::less);
  CHECK(compare(wise_root(4, 2), Real(2)) == Order::equal);
  CHECK(compare(Real(ratio(1, 3)) + Real(ratio(2, 3)), Real(1)) == Order::equal);
  CHECK(compare(wise_root(ratio(1, 9), 2) * 3, Real(1)) == Order::equal);
  // 1000 digits away from each other
  const Rational tiny = ratio(1, power_of_ten(1000));
  CHECK(compare(wise_root(2, 2), wise_root(2, 2) + Real(tiny)) == Order::less);
  // Two ways to the same irrational number, and a difference beyond all bits.
  CHECK(compare(wise_root(8, 2), wise_root(2, 2) * 2) == Order::undecided);
  CHECK(compare(wise_root(2, 2), wise_root(2, 2) + Real(ratio(1, power_of_ten(2000)))) == Order::undecided);
}

} // namespace real_test
