// The front of a deposit: the discs that bound it from above as a chain from wall to wall, or around one
// period, with a note where the floor is bare behind one. A disc that is laid on two members is linked
// between them, and what was between is taken out: nothing can reach it any more. Each disc comes in once
// and goes out once.
//
// To find what is near a place, members stand in buckets by x, in one row of buckets for radii within a
// factor of 2, so that a search looks at some of each row, however different the radii are.

#include "packing/front.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace mdm::packing {

Front::Front(std::vector<double> radii, double width, bool periodic)
    : discs_(static_cast<Id>(radii.size())), width_(width), periodic_(periodic), first_(discs_),
      x_(radii.size()), y_(radii.size()), r_(std::move(radii)), next_(x_.size() + 2), bare_(x_.size() + 2),
      smallest_(*std::min_element(r_.begin(), r_.end())) {
  make_rows();
  if (!periodic_)
    link(left_wall(), right_wall(), true);
}

void Front::make_rows() {
  std::vector<std::size_t> members;
  for (const double r : r_) {
    const auto row = static_cast<std::size_t>(std::ilogb(r / smallest_));
    members.resize(std::max(members.size(), row + 1));
    ++members[row];
  }
  double greatest = smallest_;
  for (const std::size_t n : members) {
    greatest *= 2;
    // Some two buckets for each disc of the row that is in the chain.
    const double wanted = 2 * static_cast<double>(n) / std::sqrt(static_cast<double>(r_.size())) + 1;
    const double buckets = std::max(1.0, std::floor(std::min(wanted, width_ / (2 * greatest))));
    rows_.push_back({greatest, width_ / buckets, {}});
    rows_.back().buckets.resize(static_cast<std::size_t>(buckets));
  }
}

std::vector<Id> &Front::bucket_of(Id disc) {
  Row &row = rows_[static_cast<std::size_t>(std::ilogb(r(disc) / smallest_))];
  const auto at = static_cast<std::size_t>(x(disc) / row.bucket);
  return row.buckets[std::min(at, row.buckets.size() - 1)];
}

Id Front::highest() const {
  const Id begin = periodic_ ? first_ : next(first_);
  Id best = begin;
  for (Id i = next(begin); i != begin && !is_wall(i); i = next(i)) {
    const double rise = (y(i) + r(i)) - (y(best) + r(best));
    if (rise > 0 || (rise == 0 && i < best))
      best = i;
  }
  return best;
}

double Front::lowest_centre() const {
  double lowest = std::numeric_limits<double>::infinity();
  Id i = first_;
  do {
    if (!is_wall(i))
      lowest = std::min(lowest, y(i));
    i = next(i);
  } while (i != first_ && i != right_wall());
  return lowest;
}

double Front::distance_right(Id from, Id to) const {
  const double a = from == left_wall() ? 0 : x(from), b = to == right_wall() ? width_ : x(to);
  return periodic_ && b <= a ? b - a + width_ : b - a;
}

Id Front::before_bare_floor(double x) const {
  for (Id i = first_;;) {
    if (bare_[index(i)] != 0) {
      const double from = i == left_wall() ? 0 : this->x(i);
      if (wrapped(x - from) >= 0 && wrapped(x - from) < distance_right(i, next(i)))
        return i;
    }
    i = next(i);
    if (i == first_ || i == right_wall())
      throw std::logic_error("a disc on a floor that is covered");
  }
}

void Front::insert(Id disc, double x, double y, Id left, Id right) {
  const bool on_floor = left == the_floor || right == the_floor;
  if (is_empty() && periodic_) {
    first_ = disc;
    link(disc, disc, true);
  } else {
    const Id bare = on_floor ? before_bare_floor(x) : the_floor;
    const Id after = left == the_floor ? bare : left, before = right == the_floor ? next(bare) : right;
    remove_between(after, before);
    link(after, disc, left == the_floor);
    link(disc, before, right == the_floor);
    if (periodic_)
      first_ = disc;
  }
  x_[index(disc)] = x;
  y_[index(disc)] = y;
  bucket_of(disc).push_back(disc);
  ++length_;
}

void Front::remove_between(Id after, Id before) {
  for (Id i = next(after); i != before; i = next(i)) {
    if (i == after || is_wall(i))
      throw std::logic_error("supports that are not in the order of the chain");
    std::vector<Id> &bucket = bucket_of(i);
    *std::find(bucket.begin(), bucket.end(), i) = bucket.back();
    bucket.pop_back();
    --length_;
  }
}

void Front::link(Id left, Id right, bool bare_floor) {
  next_[index(left)] = right;
  bare_[index(left)] = bare_floor ? 1 : 0;
}

} // namespace mdm::packing
