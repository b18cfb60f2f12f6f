// From a mass to the size that has it. A power is a root, and so is a sum of one power; on a segment of a
// table the size is a fraction. For a sum of several powers floor(10^places x) is found by bisection: the
// sign of f(y) - T at a decimal y is exact, and f increases.

#include "gradation/law_inverse.hpp"

#include "number/decimal_exponent.hpp"

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

/// The size of mass T in the table.
Rational size_in_table(const std::vector<LawNode> &table, const Rational &T) {
  const auto node =
      std::partition_point(table.begin(), table.end(), [&T](const LawNode &n) { return n.mass < T; });
  assert(node != table.end());
  const LawNode before = node == table.begin() ? LawNode{0, 0} : *(node - 1);
  return before.size + (T - before.mass) * (node->size - before.size) / (node->mass - before.mass);
}

/// The e with f(10^e) <= T < f(10^(e+1)).
int leading_place(const MassLaw &law, const Rational &T) {
  int e = 0;
  while (law.powered(ten_to(e)) > T)
    --e;
  while (law.powered(ten_to(e + 1)) <= T)
    ++e;
  return e;
}

Enclosure bisected(const MassLaw &law, const Rational &T, unsigned digits) {
  const int e = leading_place(law, T), wanted = static_cast<int>(digits) - 1 - e;
  unsigned places = wanted > 0 ? static_cast<unsigned>(wanted) : 0;
  const auto value = [&](const Integer &y) { return law.powered(ratio(y, power_of_ten(places))); };
  Integer lo = power_of_ten(static_cast<unsigned>(e + static_cast<int>(places)));
  Integer above = lo * 10; // value(lo) <= T < value(above)
  while (above - lo > 1) {
    Integer middle = floor_div(lo + above, 2);
    (value(middle) <= T ? lo : above) = std::move(middle);
  }
  if (value(lo) != T)
    return {lo, above, places};
  for (; places > 0 && lo % 10 == 0; --places)
    lo /= 10;
  return {lo, lo, places};
}

} // namespace

Enclosure enclose_inverse(const MassLaw &law, const Integer &n, const Integer &d, unsigned degree,
                          unsigned digits) {
  if (law.is_power())
    return enclose_root(n, d, degree, digits);
  const Rational T = ratio(n, d);
  if (law.sum.size() > 1)
    return bisected(law, T, digits);
  const Rational x = law.sum.empty() ? size_in_table(law.table, T) : T / law.sum.front().coefficient;
  return enclose_root(numerator(x), denominator(x), law.sum.empty() ? 1 : law.sum.front().exponent, digits);
}

} // namespace mdm
