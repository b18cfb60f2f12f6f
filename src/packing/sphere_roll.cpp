// The way of one sphere that is dropped (src/packing/README.md, third picture). What comes in are the
// spheres that lie, in a grid, the sides, the radius q with its gap, and the column; what goes out is where
// it rests and on which three.
//
// It falls to the first that it meets. Then, turn by turn: descent() says which way it goes down and which
// of those that it touches carry it, one or two. Its centre moves on a circle: around the centre of one, or
// around the line between the centres of two (or of one and along a plane). The turn ends at the first of:
// it meets another sphere, a side, or the floor; one of those that carry presses no more, as the component
// of its weight towards that is 0; or a stride of the way is over, so that only spheres nearby need be
// looked at. All three are where a cos + b sin reaches a number, which a square root answers. With nothing
// that carries it falls again.
//
// Each turn leads down, but for rounding, so that no place comes back. 20,000 turns, some hundred times as
// many as a sphere takes, are a way that rounding does not let end: the sphere has no place then, and is
// dropped again.

#include "packing/sphere_roll.hpp"

#include <optional>

namespace mdm::packing {
namespace {

/// What is so near is touched: more than rounding takes, in units.
constexpr double touching = 32;
/// Turns after which a sphere stays where it is: some hundred times as many as it takes.
constexpr int most_turns = 20000;

} // namespace

bool SphereRoll::Turn::comes_before(const Turn &other) const {
  const bool late = sine < 0, other_late = other.sine < 0;
  return late != other_late ? other_late : cosine * other.sine - sine * other.cosine > 0;
}

namespace {

/// The first turn (cosine, sine) at which a cosine + b sine grows beyond k; nothing if there is none, or one
/// has been there already and is on the way out. Lengths in units.
/// \param slight growth by a radian up to this is rounding
std::optional<std::pair<double, double>> first_beyond(double a, double b, double k, double slight) {
  const double m2 = a * a + b * b;
  if (a - k >= -touching && b > slight)
    return std::pair(1.0, 0.0);
  if (m2 <= slight * slight)
    return std::nullopt;
  if (m2 <= k * k)
    return std::nullopt;
  const double h = std::sqrt(m2 - k * k);
  return std::pair((k * a + h * b) / m2, (k * b - h * a) / m2);
}

} // namespace

SphereRest SphereRoll::from(double x, double y) {
  at_ = {x, y, std::numeric_limits<double>::infinity()};
  fall();
  std::vector<Vector3> normals;
  for (int turns = 0; turns < most_turns; ++turns) {
    if (contacts_.back().id == sphere_on_floor)
      return rest({contacts_.size() - 1});
    normals.clear();
    for (const Contact &c : contacts_)
      normals.push_back(normal(c));
    const Descent d = descent(normals, slight_);
    if (d.rests)
      return rest(d.carried);
    if (d.carried.empty())
      fall();
    else
      slide(d);
  }
  return {at_, {no_sphere_support, no_sphere_support, no_sphere_support}};
}

Vector3 SphereRoll::normal(const Contact &c) const {
  return c.is_plane() ? c.normal : direction(at_ - c.centre);
}

bool SphereRoll::is_touched(std::int32_t id, const Vector3 &centre) const {
  return std::any_of(contacts_.begin(), contacts_.end(),
                     [&](const Contact &c) { return c.id == id && c.centre == centre; });
}

/// Down to the highest sphere that is met, or to the floor; what is touched here is not met again.
void SphereRoll::fall() {
  Contact below = floor();
  double height = q_;
  if (at_.z <= q_ + touching) {
    at_.z = q_;
    contacts_ = {below};
    return;
  }
  grid_.each_below(at_, q_, [&](std::int32_t id, const Vector3 &centre) {
    const double reach = grid_.radius(id) + q_, dx = centre.x - at_.x, dy = centre.y - at_.y;
    const double rise2 = reach * reach - dx * dx - dy * dy;
    if (rise2 <= 0)
      return height;
    const double z = centre.z + std::sqrt(rise2);
    if (z > height && z <= at_.z + touching && !is_touched(id, centre)) {
      height = z;
      below = {id, centre, reach, {}};
    }
    return height;
  });
  at_.z = std::min(at_.z, height);
  contacts_ = {below};
}

SphereRoll::Circle SphereRoll::circle(const Descent &d) const {
  // One of the two that carry is a sphere: planes alone are upright and carry nothing.
  const bool first_is_plane = contacts_[d.carried.front()].is_plane();
  const Contact &a = contacts_[first_is_plane ? d.carried.back() : d.carried.front()];
  Circle c{a.centre, {}, d.way, a.reach};
  if (d.carried.size() == 2) {
    const Contact &b = contacts_[first_is_plane ? d.carried.front() : d.carried.back()];
    const Vector3 between = b.centre - a.centre;
    const Vector3 axis = b.is_plane() ? b.normal : direction(between);
    const double distance = length(between);
    const double along = b.is_plane() ? dot(at_ - a.centre, axis)
                                      : (distance + (a.reach - b.reach) * (a.reach + b.reach) / distance) / 2;
    c.middle = a.centre + along * axis;
    c.radius = std::sqrt(std::max(1.0, (a.reach - along) * (a.reach + along)));
  }
  // Across the way, exactly: neither rounding nor the way's length adds up.
  const Vector3 outwards = at_ - c.middle;
  c.outwards = direction(outwards - dot(outwards, d.way) * d.way);
  return c;
}

void SphereRoll::slide(const Descent &d) {
  const Circle c = circle(d);
  const double chord = std::min(stride_ / c.radius, 1.0);
  const double cosine = 1 - chord * chord / 2;
  End end{{cosine, std::sqrt(1 - cosine * cosine)}};
  end_where_left(d, c, end);
  end_where_met(d, c, end);
  move_on(d, c, end);
}

/// One of those that carry is left where it presses no more.
void SphereRoll::end_where_left(const Descent &d, const Circle &c, End &end) const {
  const auto pressed = [&](std::size_t one, std::optional<std::size_t> other) {
    const Contact &i = contacts_[d.carried[one]];
    if (i.is_plane())
      return;
    // The pressure is n_z - cos n'_z for normals n and n' at an angle: linear in the place.
    double part = 0, from_z = 0;
    if (other && !contacts_[d.carried[*other]].is_plane()) {
      const Contact &j = contacts_[d.carried[*other]];
      part = dot(normal(i), normal(j)) * i.reach / j.reach;
      from_z = j.centre.z;
    }
    const double a = -c.radius * c.outwards.z * (1 - part), b = -c.radius * c.forward.z * (1 - part);
    const double k = c.middle.z - i.centre.z - part * (c.middle.z - from_z);
    const auto turn = first_beyond(a, b, k, slight_ * i.reach);
    if (turn && Turn{turn->first, turn->second}.comes_before(end.turn))
      end = {{turn->first, turn->second}, End::left, {}, d.carried[one]};
  };
  pressed(0, d.carried.size() == 2 ? std::optional<std::size_t>(1) : std::nullopt);
  if (d.carried.size() == 2)
    pressed(1, 0);
}

void SphereRoll::end_at_plane(const Circle &c, const Contact &plane, double offset, End &end) const {
  const auto turn =
      first_beyond(-c.radius * dot(c.outwards, plane.normal), -c.radius * dot(c.forward, plane.normal),
                   dot(c.middle, plane.normal) - offset, slight_ * c.radius);
  if (turn && Turn{turn->first, turn->second}.comes_before(end.turn))
    end = {{turn->first, turn->second}, End::met, plane, 0};
}

void SphereRoll::end_where_met(const Descent &d, const Circle &c, End &end) const {
  const auto carries = [&](const Contact &other) {
    return std::any_of(d.carried.begin(), d.carried.end(),
                       [&](std::size_t i) { return contacts_[i] == other; });
  };
  end_at_plane(c, floor(), q_, end);
  for (const SidePlane &side : sides_) {
    const Contact plane{sphere_on_side, {}, q_, side.normal};
    if (side.gap(at_, q_) < stride_ + touching && !carries(plane))
      end_at_plane(c, plane, side.offset + q_, end);
  }
  grid_.each_near(at_, q_, stride_ + touching, 2 * touching, [&](std::int32_t id, const Vector3 &centre) {
    const Contact other{id, centre, grid_.radius(id) + q_, {}};
    const Vector3 w = centre - c.middle;
    const double far = other.reach + c.radius;
    if (dot(w, w) >= far * far || carries(other))
      return;
    const double k = (dot(w, w) + (c.radius - other.reach) * (c.radius + other.reach)) / (2 * c.radius);
    const auto turn = first_beyond(dot(c.outwards, w), dot(c.forward, w), k, slight_ * other.reach);
    if (turn && Turn{turn->first, turn->second}.comes_before(end.turn))
      end = {{turn->first, turn->second}, End::met, other, 0};
  });
}

void SphereRoll::move_on(const Descent &d, const Circle &c, const End &end) {
  const Vector3 before = at_;
  at_ = c.at(end.turn.cosine, end.turn.sine);
  if (end.how == End::left && d.carried.size() == 1) {
    contacts_ = {contacts_[end.left_by]};
    return fall();
  }
  const double moved = length(at_ - before);
  std::vector<Contact> kept;
  // Where it has not moved, all that it touches may turn the way.
  for (std::size_t i = 0; i < contacts_.size(); ++i)
    if ((moved <= touching || std::find(d.carried.begin(), d.carried.end(), i) != d.carried.end()) &&
        !(end.how == End::left && end.left_by == i))
      kept.push_back(contacts_[i]);
  if (end.how == End::met && std::find(kept.begin(), kept.end(), end.met_contact) == kept.end())
    kept.push_back(end.met_contact);
  contacts_ = std::move(kept);
  constexpr double least_part = 64;
  stride_ = end.how == End::stride ? std::min(2 * stride_, q_)
                                   : std::max({stride_ / 2, std::min(2 * moved, stride_), q_ / least_part});
}

SphereRest SphereRoll::rest(const std::vector<std::size_t> &carried) const {
  SphereRest r{at_};
  for (std::size_t i = 0; i < carried.size(); ++i)
    r.supports[i] = contacts_[carried[i]].id;
  return r;
}

} // namespace mdm::packing
