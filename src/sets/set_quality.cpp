// How near a set of particles is to its grading curve. The volumes of its sizes, enclosed, are added up
// class by class, and the curve that they make is compared with the model at given sizes. One pass over the
// classes in ascending order is enough, with memory for the sizes of one class. What is told is an
// interval, as wide as the enclosures of the sizes make it.

#include "sets/set_quality.hpp"

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

/// Precision of what is compared with volumes, which are no more certain than the digits of sizes.
constexpr unsigned work_bits = 192;
constexpr unsigned work_digits = 40;

/// A number of units, or what is certain of it.
struct Amount {
  Integer lo = 0, hi = 0;

  Amount &operator+=(const Amount &a) {
    lo += a.lo;
    hi += a.hi;
    return *this;
  }
};

/// part / whole, where whole has part in it.
Interval share(const Amount &part, const Amount &whole) {
  return {ratio(part.lo, whole.hi), std::min(ratio(part.hi, whole.lo), Rational(1))};
}

Interval interval(const Real &y) {
  const Enclosure e = enclose(y, work_digits);
  return {e.lower(), e.upper()};
}

Interval square_root(const Interval &y) {
  return {root(y.lo, 2, work_bits).lo, root(y.hi, 2, work_bits).hi};
}

Interval square(const Interval &y) {
  const Interval a = absolute(y);
  return a * a;
}

/// Sizes and volumes as whole numbers of one unit, 10^-places and 10^-(D places), rounded outwards.
class Units {
public:
  Units(const Rational &least, unsigned dimension) : dimension_(dimension) {
    while (Rational(least * Rational(power_of_ten(places_))) < Rational(power_of_ten(work_digits / 2)))
      ++places_;
    for (unsigned i = 0; i <= places_; ++i)
      powers_.push_back(power_of_ten(i));
  }

  Amount size(const Enclosure &e) const {
    if (e.places <= places_) {
      const Integer &factor = powers_[places_ - e.places];
      return {e.lo * factor, e.hi * factor};
    }
    const Integer divisor = power_of_ten(e.places - places_);
    return {floor_div(e.lo, divisor), ceil_div(e.hi, divisor)};
  }
  Amount volume(const Amount &size, const Integer &count) const {
    return {count * power(size.lo, dimension_), count * power(size.hi, dimension_)};
  }
  Interval in_lengths(const Amount &size) const {
    const Integer unit = power_of_ten(places_);
    return {ratio(size.lo, unit), ratio(size.hi, unit)};
  }

private:
  unsigned dimension_, places_ = 0;
  std::vector<Integer> powers_; // of ten
};

/// Particles of one size.
struct Sized {
  Amount size, volume;
};

class Quality {
public:
  Quality(const ModelCurve &curve, const std::vector<SizeClass> &classes, unsigned dimension, unsigned points,
          const ParticlesOf &particles, const std::optional<std::vector<Rational>> &exact_shares)
      : curve_(curve), classes_(classes), particles_(particles), exact_shares_(exact_shares),
        units_(std::min(curve.d_min(), Rational(curve.d_max() - curve.d_min())), dimension),
        volumes_(classes.size()) {
    for (unsigned i = 0; i < points; ++i) {
      sizes_.emplace_back(Surd(curve.d_min()) *
                          Surd::root_power(curve.d_max() / curve.d_min(), i, points - 1));
      points_.push_back(units_.size(enclose(sizes_.back().real, work_digits)));
    }
  }

  SetQuality run() {
    SetQuality result;
    // The volume that is certain to pass a point but no lower one, and that may.
    std::vector<Amount> passing(points_.size() + 1);
    for (std::size_t j = 0; j < classes_.size(); ++j) {
      Amount largest;
      particles_(j, [&](const Enclosure &e, const Integer &count) {
        const Amount size = units_.size(e);
        const Amount volume = units_.volume(size, count);
        volumes_[j] += volume;
        passing[certain_point(size.hi)].lo += volume.lo;
        passing[possible_point(size.lo)].hi += volume.hi;
        if (size.hi > largest.hi)
          largest = size;
      });
      total_ += volumes_[j];
      result.largest.push_back(volumes_[j].hi == 0 ? Interval(0)
                                                   : share(units_.volume(largest, 1), volumes_[j]));
    }
    assert(total_.hi > 0); // there is a particle
    set_errors(result);
    set_regression(result, passing);
    set_coefficients(result);
    return result;
  }

private:
  std::size_t certain_point(const Integer &size) const {
    return static_cast<std::size_t>(
        std::partition_point(points_.begin(), points_.end(), [&](const Amount &p) { return p.lo < size; }) -
        points_.begin());
  }
  std::size_t possible_point(const Integer &size) const {
    return static_cast<std::size_t>(
        std::partition_point(points_.begin(), points_.end(), [&](const Amount &p) { return p.hi < size; }) -
        points_.begin());
  }

