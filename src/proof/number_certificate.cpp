#include "proof/number_certificate.hpp"

#include <mdm/number/decimal.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace mdm {
namespace {

std::optional<Rational> least_percent(const std::vector<AskedTolerance> &asked, AskedTolerance::Kind kind) {
  std::optional<Rational> least;
  for (const AskedTolerance &a : asked)
    if (a.kind == kind)
      least = least ? std::min(*least, a.percent) : a.percent;
  return least;
}

} // namespace

std::string number_certificate(const NumberMatch &m, const std::vector<AskedTolerance> &asked) {
  using Kind = AskedTolerance::Kind;
  std::string text = "mdm-certificate number 1\n";
  // The format has each kind once, in this order: of several of a kind the least says all.
  for (const auto &[kind, word] : {std::pair(Kind::retained, "retained "),
                                   std::pair(Kind::passing, "passing "), std::pair(Kind::total, "total ")})
    if (const std::optional<Rational> percent = least_percent(asked, kind))
      text += word + to_decimal(*percent) + "\n";
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
