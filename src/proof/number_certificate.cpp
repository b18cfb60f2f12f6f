#include "proof/number_certificate.hpp"

#include <mdm/number/decimal.hpp>

namespace mdm {

std::string number_certificate(const NumberMatch &m, const std::vector<AskedTolerance> &asked) {
  using Kind = AskedTolerance::Kind;
  std::string text = "mdm-certificate number 1\n";
  for (const AskedTolerance &a : asked)
    text += (a.kind == Kind::retained  ? "retained "
             : a.kind == Kind::passing ? "passing "
                                       : "total ") +
            to_decimal(a.percent) + "\n";
  if (m.is_smallest()) {
    text += "particles " + to_string(m.particles) + "\nquantities";
    for (const Integer &q : m.quantities)
      text += " " + to_string(q);
  } else {
    text += "bound " + to_string(m.lower_bound);
  }
  return text + "\nend\n";
}

} // namespace mdm
