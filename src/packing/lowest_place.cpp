// The lowest place without a walk along all of the surface (src/packing/README.md, second picture). What
// comes in is the front, which grows, and the radius of the next disc; what goes out is the place that
// lowest_on_whole_surface has.
//
// Separators, discs on whose tops every disc of the set can lie, cut the surface into blocks, and no place
// in a block depends on what is beyond its ends. For each block and each class of radii, within a factor of
// 1.4, there is a bound. Invariant: no disc of the class can have its bottom lower in the block. It holds
// when it is made, of the least radius of the class, because a smaller disc fits into a larger one at its
// bottom; and it stays true, because discs that are added only take room.
//
// To find a place, the block with the least bound is taken: if something has changed in it, its bound is
// made anew by a walk for the least radius of the class, else a walk for the disc finds its place there.
// That ends when the least bound is above the bottom of the best place. A disc that is laid may be a new
// separator, which splits its block, and may hide others, whose blocks are joined with those before them.

#include "packing/lowest_place.hpp"

#include <algorithm>

namespace mdm::packing {
namespace {

/// Computed places are within a few units of the true ones; bounds are lower by much more than that.
constexpr double place_slack = 1024;
constexpr double infinite = std::numeric_limits<double>::infinity();
/// The radii of a class are within this factor: with fewer classes more places are looked at, with more of
/// them more bounds are brought up to date. Factors from 1.3 to 2 take much the same time.
constexpr double class_ratio = 1.4;

} // namespace

Rest lowest_on_whole_surface(const Front &front, FloorRule floor, double q) {
  if (!front.periodic())
    return lowest_rest(front, floor, q, front.left_wall(), front.right_wall());
  if (front.is_empty())
    return first_rest(front, floor, q);
  return lowest_rest(front, floor, q, front.highest(), front.highest());
}

LowestPlace::LowestPlace(const Front &front, FloorRule floor, double least_radius, double greatest_radius)
    : front_(front), floor_(floor), least_q_(least_radius + usual_gap),
      greatest_q_(greatest_radius + usual_gap) {
  for (double r = least_radius; r <= greatest_radius; r *= class_ratio)
    classes_.push_back({r, {}, {}});
  if (!front.periodic())
    split(0, front.left_wall());
}

LowestPlace::Class &LowestPlace::class_of(double r) {
  const auto above = std::upper_bound(classes_.begin(), classes_.end(), r,
                                      [](double radius, const Class &c) { return radius < c.radius; });
  return *std::prev(above);
}

Rest LowestPlace::look(std::size_t block, double q) const {
  const bool is_last = !front_.periodic() && blocks_[block].next == 0;
  return lowest_rest(front_, floor_, q, blocks_[block].begin,
                     is_last ? front_.right_wall() : blocks_[blocks_[block].next].begin);
}

Rest LowestPlace::find(double r) {
  if (blocks_.empty())
    return first_rest(front_, floor_, r + usual_gap);
  Class &c = class_of(r);
  Rest best;
  looked_at_.clear();
  for (;;) {
    const auto least = std::min_element(c.bound.begin(), c.bound.end());
    const auto block = static_cast<std::size_t>(least - c.bound.begin());
    if (*least == infinite || (best.is_found() && *least > best.y - (r + usual_gap)))
      break;
    if (c.stale[block] != 0) {
      const double q = c.radius + usual_gap;
      *least = look(block, q).y - q - place_slack;
      c.stale[block] = 0;
      continue;
    }
    const Rest rest = look(block, r + usual_gap);
    if (rest.is_before(best)) {
      best = rest;
      found_ = block;
    }
    looked_at_.emplace_back(block, *least);
    *least = infinite;
  }
  for (const auto &[block, bound] : looked_at_)
    c.bound[block] = bound;
  return best;
}

void LowestPlace::added(Id disc) {
  if (blocks_.empty()) {
    split(0, disc);
    return;
  }
  make_stale(found_);
  if (is_separator(disc))
    split(block_over(front_.x(disc)), disc);
  remove_hidden(disc);
}

bool LowestPlace::is_hidden(Id separator, double dx, Id by) const {
  for (const double q : {least_q_, greatest_q_}) {
    const double near = front_.r(by) + q;
    const double rise = front_.y(separator) + front_.r(separator) + q - front_.y(by);
    if (std::fabs(dx) < near && (rise < 0 || rise * rise + dx * dx < near * near * (1 + 1e-9)))
      return true;
  }
  return false;
}

bool LowestPlace::is_separator(Id disc) const {
  const double x = front_.x(disc);
  if (!front_.periodic() && (x < greatest_q_ || x > front_.width() - greatest_q_))
    return false;
  bool hidden = false;
  front_.each_near(x, greatest_q_,
                   [&](Id j, double dx) { hidden = hidden || (j != disc && is_hidden(disc, dx, j)); });
  return !hidden;
}

std::size_t LowestPlace::block_over(double x) const {
  // Left of all of them is the last one, one period back.
  std::size_t best = 0, last = 0;
  bool found = false;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (begin_x_[i] <= x && (!found || begin_x_[i] > begin_x_[best])) {
      best = i;
      found = true;
    }
    if (begin_x_[i] > begin_x_[last])
      last = i;
  }
  return found ? best : last;
}

