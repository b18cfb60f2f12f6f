#include <mdm/grading/size_distribution.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// Each of them over their sum.
std::vector<Real> normalised(const std::vector<Real> &amounts) {
  const Real whole = sum(amounts);
  std::vector<Real> shares;
  shares.reserve(amounts.size());
  for (const Real &amount : amounts)
    shares.push_back(amount / whole);
  return shares;
}

/// The sum of the first n.
Real sum_of_first(const std::vector<Real> &shares, std::size_t n) {
  return sum({shares.begin(), shares.begin() + static_cast<std::ptrdiff_t>(n)});
}

} // namespace

SizeDistribution SizeDistribution::by_volume(std::vector<Real> bounds, std::vector<Real> shares,
                                             unsigned dimension) {
  SizeDistribution result(std::move(bounds), dimension);
  std::vector<Real> numbers;
  for (std::size_t i = 0; i < shares.size(); ++i)
    numbers.push_back(shares[i] * result.number_in_volume(i));
  result.volumes_ = std::move(shares);
  result.numbers_ = normalised(numbers);
  return result;
}

SizeDistribution SizeDistribution::by_number(std::vector<Real> bounds, std::vector<Real> shares,
                                             unsigned dimension) {
  SizeDistribution result(std::move(bounds), dimension);
  std::vector<Real> volumes;
  for (std::size_t i = 0; i < shares.size(); ++i)
    volumes.push_back(shares[i] / result.number_in_volume(i));
  result.numbers_ = std::move(shares);
  result.volumes_ = normalised(volumes);
  return result;
}

std::size_t SizeDistribution::class_of(const Real &d) const {
  const auto after =
      std::upper_bound(bounds_.begin() + 1, bounds_.end() - 1, d,
                       [](const Real &x, const Real &b) { return compare(x, b) == Order::less; });
  return static_cast<std::size_t>(after - bounds_.begin()) - 1;
}

/// The mean of d^-D over the class: (l^-p - u^-p) / (p (u - l)), p = D - 1.
Real SizeDistribution::number_in_volume(std::size_t i) const {
  const Real &l = bounds_[i], &u = bounds_[i + 1];
  if (dimension_ == 2)
    return Real(1) / (l * u);
  return (l + u) / (Real(2) * pow(l * u, 2));
}

Real SizeDistribution::grading(const Real &d) const {
  const std::size_t i = class_of(d);
  return sum_of_first(volumes_, i) + volume_density(d) * (d - bounds_[i]);
}

Real SizeDistribution::partition(const Real &d) const {
  const std::size_t i = class_of(d);
  const Rational p = dimension_ - 1;
  const Real &l = bounds_[i], &u = bounds_[i + 1];
  return sum_of_first(numbers_, i) + numbers_[i] * (Real(1) - pow(l / d, p)) / (Real(1) - pow(l / u, p));
}

Real SizeDistribution::volume_density(const Real &d) const {
  const std::size_t i = class_of(d);
  return volumes_[i] / (bounds_[i + 1] - bounds_[i]);
}

Real SizeDistribution::number_density(const Real &d) const {
  const std::size_t i = class_of(d);
  const Real in_class = Real(1) / (pow(d, dimension_) * number_in_volume(i));
  return numbers_[i] * in_class / (bounds_[i + 1] - bounds_[i]);
}

} // namespace mdm
