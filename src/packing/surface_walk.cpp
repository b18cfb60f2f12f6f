// The walk along the surface (src/packing/README.md, first picture). What comes in is the front, the radius
// q of a disc with its gap, and where to begin and to end; what goes out is the lowest place between.
//
// The centre of a disc that touches disc j of the front is on the circle of radius r_j + q around it, its
// offset circle. The walk keeps to the outer arcs of these circles: it is on one of them, with free space
// on its left hand, and goes clockwise. The arc ends at the first of: another offset circle, the line q
// above the floor, the line q before the right wall, the end that was given. There it changes over. On the
// way it notes every vertex at which the disc is above and between the two that it touches, and every bare
// piece of the floor. The least height is at one of them: from any other place the disc can go down.
//
// Each arc is passed once, as the boundary of the free space is a simple curve; there are some two for a
// disc of the front. A walk that takes ten times as many is a fault of the program, and says so.

#include "packing/surface_walk.hpp"

#include "packing/offset_circle.hpp"

#include <cmath>
#include <stdexcept>

namespace mdm::packing {
namespace {

/// The walk along the boundary; it is on the circle around a disc, with free space on its left hand.
class Walk {
public:
  Walk(const Front &front, FloorRule floor, double q, Id to) : front_(front), floor_(floor), q_(q), to_(to) {}

  Rest lowest(Id from) {
    if (from == front_.left_wall())
      come_down_left_wall();
    else
      start_on_top(from);
    while (!ended_) {
      leave_disc();
      // Each arc is passed once; there are some two for each disc of the front.
      if (++arcs_ > 1000 + 20 * front_.length())
        throw std::logic_error("a walk along the surface that does not end");
    }
    return best_;
  }

private:
  /// What ends an arc.
  enum class End { none, top, disc, floor, right_wall };

  double reach(Id disc) const { return front_.r(disc) + q_; }

  void take(const Rest &rest) {
    if (rest.is_before(best_))
      best_ = rest;
  }

  void start_on_top(Id disc) {
    arrive(disc, {0, 1}, the_floor, 0);
    may_end_ = false;
  }

  void arrive(Id disc, Vector at, Id previous, double previous_dx) {
    disc_ = disc;
    at_ = at;
    previous_ = previous;
    previous_dx_ = previous_dx;
    may_end_ = true;
  }

  void come_down_left_wall() {
    Id highest = the_floor;
    double top = q_, highest_dx = 0;
    front_.each_near(q_, q_, [&](Id j, double dx) {
      const double y = front_.y(j) + leg(reach(j), dx);
      if (y > top) {
        highest = j;
        top = y;
        highest_dx = dx;
      }
    });
    if (highest == the_floor) {
      cross_floor(q_, front_.left_wall());
      return;
    }
    take(rest_at_left_wall(front_, q_, highest));
    arrive(highest, {-highest_dx / reach(highest), (top - front_.y(highest)) / reach(highest)}, the_floor, 0);
  }

  /// Goes along the arc to its end, and on to the next arc.
  void leave_disc() {
    const double x = front_.x(disc_), y = front_.y(disc_), a = reach(disc_);
    const Clockwise earlier(at_);
    End end = End::none;
    Vector next{};
    Id next_disc = the_floor;
    double next_dx = 0;
    const auto offer = [&](End what, Vector v) {
      if (end != End::none && !earlier(v, next))
        return false;
      end = what;
      next = v;
      return true;
    };
    front_.each_near(x, a + q_, [&](Id j, double dx) {
      const double dy = front_.y(j) - y, b = reach(j);
      if ((j == previous_ && dx == previous_dx_) || (j == disc_ && dx == 0) ||
          dx * dx + dy * dy >= (a + b) * (a + b))
        return;
      const Vector v = meeting({dx, dy}, a, b);
      if (offer(End::disc, {v.x / a, v.y / a})) {
        next_disc = j;
        next_dx = dx;
      }
    });
    if (y - a < q_)
      offer(End::floor, {leg(a, q_ - y) / a, (q_ - y) / a});
    if (!front_.periodic() && x + a > front_.width() - q_)
      offer(End::right_wall, {(front_.width() - q_ - x) / a, leg(a, front_.width() - q_ - x) / a});
    if (disc_ == to_ && may_end_)
      offer(End::top, {0, 1});
    switch (end) {
    case End::none:
      throw std::logic_error("a disc that nothing carries");
    case End::top:
      ended_ = true;
      break;
    case End::disc:
      step_to(next_disc, next_dx, next);
      break;
    case End::floor:
      cross_floor(front_.wrapped(x + std::round(next.x * a)), disc_);
      break;
    case End::right_wall:
      take(rest_at_right_wall(front_, q_, disc_));
      climb_right_wall(y + next.y * a, disc_);
      break;
    }
  }

