// Number density, partition function, volume fraction and grading curve of one set, each from another
// (Voivret, Delenne, Radjai, Eq. 2-5). Within a class sizes are uniform by volume, so that all four have
// closed forms between the bounds: what is kept are shares of classes by volume and by number, and sums of
// them up to each bound, which are worked out once for each precision. They are exact where bounds and
// shares are fractions.

#include "sets/size_distribution.hpp"

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

/// The number of particles in a class [l, u] that have volume 1 together: the mean of d^-D over the class,
/// (l^-p - u^-p) / (p (u - l)), p = D - 1.
Real number_in_volume(const Real &l, const Real &u, unsigned dimension) {
  if (dimension == 2)
    return Real(1) / (l * u);
  return (l + u) / (Real(2) * pow(l * u, 2));
}

} // namespace

PartialSums::PartialSums(std::vector<Real> terms)
    : terms_(std::move(terms)), known_(std::make_shared<std::map<unsigned, std::vector<Ball>>>()) {
  if (!std::all_of(terms_.begin(), terms_.end(), [](const Real &y) { return y.fraction().has_value(); }))
    return;
  exact_.emplace_back(0);
  for (const Real &term : terms_)
    exact_.push_back(exact_.back() + *term.fraction());
}

Real PartialSums::of_first(std::size_t n) const {
  if (!exact_.empty())
    return Real(exact_[n]);
  return Real([known = known_, terms = terms_, n](unsigned bits) {
    auto at = known->find(bits);
    if (at == known->end()) {
      std::vector<Ball> sums{Ball(0, bits)};
      for (const Real &term : terms)
        sums.push_back(sums.back() + term.ball(bits));
      at = known->emplace(bits, std::move(sums)).first;
    }
    return at->second[n];
  });
}

SizeDistribution::SizeDistribution(std::vector<Real> bounds, std::vector<Real> volumes,
                                   std::vector<Real> numbers, unsigned dimension)
    : bounds_(std::move(bounds)), volumes_(std::move(volumes)), numbers_(std::move(numbers)),
      volumes_below_(volumes_), numbers_below_(numbers_), dimension_(dimension) {
  assert(bounds_.size() == volumes_.size() + 1 && volumes_.size() == numbers_.size());
}

SizeDistribution SizeDistribution::by_volume(std::vector<Real> bounds, std::vector<Real> shares,
                                             unsigned dimension) {
  std::vector<Real> numbers;
  for (std::size_t i = 0; i < shares.size(); ++i)
    numbers.push_back(shares[i] * number_in_volume(bounds[i], bounds[i + 1], dimension));
  return {std::move(bounds), std::move(shares), std::move(numbers), dimension};
}

SizeDistribution SizeDistribution::by_number(std::vector<Real> bounds, std::vector<Real> shares,
                                             unsigned dimension) {
  std::vector<Real> volumes;
  for (std::size_t i = 0; i < shares.size(); ++i)
    volumes.push_back(shares[i] / number_in_volume(bounds[i], bounds[i + 1], dimension));
  return {std::move(bounds), std::move(volumes), std::move(shares), dimension};
}

bool SizeDistribution::is_end(const Real &d) const {
  return d.fraction() && d.fraction() == bounds_.back().fraction();
}

std::size_t SizeDistribution::class_of(const Real &d) const {
  const auto after =
      std::upper_bound(bounds_.begin() + 1, bounds_.end() - 1, d,
                       [](const Real &x, const Real &b) { return compare(x, b) == Order::less; });
  return static_cast<std::size_t>(after - bounds_.begin()) - 1;
}

Real SizeDistribution::grading(const Real &d) const {
  if (is_end(d))
    return Real(1);
  if (d.fraction() && d.fraction() == bounds_.front().fraction())
    return Real(0);
  const std::size_t i = class_of(d);
  const Real &l = bounds_[i], &u = bounds_[i + 1];
  return (volumes_below_.of_first(i) + volumes_[i] * (d - l) / (u - l)) / volumes_below_.of_all();
}

Real SizeDistribution::partition(const Real &d) const {
  if (is_end(d))
    return Real(1);
  if (d.fraction() && d.fraction() == bounds_.front().fraction())
    return Real(0);
  const std::size_t i = class_of(d);
  const Rational p = dimension_ - 1;
  const Real &l = bounds_[i], &u = bounds_[i + 1];
  const Real in_class = (Real(1) - pow(l / d, p)) / (Real(1) - pow(l / u, p));
  return (numbers_below_.of_first(i) + numbers_[i] * in_class) / numbers_below_.of_all();
}

Real SizeDistribution::volume_density(const Real &d) const {
  const std::size_t i = class_of(d);
  return volume_share(i) / (bounds_[i + 1] - bounds_[i]);
}

Real SizeDistribution::number_density(const Real &d) const {
  const std::size_t i = class_of(d);
  const Real &l = bounds_[i], &u = bounds_[i + 1];
  return number_share(i) / (pow(d, dimension_) * number_in_volume(l, u, dimension_) * (u - l));
}

} // namespace mdm
