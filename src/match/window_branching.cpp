// How the search goes on in a window of the mass. The split of the mass is a short fraction near the middle
// of the window, as its digits stand in the certificate. In a narrow window counts of the coarsest classes
// that are not whole are candidates too: all are tried, both branches of each are solved, and the product
// of their gains decides (README.md here, "Rules that have names elsewhere"). Matches are looked for at the
// ends and the middle. Nothing here is a decision: any split is right, and matches are tested exactly.

#include "match/window_branching.hpp"

#include "match/near.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mdm {
namespace {

/// Windows that are narrower are not split by doubles.
constexpr double least_relative_width = 1 + 1e-12;

double relative_width(const MassWindow &window) {
  return window.above > 0 && window.up_to ? near(*window.up_to) / near(window.above)
                                          : std::numeric_limits<double>::infinity();
}

/// The number of particles grows with the mass: to split a narrow window's mass gains less than a particle.
bool is_narrow(const MassWindow &window, double particles) {
  return relative_width(window) * particles < particles + 1;
}

} // namespace

WindowBranching::WindowBranching(const TolerantProblem &problem, Rational mass)
    : problem_(problem), windows_(problem), relaxation_(problem, windows_),
      rounding_(problem, windows_, relaxation_), mass_(std::move(mass)) {}

std::optional<TolerantMatch> WindowBranching::match(const MassWindow &window, const CountBounds &bounds,
                                                    double limit, double excess_price) const {
  if (window.above == 0 || !window.up_to)
    return std::nullopt;
  return rounding_.match(std::sqrt(near(window.above) * near(*window.up_to)), bounds, limit, excess_price);
}

/// A short fraction near the middle of the window, in units of the gradation's masses.
std::optional<Rational> WindowBranching::middle(const MassWindow &window) const {
  const Rational &unit = problem_.unit();
  Rational lo = window.above, hi = window.up_to.value_or(Rational(0));
  if (lo == 0 && !window.up_to) {
    lo = mass_ * ratio(7, 8);
    hi = mass_;
  } else if (!window.up_to) {
    hi = lo * 4;
    lo = lo * 2;
  } else if (lo == 0) {
    lo = hi / 8;
    hi = hi / 4;
  } else if (relative_width(window) < least_relative_width) {
    return std::nullopt;
  } else if (relative_width(window) > 4) {
    const Rational of_lo(std::sqrt(relative_width(window)));
    hi = lo * of_lo * ratio(5, 4);
    lo = lo * of_lo * ratio(4, 5);
  } else {
    const Rational part = (hi - lo) / 8;
    lo += 3 * part;
    hi -= 4 * part;
  }
  return unit * simplest_between(Rational(lo / unit), Rational(hi / unit));
}

/// Of the coarsest classes whose counts are no whole numbers.
std::vector<WindowBranching::Split> WindowBranching::count_splits(const CountBounds &bounds,
                                                                  const WindowPoint &point) const {
  constexpr std::size_t most_splits = 4;
  constexpr double noise = 1e-7, most_count = 1e6;
  std::vector<Split> splits;
  for (std::size_t j = point.counts.size(); j-- > 0 && splits.size() < most_splits;) {
    const double whole = std::floor(point.counts[j] + noise);
    if (point.counts[j] - whole < noise || whole > most_count || !bounds[j].is_inside(Integer(whole + 1)))
      continue;
    splits.push_back({std::nullopt, j, Integer(whole + 1)});
  }
  return splits;
}

/// By how much both branches are above the node, up to the limit, which are solved for it (strong branching),
/// by the product rule.
double WindowBranching::merit(const Split &split, const MassWindow &window, const CountBounds &bounds,
                              const WindowPoint &point, double limit) const {
  // So that a branch which gains nothing does not hide the other's gain. Smaller ones prefer counts that
  // close one branch, one after the other, to the mass; they serve where no branch gains that much.
  constexpr double least_part = 0.01, tiny_part = 1e-9;
  const double room = limit - point.particles;
  std::array<double, 2> gains{};
  for (const bool is_first : {true, false}) {
    MassWindow half = window;
    CountBounds counts = bounds;
    if (split.mass)
      half.narrow(*split.mass, is_first);
    else
      counts[split.j].narrow(split.v, is_first);
    const double found = minimise(half, counts, limit, point.prices.excess).particles;
    gains[is_first ? 0 : 1] = std::min(found, limit) - point.particles;
  }
  const bool gains_much = std::max(gains[0], gains[1]) >= least_part * room;
  const double least = (gains_much ? least_part : tiny_part) * room;
  return std::max(gains[0], least) * std::max(gains[1], least);
}

std::optional<WindowBranching::Split> WindowBranching::best_split(const MassWindow &window,
                                                                  const CountBounds &bounds,
                                                                  const WindowPoint &point,
                                                                  double limit) const {
  const std::optional<Rational> mass = middle(window);
  const bool has_sums = problem_.tolerance().total || !problem_.tolerance().passing.empty();
  const bool narrow = is_narrow(window, point.particles);
  // Where shares of single classes alone are bounded, a wide window's mass has always been better to split.
  if (mass && (!point.exists() || !(has_sums || narrow)))
    return Split{mass, 0, 0};
  std::vector<Split> splits = count_splits(bounds, point);
  const bool decides_exactly = narrow && splits.empty() && problem_.table_size() <= exact_table;
  if (mass && !decides_exactly)
    splits.insert(splits.begin(), {mass, 0, 0});
  if (splits.size() == 1)
    return splits.front();
  std::optional<Split> best;
  double most = 0;
  for (Split &split : splits)
    if (const double gain = merit(split, window, bounds, point, limit); !best || gain > most) {
      most = gain;
      best = std::move(split);
    }
  return best;
}

} // namespace mdm
