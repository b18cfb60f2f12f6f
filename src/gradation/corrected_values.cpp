#include "gradation/corrected_values.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace mdm {

bool are_corrected_masses(const std::vector<Rational> &masses, const std::vector<Rational> &others) {
  assert(masses.size() == others.size());
  std::size_t same = 0, different = 0, sums = 0;
  Rational down = 0, up = std::accumulate(masses.begin(), masses.end(), Rational(0));
  for (std::size_t i = 0; i < masses.size(); ++i) {
    down += masses[i];
    same += masses[i] != 0 && others[i] == masses[i] ? 1U : 0U;
    different += others[i] != masses[i] ? 1U : 0U;
    sums += others[i] == down || others[i] == up ? 1U : 0U;
    up -= masses[i];
  }
  return same > 0 && different > 0 && sums < masses.size();
}

bool are_corrected_percents(const std::vector<Rational> &sizes, const std::vector<Rational> &percents,
                            const std::vector<Rational> &others) {
  assert(!sizes.empty() && sizes.size() == percents.size() && sizes.size() == others.size());
  std::vector<std::size_t> from_coarsest(sizes.size());
  std::iota(from_coarsest.begin(), from_coarsest.end(), std::size_t{0});
  std::sort(from_coarsest.begin(), from_coarsest.end(),
            [&sizes](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  const auto is_same = [&](std::size_t i) { return others[i] == percents[i]; };
  const auto first_other = std::find_if_not(from_coarsest.begin(), from_coarsest.end(), is_same);
  const Rational &all = percents[from_coarsest.front()];
  return first_other != from_coarsest.end() && std::none_of(first_other, from_coarsest.end(), is_same) &&
         std::any_of(from_coarsest.begin(), first_other,
                     [&](std::size_t i) { return percents[i] != 0 && percents[i] != all; });
}

} // namespace mdm