  void set_errors(SetQuality &result) const {
    result.worst_error = Rational(0);
    for (std::size_t j = 0; j < classes_.size(); ++j) {
      result.shares.push_back(exact_shares_ ? Interval((*exact_shares_)[j]) : share(volumes_[j], total_));
      const Real &wanted = classes_[j].volume_fraction;
      const Interval error =
          absolute(result.shares.back() -
                   (exact_shares_ && wanted.fraction() ? Interval(*wanted.fraction()) : interval(wanted)));
      result.worst_error = greater(result.worst_error, error);
    }
  }

  void set_regression(SetQuality &result, const std::vector<Amount> &passing) const {
    Interval deviations = Rational(0), squares = Rational(0);
    Amount passed;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      passed += passing[i];
      const bool is_end = i + 1 == points_.size(); // of the classes too, rounded or not: all have passed
      const Interval found = is_end ? Interval(1) : share(passed, total_);
      deviations = deviations + square(found - interval(curve_.passing(sizes_[i])));
      squares = squares + square(found);
    }
    result.c_r = square_root(deviations / squares);
  }

  void set_coefficients(SetQuality &result) const {
    const Interval d10 = diameter(ratio(1, 10)), d30 = diameter(ratio(3, 10)), d60 = diameter(ratio(6, 10));
    result.c_u = d60 / d10;
    result.c_c = d30 * d30 / (d60 * d10);
  }

  /// The particles of a class, ascending.
  std::vector<Sized> sorted(std::size_t j) const {
    std::vector<Sized> all;
    particles_(j, [&](const Enclosure &e, const Integer &count) {
      const Amount size = units_.size(e);
      all.push_back({size, units_.volume(size, count)});
    });
    const auto below = [](const Sized &a, const Sized &b) { return a.size.lo < b.size.lo; };
    if (!std::is_sorted(all.begin(), all.end(), below))
      std::sort(all.begin(), all.end(), below);
    return all;
  }

  Interval diameter(const Rational &p) const {
    return exact_shares_ ? diameter_in_known_class(p) : diameter_in_found_class(p);
  }

  /// Classes tell exactly in which of them the size is.
  Interval diameter_in_known_class(const Rational &p) const {
    Rational below = 0;
    std::size_t j = 0;
    for (; below + (*exact_shares_)[j] < p; ++j)
      below += (*exact_shares_)[j];
    const Rational part = (p - below) / (*exact_shares_)[j];
    const std::vector<Sized> all = sorted(j);
    if (part == 1 || all.size() == 1)
      return units_.in_lengths(all.back().size);
    Amount passed, size;
    bool begun = false;
    for (const Sized &particle : all) {
      passed += particle.volume;
      if (!begun && Rational(passed.hi) >= part * Rational(volumes_[j].lo)) {
        size.lo = particle.size.lo;
        begun = true;
      }
      size.hi = particle.size.hi;
      if (Rational(passed.lo) >= part * Rational(volumes_[j].hi))
        break;
    }
    return units_.in_lengths(size);
  }

  Interval diameter_in_found_class(const Rational &p) const {
    const Rational possible = p * Rational(total_.lo), certain = p * Rational(total_.hi);
    Amount before, size;
    bool begun = false;
    for (std::size_t j = 0; j < classes_.size(); ++j) {
      if (Rational(before.hi + volumes_[j].hi) < possible) {
        before += volumes_[j];
        continue;
      }
      for (const Sized &particle : sorted(j)) {
        before += particle.volume;
        if (!begun && Rational(before.hi) >= possible) {
          size.lo = particle.size.lo;
          begun = true;
        }
        size.hi = particle.size.hi;
        if (Rational(before.lo) >= certain)
          return units_.in_lengths(size);
      }
    }
    return units_.in_lengths(size);
  }

  const ModelCurve &curve_;
  const std::vector<SizeClass> &classes_;
  const ParticlesOf &particles_;
  const std::optional<std::vector<Rational>> &exact_shares_;
  Units units_;
  std::vector<CurveSize> sizes_; // at which curves are compared
  std::vector<Amount> points_;   // the same
  std::vector<Amount> volumes_;  // of the classes
  Amount total_;
};

} // namespace

SetQuality set_quality(const ModelCurve &curve, const std::vector<SizeClass> &classes, unsigned dimension,
                       unsigned points, const ParticlesOf &particles,
                       const std::optional<std::vector<Rational>> &exact_shares) {
  return Quality(curve, classes, dimension, points, particles, exact_shares).run();
}

Real real_in(const Interval &i) {
  if (i.is_point())
    return Real(i.lo);
  return Real([i](unsigned bits) { return hull(Ball(i.lo, bits), Ball(i.hi, bits)); });
}

} // namespace mdm
