// Spheres that are near each other. What comes in are spheres with exact centres and diameters, their box
// and its periods, and a gap; what goes out are all pairs that may touch within it, and the means to decide
// each.
//
// Centres are moved into the first period, and what is in reach of a periodic side has images beyond the
// other. All are put on a coarse lattice, whose map brings no two spheres farther apart, and sorted into a
// SphereGrid; from each sphere those in its reach are looked at. Invariant: no pair that touches is left
// out. r + r' - d is within error() in doubles; where that does not decide, sign_of_reach() compares
// squares of fractions.

#include "packing/sphere_contacts.hpp"

#include "packing/sphere_grid.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mdm::packing {

/// Places on the lattice of a SphereGrid. The map brings no two spheres farther apart, but for rounding: what
/// lies far from most is moved to a hull around them, so that a stray sphere does not make cells too large.
/// The shortest side is the grid's z.
class GridLattice {
public:
  GridLattice(const std::vector<SphereImage> &images, const SphereSample &sample) {
    double smallest = sample.radius(0), largest = 0;
    for (std::size_t i = 0; i < sample.size(); ++i) {
      smallest = std::min(smallest, sample.radius(i));
      largest = std::max(largest, sample.radius(i));
    }
    double widest = largest;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      find_hull(images, axis, largest);
      widest = std::max(widest, high_[axis] - low_[axis]);
    }
    std::sort(order_.begin(), order_.end(),
              [this](std::size_t a, std::size_t b) { return high_[a] - low_[a] > high_[b] - low_[b]; });
    constexpr double finest = 1.0 / 1024, most_units = 1e15;
    unit_ = std::max(smallest * finest, widest / most_units);
  }

  double length(double x) const { return x / unit_; }
  Vector3 place(const std::array<double, 3> &at) const {
    return {units(at, order_[0]), units(at, order_[1]), units(at, order_[2])};
  }
  SphereSpace space() const { return {side(order_[0]), side(order_[1]), Sides::walls}; }

private:
  /// Room for all but some hundredths of the centres on either side, and for three times their range.
  void find_hull(const std::vector<SphereImage> &images, std::size_t axis, double largest) {
    constexpr std::size_t part = 100;
    std::vector<double> x;
    x.reserve(images.size());
    for (const SphereImage &image : images)
      x.push_back(image.centre[axis]);
    const auto cut = static_cast<std::ptrdiff_t>(x.size() / part);
    std::nth_element(x.begin(), x.begin() + cut, x.end());
    const double first = x[static_cast<std::size_t>(cut)];
    const auto [least, most] = std::minmax_element(x.begin(), x.end());
    const double lowest = *least, highest = *most;
    std::nth_element(x.begin(), x.end() - 1 - cut, x.end());
    const double last = *(x.end() - 1 - cut), room = 3 * (last - first) + 4 * largest;
    low_[axis] = std::max(lowest, first - room);
    high_[axis] = std::min(highest, last + room);
  }
  double units(const std::array<double, 3> &at, std::size_t axis) const {
    return std::floor((std::clamp(at[axis], low_[axis], high_[axis]) - low_[axis]) / unit_);
  }
  std::int64_t side(std::size_t axis) const {
    return static_cast<std::int64_t>(std::ceil((high_[axis] - low_[axis]) / unit_)) + 2;
  }

  std::array<double, 3> low_{}, high_{};
  std::array<std::size_t, 3> order_{0, 1, 2}; ///< axes, the longest first
  double unit_ = 1;
};

NearSpheres::NearSpheres(const SphereSample &sample, const SpaceBox &space,
                         const std::array<bool, 3> &periodic, const Rational &gap)
    : sample_(sample), space_(space), periodic_(periodic), gap_(cut_double(gap)) {
  largest_radius_ = 0;
  images_.resize(sample.size());
  for (std::size_t axis = 0; axis < 3; ++axis)
    periods_[axis] = space_.side(axis);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    largest_radius_ = std::max(largest_radius_, sample.radius(i));
    SphereImage &image = images_[i];
    image = {static_cast<std::uint32_t>(i), {}, sample.centre(i)};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (periodic_[axis]) {
        const double period = cut_double(periods_[axis]), low = cut_double(space_.low[axis]);
        const double n = std::floor((image.centre[axis] - low) / period);
        constexpr double most_periods = 1e9;
        if (!(std::abs(n) < most_periods))
          throw InputError("a place is more than 1e9 periods from the box: is the box right?");
        image.periods[axis] = -static_cast<std::int64_t>(n);
        image.centre[axis] -= n * period;
      }
  }
  add_images();
  // Let u = 2^-53, and M be no less than any length here. A centre is within 2uM of what the file says, moved
  // by n periods within (2 + 2 + 1)uM, where M is no less than the periods moved by; a difference of two is
  // within 12uM, and the distance within (12 sqrt 3 + 3 * 4)uM; radii and their sum are within 6uM, and the
  // last difference adds 4uM: less than 64uM in all.
  double greatest = std::max(sample.greatest(), gap_);
  for (const SphereImage &image : images_)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double moved = static_cast<double>(std::abs(image.periods[axis])) * cut_double(periods_[axis]);
      greatest = std::max({greatest, std::abs(image.centre[axis]), periodic_[axis] ? moved : 0.0});
    }
  constexpr double ulps = 64;
  error_ = 2 * greatest * ulps * std::numeric_limits<double>::epsilon() / 2;
}

