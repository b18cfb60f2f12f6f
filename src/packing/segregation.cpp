#include "packing/segregation.hpp"

#include <algorithm>
#include <numeric>

namespace mdm::packing {
namespace {

Interval sum_of(const BandVolumes &volumes) {
  return std::accumulate(volumes.begin(), volumes.end(), Interval());
}

BandVolumes totals(const std::vector<BandVolumes> &groups) {
  BandVolumes all;
  for (const BandVolumes &group : groups)
    for (std::size_t k = 0; k < sphere_bands; ++k)
      all[k] = all[k] + group[k];
  return all;
}

} // namespace

std::vector<BandVolumes> shares_of_bands(const std::vector<BandVolumes> &groups) {
  const BandVolumes all = totals(groups);
  std::vector<BandVolumes> shares(groups.size());
  for (std::size_t j = 0; j < groups.size(); ++j)
    for (std::size_t k = 0; k < sphere_bands; ++k)
      if (all[k].lo > 0)
        shares[j][k] = groups[j][k] / all[k];
  return shares;
}

std::optional<Interval> segregation(const std::vector<BandVolumes> &groups) {
  const BandVolumes bands = totals(groups);
  const Interval all = sum_of(bands);
  if (!(all.lo > 0))
    return std::nullopt;
  const std::vector<BandVolumes> shares = shares_of_bands(groups);
  // sum_k w_k (s_jk - p_j)^2 = sum_k w_k s_jk^2 - p_j^2, w being the bands' shares of all; and the sum of
  // p (1 - p) is 1 - sum p^2.
  Interval variance, most(Rational(1));
  for (std::size_t j = 0; j < groups.size(); ++j) {
    const Interval square = power(sum_of(groups[j]) / all, 2);
    for (std::size_t k = 0; k < sphere_bands; ++k)
      variance = variance + bands[k] / all * power(shares[j][k], 2);
    variance = variance - square;
    most = most - square;
  }
  if (most.lo <= 0)
    return std::nullopt;
  const Interval index = variance / most;
  return Interval(std::clamp(index.lo, Rational(0), Rational(1)),
                  std::clamp(index.hi, Rational(0), Rational(1)));
}

} // namespace mdm::packing