  void step_to(Id disc, double dx, Vector at) {
    const double a = reach(disc_), b = reach(disc), dy = front_.y(disc) - front_.y(disc_);
    // Where three circles meet in a point, as among equal discs, only two of the discs carry a fourth.
    if (at.x >= 0 && at.x * a <= dx && at.y * dx >= at.x * dy)
      take(rest_on_discs(front_, q_, disc_, disc, dx));
    arrive(disc, {(at.x * a - dx) / b, (at.y * a - dy) / b}, disc_, -dx);
  }

  /// Goes on from a bare piece of the floor that begins at x.
  void cross_floor(double x, Id left) {
    const Id after = front_.next(front_.before_bare_floor(x));
    if (after == front_.right_wall()) {
      take_floor(x, front_.width() - q_ - x, left);
      climb_right_wall(q_, the_floor);
      return;
    }
    // What covers the right end of the piece is above the next disc on the floor, or that disc; what is to
    // the left of the piece does not.
    const double distance = front_.wrapped(front_.x(after) - x);
    double end = std::numeric_limits<double>::infinity();
    Vector at{};
    Id next = after;
    front_.each_near(front_.x(after), q_, [&](Id j, double dx) {
      const double b = reach(j), half = leg(b, front_.y(j) - q_);
      if (dx <= -distance || std::fabs(front_.y(j) - q_) >= b || dx - half >= end)
        return;
      end = dx - half;
      at = {-half / b, (q_ - front_.y(j)) / b};
      next = j;
    });
    take_floor(x, std::fmax(0, distance + std::round(end)), left);
    arrive(next, at, the_floor, 0);
  }

  void take_floor(double x, double length, Id left) {
    if (floor_ == FloorRule::left)
      take({x, q_, left, the_floor});
    else
      take({front_.wrapped(x + std::floor(length / 2)), q_, the_floor, the_floor});
  }

  /// Goes up the right wall to the lowest disc that is met there.
  void climb_right_wall(double y, Id from) {
    Id lowest = the_floor;
    double lowest_y = std::numeric_limits<double>::infinity(), lowest_dx = 0;
    front_.each_near(front_.width() - q_, q_, [&](Id j, double dx) {
      const double under = front_.y(j) - leg(reach(j), dx);
      if (j != from && under >= y && under < lowest_y) {
        lowest = j;
        lowest_y = under;
        lowest_dx = dx;
      }
    });
    if (lowest == the_floor)
      ended_ = true;
    else
      arrive(lowest, {-lowest_dx / reach(lowest), (lowest_y - front_.y(lowest)) / reach(lowest)}, the_floor,
             0);
  }

  const Front &front_;
  FloorRule floor_;
  double q_;
  Id to_;
  Rest best_;
  Id disc_ = the_floor, previous_ = the_floor;
  Vector at_{};
  double previous_dx_ = 0;
  bool may_end_ = true, ended_ = false;
  std::size_t arcs_ = 0;
};

} // namespace

Rest first_rest(const Front &front, FloorRule floor, double q) {
  return {floor == FloorRule::left ? q : std::floor(front.width() / 2), q, the_floor, the_floor};
}

Rest lowest_rest(const Front &front, FloorRule floor, double q, Id from, Id to) {
  return Walk(front, floor, q, to).lowest(from);
}

Rest rest_on_discs(const Front &front, double q, Id left, Id right, double dx) {
  const double a = front.r(left) + q, b = front.r(right) + q;
  const Vector v = accurate_meeting({dx, front.y(right) - front.y(left)}, a, b);
  return {front.wrapped(front.x(left) + std::round(v.x)), front.y(left) + std::round(v.y), left, right};
}

Rest rest_at_left_wall(const Front &front, double q, Id disc) {
  return {q, front.y(disc) + std::round(leg(front.r(disc) + q, front.x(disc) - q)), front.left_wall(), disc};
}

Rest rest_at_right_wall(const Front &front, double q, Id disc) {
  const double x = front.width() - q;
  return {x, front.y(disc) + std::round(leg(front.r(disc) + q, x - front.x(disc))), disc, front.right_wall()};
}

} // namespace mdm::packing
