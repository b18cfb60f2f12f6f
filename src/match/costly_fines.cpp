#include "match/costly_fines.hpp"

namespace mdm {

std::optional<CostlyFines> costly_fines(const Match &m) {
  if (!m.has_answer())
    return std::nullopt;
  const Integer all = *m.particles();
  const std::vector<Rational> masses = m.sample->shares ? *m.sample->shares : shares(m.gradation);
  Integer particles = 0;
  Rational mass = 0;
  for (std::size_t j = 0; j < masses.size(); ++j) {
    particles += m.sample->quantities[j];
    mass += masses[j];
    if (mass * 100 > 5)
      return std::nullopt;
    if (particles * 10 >= all * 9)
      return CostlyFines{m.gradation.opening(j + 1), ratio(particles, all), mass};
  }
  return std::nullopt;
}

} // namespace mdm
