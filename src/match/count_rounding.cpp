// Whole counts near a point of the linear program, for which an exact test is worth its time. Counts are
// made in three ways, from the finest class on: as few as let what passes each sieve be what it is at the
// point, the same with counts that are whole already held, and as few as the least shares of all sums of
// consecutive classes demand. For each the masses M are worked out with which every such sum can have its
// share. If there are none, the mass that the counts need is taken and they are made again, eight times at
// most. Doubles do it: the test that follows is exact.

#include "match/count_rounding.hpp"

#include "match/near.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace mdm {
namespace {

constexpr double rounding_noise = 1e-9;

/// Least whole number that is at least x, but for noise.
double up(double x) {
  return std::ceil(x - rounding_noise * std::max(1.0, x));
}

bool is_held(double x) {
  return std::fabs(x - std::round(x)) <= 1e-6;
}

double sum_of(const std::vector<double> &q) {
  return std::accumulate(q.begin(), q.end(), 0.0);
}

} // namespace

CountRounding::CountRounding(const TolerantProblem &problem, const ShareClosure &shares)
    : k_(problem.classes()), lo_(k_ * k_, 0), hi_(k_ * k_, 0) {
  const double unit = near(shares.unit());
  for (std::size_t i = 0; i < k_; ++i) {
    f_.push_back(near(problem.f(i)));
    F_.push_back(near(problem.F(i)));
    for (std::size_t j = i; j < k_; ++j) {
      lo_[i * k_ + j] = near(shares.lo(i, j)) / unit;
      hi_[i * k_ + j] = near(shares.hi(i, j)) / unit;
    }
  }
}

CountRounding::Window CountRounding::window(const std::vector<double> &q) const {
  Window window{0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < k_; ++i) {
    double f = 0, F = 0;
    for (std::size_t j = i; j < k_; ++j) {
      f += f_[j] * q[j];
      F += F_[j] * q[j];
      if (f > 0)
        window.above = std::max(window.above, f / hi(i, j));
      if (lo(i, j) > 0)
        window.up_to = std::min(window.up_to, F / lo(i, j));
    }
  }
  return window;
}

/// What passes each sieve is at least what it is at the point, times `growth`; whole counts of few particles
/// are held.
std::vector<double> CountRounding::along_curve(const Point &point, double growth, bool hold) const {
  constexpr double few = 1000;
  const double mass = growth * sum_of(point.masses);
  std::vector<double> q;
  double passing = 0, reached = 0;
  for (std::size_t j = 0; j < k_; ++j) {
    passing += growth * point.masses[j];
    double n = std::max(up(std::max(passing - reached, lo(j, j) * mass) / F_[j]), point.least[j]);
    if (hold && point.counts[j] < few && is_held(point.counts[j]))
      n = std::round(point.counts[j]);
    q.push_back(std::max(n, 0.0));
    reached += q.back() * F_[j];
  }
  return q;
}

/// As few as the least shares of sums of consecutive classes demand at a mass.
std::vector<double> CountRounding::by_shares(const Point &point, double mass) const {
  std::vector<double> q;
  for (std::size_t j = 0; j < k_; ++j) {
    double missing = 0, held = 0;
    for (std::size_t i = j + 1; i-- > 0;) {
      if (i < j)
        held += F_[i] * q[i];
      missing = std::max(missing, lo(i, j) * mass - held);
    }
    q.push_back(std::max(up(missing / F_[j]), point.least[j]));
  }
  return q;
}

std::optional<std::vector<double>> CountRounding::rounded(const Point &point, double most) const {
  constexpr double step = 1 + 1e-9;
  constexpr int tries = 8;
  const double mass = sum_of(point.masses);
  std::optional<std::vector<double>> best;
  if (!(mass > 0))
    return best;
  for (int way = 0; way < 3; ++way) {
    double growth = step;
    for (int i = 0; i < tries; ++i) {
      std::vector<double> q =
          way == 2 ? by_shares(point, growth * mass) : along_curve(point, growth, way == 1);
      if (!(sum_of(q) < most))
        break;
      const Window found = window(q);
      if (found.above < found.up_to) {
        most = sum_of(q);
        best = std::move(q);
        break;
      }
      if (found.above / mass * step <= growth)
        break;
      growth = found.above / mass * step;
    }
  }
  return best;
}

} // namespace mdm
