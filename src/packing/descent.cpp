// Which way a body goes down. What comes in are the normals n of all that it touches; what goes out is the
// direction d of length 1 nearest to straight down among those with d . n >= 0 for each, or that there is
// none.
//
// The nearest point of a cone is on one of its faces, and a face is what some of the contacts leave. So all
// sets of none, one and two contacts are tried in this order: the way is what they leave of straight down,
// they have to press, and it must lead into no other contact. The first that does is the nearest, as each
// further contact takes more of the way. If none does, three contacts whose pressures are not negative hold
// the body: it rests. On the top of one, or of the edge between two, pressures balance and nothing holds it
// to the side: there it tips off.

#include "packing/descent.hpp"

namespace mdm::packing {
namespace {

constexpr Vector3 down{0, 0, -1};

/// The search for what carries.
class Carriers {
public:
  Carriers(const std::vector<Vector3> &normals, double slight) : normals_(normals), slight_(slight) {}

  Descent found() {
    if (is_carried_by_none() || is_carried_by_one() || is_carried_by_two())
      return d_;
    const std::vector<std::size_t> three = three_that_hold();
    if (three.empty() && (tips_off_one() || tips_off_two()))
      return d_;
    d_ = {true, {}, three};
    return d_;
  }

private:
  double pressure(const Vector3 &normal) const { return -dot(down, normal); }

  bool leads_into_none(Vector3 way) const {
    for (const Vector3 &n : normals_)
      if (dot(n, way) < -slight_)
        return false;
    return true;
  }

  /// The way, if a length is left of it and it leads into no contact.
  bool is_way(Vector3 way, std::vector<std::size_t> carried) {
    const double left = length(way);
    if (left <= slight_ || !leads_into_none((1 / left) * way))
      return false;
    d_ = {false, (1 / left) * way, std::move(carried)};
    return true;
  }

  bool is_carried_by_none() { return is_way(down, {}); }

  /// Down, less what one contact takes.
  bool is_carried_by_one() {
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      const double p = pressure(normals_[i]);
      if (p > 0 && is_way(down + p * normals_[i], {i}))
        return true;
    }
    return false;
  }

  /// Down, less what two take: both press.
  bool is_carried_by_two() {
    for (std::size_t i = 0; i < normals_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Vector3 &a = normals_[i], &b = normals_[j];
        const double cosine = dot(a, b);
        const Vector3 edge = cross(a, b);
        const double sine2 = dot(edge, edge);
        if (sine2 > slight_ && pressure(a) - cosine * pressure(b) >= 0 &&
            pressure(b) - cosine * pressure(a) >= 0 && is_way((dot(down, edge) / sine2) * edge, {i, j}))
          return true;
      }
    return false;
  }

  /// Balanced on the top of one: any way off it.
  bool tips_off_one() {
    for (std::size_t i = 0; i < normals_.size(); ++i)
      if (normals_[i].z > 1 - slight_)
        for (const Vector3 way : {Vector3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}})
          if (is_way(way, {i}))
            return true;
    return false;
  }

  /// Balanced on two, on the top of the way along both: down either of its sides.
  bool tips_off_two() {
    for (std::size_t i = 0; i < normals_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Vector3 edge = cross(normals_[i], normals_[j]);
        if (length(edge) > slight_ && (is_way(edge, {i, j}) || is_way(-1 * edge, {i, j})))
          return true;
      }
    return false;
  }

  /// Three whose pressures, none of them negative, hold the body.
  std::vector<std::size_t> three_that_hold() const {
    for (std::size_t i = 0; i < normals_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k) {
          const Vector3 &a = normals_[i], &b = normals_[j], &c = normals_[k];
          const double volume = dot(a, cross(b, c)), sign = volume < 0 ? -1 : 1;
          if (sign * volume > slight_ && sign * cross(b, c).z >= -slight_ &&
              sign * cross(c, a).z >= -slight_ && sign * cross(a, b).z >= -slight_)
            return {k, j, i};
        }
    return {};
  }

  const std::vector<Vector3> &normals_;
  double slight_;
  Descent d_;
};

} // namespace

Descent descent(const std::vector<Vector3> &normals, double slight) {
  return Carriers(normals, slight).found();
}

} // namespace mdm::packing
