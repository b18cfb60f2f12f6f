// A disc that is dropped (Visscher, Bolsterli 1972). What comes in is the front, the disc's radius with its
// gap, and the column; what goes out is where it rests and on what.
//
// It falls straight down to the first disc that it meets. On that it rolls down, its centre on the offset
// circle, until the arc ends: at another disc, between which and the first it rests if its centre is
// farther on, and over which it rolls on if not; at a wall or the floor, where it rests; or at the side of
// the disc, where it falls again. Each arc leads down, so none is passed twice, and their number is bounded
// by the discs of the front. Where it rolls to the left the picture is turned over, so that there is one
// way to roll.

#include "packing/roll.hpp"

#include "packing/offset_circle.hpp"

#include <stdexcept>

namespace mdm::packing {
namespace {

/// The way of one disc. It rolls to the right in a picture that is turned over where it rolls to the left:
/// `side_` is 1 or -1, and all x are multiplied by it.
class Roll {
public:
  Roll(const Front &front, double q) : front_(front), q_(q) {}

  Rest from(double x) {
    fall(x, std::numeric_limits<double>::infinity(), the_floor);
    for (std::size_t arcs = 0; !rest_.is_found(); ++arcs) {
      if (arcs > 1000 + 20 * front_.length())
        throw std::logic_error("a disc that rolls for ever");
      roll_on();
    }
    return rest_;
  }

private:
  /// What ends an arc.
  enum class End { edge, disc, floor, wall };

  double reach(Id disc) const { return front_.r(disc) + q_; }

  /// Down from y at x, to the floor or the first disc that is met, but for the one it comes from.
  void fall(double x, double y, Id from) {
    Id highest = the_floor;
    double top = q_, highest_dx = 0;
    front_.each_near(x, q_, [&](Id j, double dx) {
      const double height = front_.y(j) + leg(reach(j), dx);
      if (j != from && height <= y && height > top) {
        highest = j;
        top = height;
        highest_dx = dx;
      }
    });
    if (highest == the_floor) {
      rest_ = {x, q_, the_floor, the_floor};
      return;
    }
    side_ = highest_dx <= 0 ? 1 : -1;
    disc_ = highest;
    at_ = {-highest_dx * side_ / reach(highest), (top - front_.y(highest)) / reach(highest)};
    previous_ = the_floor;
  }

  void roll_on() {
    const double x = front_.x(disc_), y = front_.y(disc_), a = reach(disc_);
    const Clockwise earlier(at_);
    End end = End::edge;
    Vector next{1, 0};
    Id next_disc = the_floor;
    double next_dx = 0;
    front_.each_near(x, a + q_, [&](Id j, double dx) {
      const double dy = front_.y(j) - y, b = reach(j);
      if ((j == previous_ && dx == previous_dx_) || (j == disc_ && dx == 0) ||
          dx * dx + dy * dy >= (a + b) * (a + b))
        return;
      const Vector v = meeting({dx * side_, dy}, a, b);
      const Vector direction{v.x / a, v.y / a};
      if (!earlier(direction, next))
        return;
      end = End::disc;
      next = direction;
      next_disc = j;
      next_dx = dx;
    });
    if (std::fabs(q_ - y) < a) {
      const Vector direction{leg(a, q_ - y) / a, (q_ - y) / a};
      if (earlier(direction, next)) {
        end = End::floor;
        next = direction;
      }
    }
    const double to_wall = side_ > 0 ? front_.width() - q_ - x : x - q_;
    if (!front_.periodic() && to_wall < a) {
      const Vector direction{to_wall / a, leg(a, to_wall) / a};
      if (earlier(direction, next)) {
        end = End::wall;
        next = direction;
      }
    }
    switch (end) {
    case End::edge:
      fall(front_.wrapped(x + side_ * a), y, disc_);
      break;
    case End::disc:
      meet(next_disc, next_dx, next);
      break;
    case End::floor:
      rest_ = {front_.wrapped(x + side_ * std::round(next.x * a)), q_, side_ > 0 ? disc_ : the_floor,
               side_ > 0 ? the_floor : disc_};
      break;
    case End::wall:
      rest_ = side_ > 0 ? rest_at_right_wall(front_, q_, disc_) : rest_at_left_wall(front_, q_, disc_);
      break;
    }
  }

  /// Rests between two discs, or rolls on over the second.
  void meet(Id disc, double dx, Vector at) {
    const double a = reach(disc_), b = reach(disc), dy = front_.y(disc) - front_.y(disc_);
    if (dx * side_ >= at.x * a) {
      rest_ = side_ > 0 ? rest_on_discs(front_, q_, disc_, disc, dx)
                        : rest_on_discs(front_, q_, disc, disc_, -dx);
      return;
    }
    previous_ = disc_;
    previous_dx_ = -dx;
    at_ = {(at.x * a - dx * side_) / b, (at.y * a - dy) / b};
    disc_ = disc;
  }

  const Front &front_;
  double q_, side_ = 1;
  Id disc_ = the_floor, previous_ = the_floor;
  double previous_dx_ = 0;
  Vector at_{};
  Rest rest_;
};

} // namespace

Rest rolled_rest(const Front &front, double q, double x) {
  return Roll(front, q).from(x);
}

} // namespace mdm::packing