void NearSpheres::add_images() {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!periodic_[axis])
      continue;
    const double period = cut_double(periods_[axis]), low = cut_double(space_.low[axis]);
    constexpr double wider = 1 + 1e-9;
    const double reach = (2 * largest_radius_ + gap_) * wider;
    if (!(period > 2 * reach))
      throw InputError("the box is periodic and no wider than two of the largest diameters: give a wider " +
                       option("box"));
    const std::size_t before = images_.size();
    for (std::size_t i = 0; i < before; ++i) {
      const double above = images_[i].centre[axis] - low;
      for (const std::int64_t by : {1, -1})
        if (by > 0 ? above <= reach : period - above <= reach) {
          SphereImage image = images_[i];
          image.periods[axis] += by;
          image.centre[axis] += static_cast<double>(by) * period;
          images_.push_back(image);
        }
    }
  }
}

double NearSpheres::overlap(const SphereImage &a, const SphereImage &b) const {
  const double x = a.centre[0] - b.centre[0], y = a.centre[1] - b.centre[1], z = a.centre[2] - b.centre[2];
  return sample_.radius(a.sphere) + sample_.radius(b.sphere) - std::sqrt(x * x + y * y + z * z);
}

Rational NearSpheres::exact(const SphereImage &a, std::size_t axis) const {
  return sample_.exact_coordinate(a.sphere, axis) + a.periods[axis] * periods_[axis];
}

int NearSpheres::sign_of_reach(const SphereImage &a, const SphereImage &b, const Rational &gap) const {
  Rational distance2 = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Rational by = exact(a, axis) - exact(b, axis);
    distance2 += by * by;
  }
  const Rational reach = (sample_.exact_diameter(a.sphere) + sample_.exact_diameter(b.sphere)) / 2 + gap;
  return Rational(reach * reach).compare(distance2);
}

void NearSpheres::each(
    const std::function<void(const SphereImage &, const SphereImage &, double)> &take) const {
  if (images_.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    throw InputError("there are more than 2147483647 spheres with their images: take a part of them");
  const GridLattice lattice(images_, sample_);
  const std::vector<std::uint32_t> order = order_in_space(lattice);
  std::vector<SphereImage> spheres;
  std::vector<double> radii;
  spheres.reserve(order.size());
  radii.reserve(order.size());
  for (const std::uint32_t i : order) {
    spheres.push_back(images_[i]);
    radii.push_back(std::ceil(lattice.length(sample_.radius(images_[i].sphere))) + 1);
  }
  SphereGrid grid(radii, lattice.space());
  for (std::size_t k = 0; k < spheres.size(); ++k)
    grid.add(static_cast<std::int32_t>(k), lattice.place(spheres[k].centre));
  // Each coordinate of a place is rounded by less than a unit.
  const double near = std::ceil(lattice.length(gap_)) + 4;
  constexpr double any = std::numeric_limits<double>::infinity();
  const double least = -(gap_ + 2 * error_);
  for (std::size_t k = 0; k < spheres.size(); ++k)
    if (order[k] < sample_.size())
      grid.each_near(lattice.place(spheres[k].centre), radii[k], near, any,
                     [&](std::int32_t other, const Vector3 &) {
                       const auto j = static_cast<std::size_t>(other);
                       if (j == k)
                         return;
                       const double depth = overlap(spheres[k], spheres[j]);
                       if (depth >= least)
                         take(spheres[k], spheres[j], depth);
                     });
}

std::vector<std::uint32_t> NearSpheres::order_in_space(const GridLattice &lattice) const {
  constexpr double cells = 1 << 20; // along an axis, at most
  double sum = 0, farthest = 0;
  for (const SphereImage &image : images_) {
    const Vector3 p = lattice.place(image.centre);
    sum += lattice.length(sample_.radius(image.sphere));
    farthest = std::max({farthest, p.x, p.y, p.z});
  }
  const double side = std::max(4 * sum / static_cast<double>(images_.size()), 2 * farthest / cells) + 1;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  keys.reserve(images_.size());
  for (std::size_t i = 0; i < images_.size(); ++i) {
    const Vector3 p = lattice.place(images_[i].centre);
    const auto row = [side](double x) { return static_cast<std::uint64_t>(x / side); };
    keys.emplace_back(row(p.z) << 42U | row(p.y) << 21U | row(p.x), static_cast<std::uint32_t>(i));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order;
  order.reserve(keys.size());
  for (const auto &[key, i] : keys)
    order.push_back(i);
  return order;
}

} // namespace mdm::packing
