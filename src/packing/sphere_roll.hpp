#pragma once
/// \file
/// A sphere that is dropped and rolls to rest.

#include "packing/descent.hpp"
#include "packing/side_planes.hpp"
#include "packing/sphere_grid.hpp"

namespace mdm::packing {

/// Where a sphere comes to rest.
struct SphereRest {
  Vector3 at; ///< outside the first period, maybe
  std::array<std::int32_t, 3> supports{no_sphere_support, no_sphere_support, no_sphere_support};

  bool is_found() const { return supports.front() != no_sphere_support; }
};

/// The way of one sphere: it falls, and slides down the steepest way on one or two that it touches, until
/// three, or the floor, carry it. All ways on spheres and planes are lines and circles, on which it is known
/// where the next is met.
class SphereRoll {
public:
  /// \param q the sphere's radius with its gap
  SphereRoll(const SphereGrid &grid, const std::vector<SidePlane> &sides, double q)
      : grid_(grid), sides_(sides), q_(q), slight_(4 / q), stride_(q / 2) {}

  /// Drops it in the column (x, y).
  SphereRest from(double x, double y);

private:
  /// What the sphere touches: another one, or a plane, that is a SphereSupport.
  struct Contact {
    std::int32_t id;
    Vector3 centre; ///< of the sphere's image
    double reach;   ///< between the centres
    Vector3 normal; ///< of the plane

    bool is_plane() const { return id < 0; }
    bool operator==(const Contact &) const = default;
  };

  /// A circle from the sphere's place on, in the plane of two directions: middle + radius (cos forward0 + sin
  /// forward).
  struct Circle {
    Vector3 middle, outwards, forward;
    double radius;

    Vector3 at(double cosine, double sine) const {
      return middle + radius * (cosine * outwards + sine * forward);
    }
  };

  /// How far along a circle, as cosine and sine; a turn at most.
  struct Turn {
    double cosine, sine;

    bool comes_before(const Turn &other) const;
  };

  /// The end of a slide.
  struct End {
    Turn turn;
    enum { stride, met, left } how = stride;
    Contact met_contact{};   ///< where one is met
    std::size_t left_by = 0; ///< the contact that is left
  };

  Vector3 normal(const Contact &c) const;
  Contact floor() const { return {sphere_on_floor, {}, q_, {0, 0, 1}}; }
  bool is_touched(std::int32_t id, const Vector3 &centre) const;
  void fall();
  void slide(const Descent &d);
  Circle circle(const Descent &d) const;
  void end_where_left(const Descent &d, const Circle &c, End &end) const;
  void end_where_met(const Descent &d, const Circle &c, End &end) const;
  void end_at_plane(const Circle &c, const Contact &plane, double offset, End &end) const;
  void move_on(const Descent &d, const Circle &c, const End &end);
  SphereRest rest(const std::vector<std::size_t> &carried) const;

  const SphereGrid &grid_;
  const std::vector<SidePlane> &sides_;
  double q_;
  double slight_; ///< cosines up to this one are rounding: some units in the place
  double stride_; ///< the length of way that is looked at at once
  Vector3 at_;
  std::vector<Contact> contacts_;
};

} // namespace mdm::packing
