#pragma once
/// \file
/// Spheres in their places, as a file has them.

#include <mdm/number/rational.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// A box with sides along the axes.
struct SpaceBox {
  std::array<Rational, 3> low, high;

  Rational side(std::size_t axis) const { return high[axis] - low[axis]; }
  Rational volume() const { return side(0) * side(1) * side(2); }
  bool is_empty() const { return side(0) <= 0 || side(1) <= 0 || side(2) <= 0; }
};

/// Centres and diameters of spheres: as doubles close to what the file says, and exactly.
/// Memory: some 250 bytes a sphere.
class SphereSample {
public:
  /// Three decimals, with `.` or `,` as their sign.
  using Place = std::array<std::string_view, 3>;
  /// The group of a sphere that is in none.
  static constexpr std::uint32_t no_group = UINT32_MAX;

  /// \param unit  length of the unit of places, the same for all spheres
  /// \throws InputError if a coordinate is no decimal, or beyond 1e60, or the diameter is not from 1e-60 to 1e60
  /// \pre diameter > 0
  void add(const Place &place, const Rational &unit, const Rational &diameter, std::uint32_t group);

  std::size_t size() const { return diameters_.size(); }
  /// True if four or more, of sizes that differ, have their centres in a plane across an axis: spheres on a
  /// floor have not, discs have.
  bool is_of_discs() const;
  std::uint32_t group(std::size_t i) const { return groups_[i]; }

  /// Doubles, cut towards 0: within 2^-52 of the exact values, relatively.
  const std::array<double, 3> &centre(std::size_t i) const { return centres_[i]; }
  double radius(std::size_t i) const { return radii_[i]; }
  /// The greatest absolute value among them.
  double greatest() const { return greatest_; }

  Rational exact_coordinate(std::size_t i, std::size_t axis) const;
  const Rational &exact_diameter(std::size_t i) const { return diameters_[i]; }

private:
  std::vector<std::array<double, 3>> centres_;
  std::vector<double> radii_;
  std::vector<Rational> diameters_;
  std::vector<std::uint32_t> groups_;
  Rational unit_ = 1;
  std::string text_;                 ///< coordinates as the file has them, a space behind each
  std::vector<std::uint64_t> begin_; ///< of each sphere's
  double greatest_ = 0;
};

/// The double that r is cut to towards 0.
double cut_double(const Rational &r);

} // namespace mdm
