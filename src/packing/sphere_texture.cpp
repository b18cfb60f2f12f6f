// What is known of spheres in their places: void ratio, contacts, overlaps, heights of groups. What comes
// in is a sample and its space; what goes out are counts that are exact and numbers that are enclosed.
//
// One pass over the spheres sums their volumes and those of their parts in the inner space, and one over
// all pairs that are near (sphere_contacts.cpp) counts contacts. Whether two spheres touch, whether a
// centre is inside and in which band it lies are decisions: doubles make them where they are farther from
// the bound than their proved error, and fractions elsewhere. Sums of doubles carry a bound on their errors
// into the enclosure.

#include "number/pi.hpp"
#include "packing/cut_sphere.hpp"
#include "packing/enclosed_sum.hpp"
#include "packing/segregation.hpp"
#include "packing/sphere_contacts.hpp"
#include "packing/sphere_space.hpp"

#include <mdm/number/enclosure.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace mdm {
namespace {

using packing::EnclosedSum;
using packing::NearSpheres;
using packing::sphere_bands;
using packing::SphereImage;

/// d^3 of a double d within 2^-52 of the exact one: three times that, and two roundings, are less than ten
/// units of 2^-53.
constexpr double cube_error = 10 * std::numeric_limits<double>::epsilon() / 2;

double cube(double d) {
  return d * d * d;
}

Interval pi_interval() {
  const Enclosure e = enclose_pi(40);
  return {e.lower(), e.upper()};
}

/// Volume of the space by that of spheres, minus 1. \param cubes  sum of d^3 > 0
Interval void_ratio_of(const Interval &volume, const Interval &cubes) {
  const Interval solids = pi_interval() * cubes;
  return {6 * volume.lo / solids.hi - 1, 6 * volume.hi / solids.lo - 1};
}

class TextureMaker {
public:
  TextureMaker(const SphereSample &sample, std::size_t groups, const SphereTextureOptions &options)
      : sample_(sample), groups_(groups), options_(options),
        near_(sample, prepare(), options.space.periodic, options.gap) {}

  SphereTexture make() {
    measure_volumes();
    if (t_.inner)
      measure_inner();
    measure_contacts();
    measure_groups();
    return std::move(t_);
  }

private:
  /// The space of the spheres and its inner part.
  const SpaceBox &prepare() {
    assert(sample_.size() > 0);
    t_.space = packing::space_of(sample_, options_.space);
    t_.is_cylinder = options_.space.is_cylinder;
    t_.periodic = options_.space.periodic;
    t_.gap = options_.gap;
    const Rational largest = packing::largest_diameter(sample_);
    t_.inner = packing::inner_part(t_, options_.margin.value_or(2 * largest), largest);
    return t_.space;
  }

  void measure_volumes() {
    EnclosedSum cubes;
    for (std::size_t i = 0; i < sample_.size(); ++i) {
      const double v = cube(2 * sample_.radius(i));
      cubes.add(v, v * cube_error);
      if (!is_in_space(i))
        ++t_.outside;
    }
    const Interval box(t_.space.volume());
    t_.void_ratio =
        void_ratio_of(t_.is_cylinder ? box * pi_interval() * Interval(ratio(1, 4)) : box, cubes.interval());
  }

  /// Whether a centre at the upper bound of a box is in it: of the whole space it is, of its inner part not.
  enum class UpperBound { open, closed };

