#include <mdm/match/sizes.hpp>

#include <algorithm>

namespace mdm {

std::vector<Enclosure> enclose_sizes(const Gradation &g, const Problem &problem, const std::vector<Integer> &q,
                                     const Rational &scale, unsigned digits) {
  const MassLaw &law = problem.law();
  std::vector<Enclosure> sizes;
  sizes.reserve(q.size());
  for (std::size_t j = 0; j < q.size(); ++j) {
    const ProblemClass &c = problem.classes()[j];
    Rational powered = scale * c.mass / Rational(power(q[j], law.b));
    if (g.has_factors())
      powered /= power(g.factor(c.index), law.b);
    const auto inside = [&](const Enclosure &x) {
      return g.lower(c.index) < x.lower() && x.upper() <= g.upper(c.index);
    };
    Enclosure x = enclose_root(powered, law.a, digits);
    for (unsigned more = 2 * digits; !inside(x); more *= 2)
      x = enclose_root(powered, law.a, more);
    sizes.push_back(std::move(x));
  }
  return sizes;
}

Rational size_margin(const MassLaw &law, const Rational &above, const Rational &up_to, const Rational &scale) {
  Rational closest = up_to / scale;
  if (above > 0)
    closest = std::min(closest, Rational(scale / above));
  if (closest == 1)
    return 0;
  for (unsigned digits = 6;; digits *= 2) {
    const Enclosure root = enclose_root(closest, law.a, digits);
    const Integer excess = root.lo - power_of_ten(root.places);
    if (root.lo == root.hi || excess >= 1000)
      return ratio(excess, power_of_ten(root.places));
  }
}

} // namespace mdm
