#include "gradation/phi.hpp"
#include "support.hpp"

#include <mpfr.h>

namespace phi_test {

using namespace mdm;
using namespace mdm::test;

namespace {

Rational phi(const std::string &text) {
  return phi_size(parse_decimal(text));
}

/// 2^-phi to 15 digits by MPFR, with so many bits that the rounding is that of the real number in these
/// tests.
Rational second_computation(const Rational &x) {
  mpfr_t y;
  mpfr_init2(y, 6000);
  mpfr_set_q(y, x.backend().data(), MPFR_RNDN);
  mpfr_neg(y, y, MPFR_RNDN);
  mpfr_exp2(y, y, MPFR_RNDN);
  char digits[32];
  mpfr_exp_t exponent = 0;
  mpfr_get_str(digits, &exponent, 10, 15, y, MPFR_RNDN);
  mpfr_clear(y);
  const long places = 15 - exponent;
  const Rational mantissa{Integer(std::string(digits))};
  const Rational scale(power_of_ten(static_cast<unsigned>(std::abs(places))));
  return places >= 0 ? Rational(mantissa / scale) : Rational(mantissa * scale);
}

} // namespace

TEST_CASE("phi: integers are exact") {
  CHECK(phi("0") == 1);
  CHECK(phi("2.0") == ratio(1, 4));
  CHECK(phi("-30e-1") == 8);
  CHECK(phi("1000") == ratio(1, power(Integer(2), 1000)));
  CHECK(phi("-1000") == Rational(power(Integer(2), 1000)));
}

TEST_CASE("phi: anything else is rounded to 15 significant digits") {
  CHECK(to_decimal(phi("0.5")) == "0.707106781186548");
  CHECK(to_decimal(phi("-0.5")) == "1.4142135623731"); // 1.41421356237310
  CHECK(to_decimal(phi("2.25")) == "0.210224103813429");
  CHECK(to_decimal(phi("1e-400")) == "1");
  CHECK(to_decimal(phi("-1e-400")) == "1");
}

TEST_CASE("phi: agrees with a second computation") {
  std::vector<std::string> texts = {"999.999",
                                    "-999.5",
                                    "0.1",
                                    "-0.1",
                                    "1e-3",
                                    "-1e-14",
                                    "1e-14",
                                    "1e-15",
                                    "1e-16",
                                    "-1e-16",
                                    "3.321928094887362",
                                    "-3.321928094887362",
                                    "3.3219280948873623478703194294",
                                    "-3.3219280948873623478703194294",
                                    "6.6438561897747246957406388589",
                                    "-49.828921423310435218054791442",
                                    "49.828921423310435218054791442"};
  for (int i = -500; i <= 500; i += 3)
    texts.push_back(std::to_string(i) + ".37");
  for (const std::string &t : texts) {
    INFO(t);
    CHECK(phi(t) == second_computation(parse_decimal(t)));
  }
}

TEST_CASE("phi: beyond 1000 is refused") {
  CHECK(message_of([] { phi("1000.5"); }) == "phi 1000.5 is beyond 1000: give the size in mm");
  CHECK(message_of([] { phi("-1e400"); }) == "phi -1.00000000000e400 is beyond 1000: give the size in mm");
}

} // namespace phi_test
