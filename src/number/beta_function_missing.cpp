// Where there is no Arb, there are no beta functions.

#include "number/ball.hpp"

#include <mdm/text/error.hpp>

namespace mdm {
namespace {

[[noreturn]] void refuse_beta() {
  throw InputError("this program was built without Arb, which computes beta distributions: use mdm of the "
                   "command line");
}

} // namespace

Ball incomplete_beta(const Ball &, const Rational &, const Rational &) {
  refuse_beta();
}

Ball beta_function(const Rational &, const Rational &, unsigned) {
  refuse_beta();
}

} // namespace mdm