void LowestPlace::split(std::size_t block, Id separator) {
  const std::size_t added = blocks_.size();
  begin_x_.push_back(separator == front_.left_wall() ? 0 : front_.x(separator));
  if (added == 0) {
    blocks_.push_back({separator, 0, 0});
  } else {
    const std::size_t next = blocks_[block].next;
    blocks_.push_back({separator, block, next});
    blocks_[block].next = added;
    blocks_[next].previous = added;
    make_stale(block);
  }
  for (Class &c : classes_) {
    c.bound.push_back(added == 0 ? -place_slack : c.bound[block]);
    c.stale.push_back(1);
  }
}

void LowestPlace::remove_hidden(Id by) {
  const double reach = front_.r(by) + greatest_q_;
  for (std::size_t i = blocks_.size(); i > 0; --i) {
    const Id separator = blocks_[i - 1].begin;
    if (separator == by || separator == front_.left_wall())
      continue;
    double dx = std::fabs(begin_x_[i - 1] - front_.x(by));
    if (front_.periodic())
      dx = std::fmin(dx, front_.width() - dx);
    if (dx < reach && is_hidden(separator, dx, by))
      join_previous(i - 1);
  }
}

void LowestPlace::join_previous(std::size_t block) {
  const std::size_t previous = blocks_[block].previous, next = blocks_[block].next;
  if (previous == block) {
    // The highest disc is a separator, whatever else lies.
    blocks_[block].begin = front_.highest();
    begin_x_[block] = front_.x(blocks_[block].begin);
    make_stale(block);
    return;
  }
  blocks_[previous].next = next;
  blocks_[next].previous = previous;
  for (Class &c : classes_)
    c.bound[previous] = std::min(c.bound[previous], c.bound[block]);
  make_stale(previous);
  // The last block takes the free number.
  const std::size_t last = blocks_.size() - 1;
  if (block != last) {
    const auto moved = [&](std::size_t i) { return i == last ? block : i; };
    blocks_[block] = {blocks_[last].begin, moved(blocks_[last].previous), moved(blocks_[last].next)};
    begin_x_[block] = begin_x_[last];
    blocks_[blocks_[block].previous].next = block;
    blocks_[blocks_[block].next].previous = block;
    for (Class &c : classes_) {
      c.bound[block] = c.bound[last];
      c.stale[block] = c.stale[last];
    }
  }
  blocks_.pop_back();
  begin_x_.pop_back();
  for (Class &c : classes_) {
    c.bound.pop_back();
    c.stale.pop_back();
  }
}

void LowestPlace::make_stale(std::size_t block) {
  for (Class &c : classes_)
    c.stale[block] = 1;
}

} // namespace mdm::packing
