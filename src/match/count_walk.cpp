// Whole counts at a mass M, or in a window of it, by dynamic programming over the classes, from the finest
// on. A place is what can pass a sieve with so many particles below it: masses between two ends. From each
// place the next class goes on with the fewest particles that reach the sieve's band, and with some more. Of
// two places the one that has no fewer particles and lies inside the other is left out, as are those with
// many more particles than the fewest: coarse particles do not make up for so many fine ones. Backwards
// first, it is worked out what must pass a sieve at least, as whole particles of the coarser classes hold no
// more, and how many particles the coarser classes need at least.
//
// Particles grow with the class, so that counts whose sums from the finest class on are small are the ones
// that are looked for.

#include "match/count_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mdm {
namespace {

/// Masses are wrong by less, relative to all.
constexpr double mass_noise = 1e-15;
/// More particles than the fewest, and places, that are kept.
constexpr int most_more = 8;
constexpr std::size_t most_places = 24;

} // namespace

/// With `particles` in all classes so far, what passes is from `low` to `high`; `count` of them are in the
/// last class, the others at place number `from` of the class before.
struct CountWalk::Place {
  double particles, low, high, count;
  std::size_t from;
};

/// Bounds on masses at a step.
struct CountWalk::Reach {
  double f, F;
  double least, most;           ///< counts
  double share_low, share_high; ///< of the class
  double low, high;             ///< of all up to the class
  double noise;
  double coarser = 0; ///< particles in the coarser classes, at least

  double least_mass(double count) const { return count > 0 ? std::max(share_low, count * f) : 0; }
  double most_mass(double count) const { return std::min(share_high, count * F); }
  /// Particles of the class that have so much mass, at least.
  double fewest(double mass) const {
    return std::max(least, std::ceil(std::max(0.0, std::max(mass, share_low) - noise) / F));
  }
};

std::vector<CountWalk::Reach> CountWalk::reaches(const NearWindow &window) const {
  std::vector<Reach> all;
  for (std::size_t j = 0; j < classes_.size(); ++j) {
    const Class &c = classes_[j];
    all.push_back({c.f, c.F, window.least[j], window.most[j], c.share.lo * window.above,
                   c.share.hi * window.up_to, c.passing.lo * window.above, c.passing.hi * window.up_to,
                   mass_noise * window.up_to});
  }
  for (std::size_t j = all.size() - 1; j > 0; --j) {
    const Reach &above = all[j];
    double greatest = above.share_high;
    if (above.f > 0) {
      const double count = std::min(above.most, std::max(0.0, std::ceil(greatest / above.f) - 1));
      greatest = above.most_mass(count);
    } else if (above.most < greatest / above.F) {
      greatest = above.most_mass(above.most);
    }
    all[j - 1].low = std::max(all[j - 1].low, above.low - greatest);
    all[j - 1].high = std::min(all[j - 1].high, above.high - above.share_low);
    all[j - 1].coarser = above.coarser + above.fewest(0);
  }
  return all;
}

/// The places after one more class, those with the fewest particles first and of these the widest, where
/// fewer than `limit` are possible.
std::vector<CountWalk::Place> CountWalk::next(const std::vector<Place> &places, const Reach &reach,
                                              double limit) const {
  const auto is_open = [&reach](const Place &place, double count) {
    return count <= reach.most && place.low + reach.least_mass(count) <= reach.high + reach.noise &&
           place.high + reach.most_mass(count) >= reach.low - reach.noise &&
           reach.least_mass(count) <= reach.most_mass(count) + reach.noise;
  };
  std::vector<double> least;
  double fewest = limit;
  for (const Place &place : places) {
    least.push_back(reach.fewest(reach.low - place.high));
    if (is_open(place, least.back()))
      fewest = std::min(fewest, place.particles + least.back());
  }
  if (fewest == limit)
    return {};
  const double most = limit - reach.coarser - 1;
  std::vector<Place> kept, all;
  // Beyond 2^53 one particle more is none.
  for (int more = 0; more <= most_more && fewest + more <= most && kept.size() < most_places; ++more) {
    const double particles = fewest + more;
    all.clear();
    for (std::size_t from = 0; from < places.size(); ++from) {
      const Place &place = places[from];
      const double count = particles - place.particles;
      if (count >= least[from] && is_open(place, count))
        all.push_back({particles, std::max(reach.low, place.low + reach.least_mass(count)),
                       std::min(reach.high, place.high + reach.most_mass(count)), count, from});
    }
    std::sort(all.begin(), all.end(),
              [](const Place &a, const Place &b) { return a.high - a.low > b.high - b.low; });
    for (const Place &place : all) {
      const auto holds = [&place](const Place &other) {
        return other.low <= place.low && place.high <= other.high;
      };
      if (kept.size() < most_places && std::none_of(kept.begin(), kept.end(), holds))
        kept.push_back(place);
    }
  }
  return kept;
}

std::vector<double> CountWalk::counts(const NearWindow &window, double limit) const {
  std::vector<std::vector<Place>> steps{{{0, 0, 0, 0, 0}}};
  for (const Reach &reach : reaches(window)) {
    steps.push_back(next(steps.back(), reach, limit));
    if (steps.back().empty())
      return {};
  }
  std::vector<double> counts(classes_.size());
  std::size_t at = 0;
  for (std::size_t j = classes_.size(); j-- > 0;) {
    const Place &place = steps[j + 1][at];
    counts[j] = place.count;
    at = place.from;
  }
  return counts;
}

} // namespace mdm