  bool is_between(std::size_t i, std::size_t axis, const Rational &low, const Rational &high,
                  UpperBound bound) const {
    const SphereImage &s = near_.moved(i);
    const double x = s.centre[axis], below = x - cut_double(low), above = cut_double(high) - x;
    if (below > bound_error(low) && above > bound_error(high))
      return true;
    if (below < -bound_error(low) || above < -bound_error(high))
      return false;
    const Rational exact = near_.exact(s, axis);
    return exact >= low && (exact < high || (bound == UpperBound::closed && exact == high));
  }
  /// More than the error of the difference of a centre and a bound.
  double bound_error(const Rational &bound) const {
    return near_.error() + std::abs(cut_double(bound)) * 4 * std::numeric_limits<double>::epsilon();
  }
  bool is_in(std::size_t i, const SpaceBox &box, UpperBound bound) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!t_.periodic[axis] && !is_between(i, axis, box.low[axis], box.high[axis], bound))
        return false;
    return true;
  }
  bool is_in_space(std::size_t i) const {
    if (!t_.is_cylinder)
      return is_in(i, t_.space, UpperBound::closed);
    if (!is_between(i, 2, t_.space.low[2], t_.space.high[2], UpperBound::closed))
      return false;
    const SphereImage &s = near_.moved(i);
    const Rational r = t_.space.side(0) / 2;
    const double x = s.centre[0] - cut_double(t_.space.low[0] + r);
    const double y = s.centre[1] - cut_double(t_.space.low[1] + r);
    const double off = std::sqrt(x * x + y * y) - cut_double(r);
    const double error = bound_error(t_.space.low[0]) + bound_error(t_.space.high[0]) +
                         bound_error(t_.space.low[1]) + bound_error(t_.space.high[1]);
    if (std::abs(off) > 4 * error)
      return off < 0;
    const Rational u = near_.exact(s, 0) - t_.space.low[0] - r, v = near_.exact(s, 1) - t_.space.low[1] - r;
    return Rational(u * u + v * v) <= Rational(r * r);
  }

  /// What the inner part keeps of the volume of all spheres.
  void measure_inner() {
    EnclosedSum cubes;
    for (std::size_t i = 0; i < sample_.size(); ++i)
      add_kept(i, cubes);
    const Interval sum = cubes.interval();
    if (sum.lo > 0)
      t_.inner_void_ratio = void_ratio_of(t_.inner->volume(), sum);
  }

  /// Of two opposite sides one alone cuts a sphere: the part is no narrower than the largest.
  void add_kept(std::size_t i, EnclosedSum &cubes) const {
    const double r = sample_.radius(i);
    std::array<Rational, 3> depths = {1, 1, 1};
    double share = 1, share_error = 0;
    unsigned cuts = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (t_.periodic[axis])
        continue;
      const double x = near_.moved(i).centre[axis];
      const double low = cut_double(t_.inner->low[axis]), high = cut_double(t_.inner->high[axis]);
      const double depth = std::min(x - low, high - x);
      const double error = bound_error(t_.inner->low[axis]) + bound_error(t_.inner->high[axis]);
      if (depth <= -r - error)
        return;
      if (depth >= r + error)
        continue;
      ++cuts;
      depths[axis] = exact_depth(i, axis);
      const double t = std::clamp(depth / r, -1.0, 1.0);
      share = (2 + 3 * t - t * t * t) / 4;
      share_error = 2 * error / r + 8 * std::numeric_limits<double>::epsilon();
    }
    constexpr double fine = 1e-9;
    if (cuts > 1 || share_error > fine) {
      for (const Rational &t : depths)
        if (t <= -1)
          return;
      const Interval kept = packing::kept_share(depths);
      share = cut_double(kept.lo);
      share_error = cut_double(kept.hi - kept.lo) + 4 * std::numeric_limits<double>::epsilon();
    }
    const double v = cube(2 * r);
    cubes.add(v * share, v * (share_error + 2 * cube_error));
  }

  /// Depth of the centre below the nearer plane, in radii, at most 1.
  Rational exact_depth(std::size_t i, std::size_t axis) const {
    const Rational x = near_.exact(near_.moved(i), axis);
    const Rational depth = std::min(Rational(x - t_.inner->low[axis]), Rational(t_.inner->high[axis] - x));
    return std::min(Rational(1), Rational(2 * depth / sample_.exact_diameter(i)));
  }

  void measure_contacts() {
    std::vector<std::uint32_t> touched(sample_.size());
    EnclosedSum sum;
    std::uint64_t overlapping = 0;
    double largest = 0, relative_low = 0, relative_high = 0;
    const double gap = cut_double(options_.gap), error = near_.error();
    near_.each([&](const SphereImage &a, const SphereImage &b, double depth) {
      if (depth + gap > 2 * error || near_.sign_of_reach(a, b, options_.gap) >= 0)
        ++touched[a.sphere];
      if (depth < -error || (depth <= error && near_.sign_of_reach(a, b, 0) <= 0))
        return;
      ++overlapping;
      sum.add(depth, error);
      const double d = 2 * std::min(sample_.radius(a.sphere), sample_.radius(b.sphere));
      const double wide = error / d + depth / d * 4 * std::numeric_limits<double>::epsilon();
      largest = std::max(largest, depth);
      relative_low = std::max(relative_low, depth / d - wide);
      relative_high = std::max(relative_high, depth / d + wide);
    });
    t_.overlaps.pairs = overlapping / 2;
    if (overlapping > 0) {
      t_.overlaps.largest = {std::max(Rational(0), Rational(largest) - Rational(error)),
                             Rational(largest) + Rational(error)};
      t_.overlaps.largest_relative = {Rational(relative_low), Rational(relative_high)};
      const Interval all = sum.interval();
      t_.overlaps.mean = {std::max(Rational(0), Rational(all.lo / overlapping)), all.hi / overlapping};
    }
    for (std::size_t i = 0; i < sample_.size(); ++i) {
      count(touched[i], t_.coordination);
      if (t_.inner && is_in(i, *t_.inner, UpperBound::open))
        count(touched[i], t_.inner_coordination);
    }
    t_.contacts = t_.coordination.ends / 2;
  }

  static void count(std::uint32_t touched, SphereCoordination &c) {
    ++c.spheres;
    c.ends += touched;
    c.floating += touched == 0 ? 1U : 0U;
    c.rattlers += touched <= 1 ? 1U : 0U;
  }

  void measure_groups() {
    const Rational floor = t_.space.low[2], height = t_.space.side(2);
    for (std::size_t k = 0; k <= sphere_bands; ++k)
      t_.band_heights.push_back(height * k / sphere_bands);
    struct Sums {
      std::uint64_t spheres = 0;
      EnclosedSum volume, moment;
      std::array<EnclosedSum, sphere_bands> bands;
    };
    std::vector<Sums> sums(groups_);
    const double low = cut_double(floor);
    for (std::size_t i = 0; i < sample_.size(); ++i) {
      if (sample_.group(i) >= groups_)
        continue;
      Sums &s = sums[sample_.group(i)];
      const double v = cube(2 * sample_.radius(i)), above = near_.moved(i).centre[2] - low;
      ++s.spheres;
      s.volume.add(v, v * cube_error);
      s.moment.add(v * above, v * (bound_error(floor) + std::abs(above) * 2 * cube_error));
      s.bands[band_of(i)].add(v, v * cube_error);
    }
    std::vector<packing::BandVolumes> volumes;
    for (const Sums &s : sums) {
      SphereGroup group;
      group.spheres = s.spheres;
      const Interval volume = s.volume.interval(), moment = s.moment.interval();
      if (s.spheres > 0)
        group.mean_height = moment / volume;
      packing::BandVolumes of_bands;
      for (std::size_t k = 0; k < sphere_bands; ++k) {
        const Interval band = s.bands[k].interval();
        of_bands[k] = {std::max(Rational(0), band.lo), band.hi};
      }
      volumes.push_back(of_bands);
      t_.groups.push_back(std::move(group));
    }
    const std::vector<packing::BandVolumes> shares = packing::shares_of_bands(volumes);
    for (std::size_t j = 0; j < groups_; ++j)
      t_.groups[j].shares.assign(shares[j].begin(), shares[j].end());
    t_.segregation = packing::segregation(volumes);
  }

  /// The band of a sphere by its centre; beyond the space, the nearest one.
  std::size_t band_of(std::size_t i) const {
    const SphereImage &s = near_.moved(i);
    const double height = cut_double(t_.space.side(2));
    const double low = cut_double(t_.space.low[2]);
    const double at = (s.centre[2] - low) / height * sphere_bands;
    const auto clamped = static_cast<std::size_t>(std::clamp(at, 0.0, sphere_bands - 0.5));
    const double error = (near_.error() + std::abs(low) * 1e-15) / height * sphere_bands + 1e-14;
    if (std::abs(at - std::round(at)) > 4 * error)
      return clamped;
    const Rational exact = (near_.exact(s, 2) - t_.space.low[2]) / t_.space.side(2) * sphere_bands;
    if (exact < 0)
      return 0;
    return exact >= sphere_bands ? sphere_bands - 1 : static_cast<std::size_t>(floor(exact));
  }

  const SphereSample &sample_;
  std::size_t groups_;
  SphereTextureOptions options_;
  SphereTexture t_;
  NearSpheres near_;
};

} // namespace

std::optional<Rational> SphereCoordination::mean_without_rattlers() const {
  if (rattlers == spheres)
    return std::nullopt;
  return ratio(Integer(ends) - (rattlers - floating), spheres - rattlers);
}

SphereTexture sphere_texture(const SphereSample &sample, std::size_t groups,
                             const SphereTextureOptions &options) {
  return TextureMaker(sample, groups, options).make();
}

} // namespace mdm
