#pragma once
/// \file
/// Apollonian packings: a circle filled by circles that touch, without end.

#include "number/real.hpp"
#include "packing/packing.hpp"

#include <mdm/number/interval.hpp>

#include <array>
#include <functional>

namespace mdm {

/// A circle of a gasket: its curvature is k = p + q sqrt 3, its centre, from that of the outer circle, (x /
/// k, y / k) by a common factor of the gasket (ApollonianGasket::centre).
struct ApollonianCircle {
  std::int64_t p, q, x, y;

  bool operator==(const ApollonianCircle &) const = default;
};

/// What is known of the circles with curvatures up to T, without the outer one.
struct ApollonianCensus {
  std::uint64_t circles = 0;
  Interval inverse_squares;           ///< sum 1 / k^2
  std::vector<std::uint64_t> octaves; ///< circles with T / 2^(j+1) < k <= T / 2^j, from j = 0 on
};

/// A gasket: four circles that touch each other, and all that follow from them. Three circles have two others
/// that touch all of them; with w a curvature, or a curvature times a centre, w' = 2 (w1 + w2 + w3) - w
/// (Descartes; Lagarias, Mallows, Wilks 2002). Each circle comes once.
class ApollonianGasket {
public:
  /// The most that a curvature can be.
  static constexpr std::int64_t most_curvature = 1000000000000;

  /// Around three circles of radius 1.
  static ApollonianGasket equal();
  /// Of four whole curvatures, the outer circle's below 0.
  /// \throws InputError if they do not satisfy Descartes' relation, are not reduced (the reduced ones are
  /// named), hold a 0, or are beyond 10^6
  static ApollonianGasket integral(const std::array<Integer, 4> &curvatures);

  /// The outer circle's curvature, below 0.
  Real outer_curvature() const;
  /// The curvature of a circle.
  Real curvature(const ApollonianCircle &c) const;
  /// x or y of a circle as a real number.
  Real centre_x(const ApollonianCircle &c) const;
  Real centre_y(const ApollonianCircle &c) const;
  /// centre_x = x / (scale k), and centre_y the same, by sqrt 3 less in the gasket of equal circles.
  std::int64_t scale() const { return scale_; }

  /// Hands on all circles with k <= most, but for the outer one, in some order. Constant memory.
  /// \throws InputError if most is beyond most_curvature
  void each(const Rational &most, const std::function<void(const ApollonianCircle &)> &take) const;

  /// Counts them; some 20 ns a circle. `progress` is told their number now and then.
  ApollonianCensus census(const Rational &most,
                          const std::function<void(std::uint64_t)> &progress = nullptr) const;

  /// The share of the outer circle that they cover.
  Interval covered(const ApollonianCensus &census) const;

  /// The circles on a lattice, the outer one's box as the packing's; radii are 2 units smaller than rounded
  /// down, so that none overlap.
  /// \throws InputError if there are more than 10^7, or the smallest has fewer than 2^16 units
  Packing packing(const Rational &most) const;

private:
  ApollonianGasket(std::array<ApollonianCircle, 4> root, std::int64_t scale, bool surd)
      : root_(root), scale_(scale), surd_(surd) {}

  std::array<ApollonianCircle, 4> root_; ///< the outer one first
  std::int64_t scale_;
  bool surd_; ///< curvatures are in Z[sqrt 3]
};

/// The slope of log N over log k between two counts an octave apart: an estimate of the gasket's dimension,
/// 1.30568... \pre 0 < half <= all
Real apollonian_slope(std::uint64_t all, std::uint64_t half);

} // namespace mdm
