// A deposit of discs. What comes in are radii on the lattice, in an order of their own or shuffled; what
// goes out is a centre for each, and the two that carry it.
//
// Each disc gets a place by the rule, the lowest one or one that it rolls to, on the front of those that
// lie, with a gap of 4 units to all that it touches. The place is rounded to the lattice, and whether the
// disc overlaps with any is decided in 128-bit integers. If it does, rounding took more than the gap, and
// the place is sought again with a gap twice as wide: a wider gap leaves more room, so this ends. Then the
// disc joins the front.
//
// Invariant: no two discs that lie overlap, with radii 2 units larger than written, and the front is the
// chain of discs that bounds them from above. src/packing/README.md has the pictures.

#include "packing/deposit.hpp"

#include "packing/lattice.hpp"
#include "packing/lowest_place.hpp"
#include "packing/roll.hpp"
#include "packing/shuffled.hpp"
#include "packing/wide.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>
#include <memory>

namespace mdm {
namespace {

using packing::Front;
using packing::Id;
using packing::Lattice;
using packing::LowestPlace;
using packing::Rest;
using packing::usual_gap;
using packing::Wide;

/// What radii are larger in the geometry than written: the doubles of two centres and radii are off by less
/// than the 4 units that two discs have so.
constexpr double margin = 2;

std::vector<double> enlarged(const std::vector<std::int64_t> &radii) {
  std::vector<double> r;
  r.reserve(radii.size());
  for (const std::int64_t radius : radii)
    r.push_back(static_cast<double>(radius) + margin);
  return r;
}

std::int64_t whole(double units) {
  return static_cast<std::int64_t>(units);
}

/// A deposit that grows.
class Deposit {
public:
  Deposit(const std::vector<std::int64_t> &radii, const Lattice &lattice, const DepositOptions &options)
      : options_(options), lattice_(lattice), random_(options.seed),
        front_(enlarged(radii), static_cast<double>(lattice.width), options.periodic) {
    const auto [least, greatest] = std::minmax_element(radii.begin(), radii.end());
    if (options.rule == DepositRule::lowest && options.search == DepositSearch::blocks)
      lowest_ = std::make_unique<LowestPlace>(front_, options.floor, static_cast<double>(*least) + margin,
                                              static_cast<double>(*greatest) + margin);
  }

  /// Lays a disc and says where.
  Rest lay(Id disc) {
    Rest rest = place(disc, usual_gap);
    for (double gap = 2 * usual_gap; overlaps(disc, rest); gap *= 2) {
      // Rounding has taken more than the gap: a wider one is kept.
      rest = place(disc, gap);
    }
    if (rest.y + front_.r(disc) > lattice_.highest)
      throw InputError("the deposit is looser than any that is known: give it a wider box");
    front_.insert(disc, rest.x, rest.y, rest.left, rest.right);
    if (lowest_)
      lowest_->added(disc);
    return rest;
  }

  std::int32_t support(Id id) const {
    return id == packing::the_floor    ? Support::on_floor
           : id == front_.left_wall()  ? Support::on_left_wall
           : id == front_.right_wall() ? Support::on_right_wall
                                       : id;
  }

  std::int64_t front() const { return whole(front_.lowest_centre()); }

private:
  Rest place(Id disc, double gap) const {
    const double q = front_.r(disc) + gap;
    if (options_.rule == DepositRule::drop)
      return packing::rolled_rest(front_, q, column(disc, q));
    if (lowest_ && gap == usual_gap)
      return lowest_->find(front_.r(disc));
    return packing::lowest_on_whole_surface(front_, options_.floor, q);
  }

  /// A random place between the walls.
  double column(Id disc, double q) const {
    const double from = options_.periodic ? 0 : q;
    const auto room = static_cast<std::uint64_t>(front_.width() - 2 * from) + (options_.periodic ? 0 : 1);
    const auto bits = random_(packing::column_stream, static_cast<std::uint64_t>(disc));
    return from + static_cast<double>(random_below(room, bits));
  }

  /// Exactly.
  bool overlaps(Id disc, const Rest &rest) const {
    bool any = false;
    front_.each_near(rest.x, front_.r(disc), [&](Id j, double dx) {
      const Wide x = whole(dx), y = whole(front_.y(j) - rest.y);
      const Wide sum = whole(front_.r(j) + front_.r(disc));
      any = any || x * x + y * y < sum * sum;
    });
    return any;
  }

  const DepositOptions &options_;
  const Lattice &lattice_;
  Philox random_;
  Front front_;
  std::unique_ptr<LowestPlace> lowest_;
};

} // namespace

Packing deposit(const DiscSizes &sizes, const DepositOptions &options) {
  const Lattice lattice = packing::lattice(sizes, options.width);
  std::vector<std::int64_t> radii;
  radii.reserve(sizes.sizes.size());
  for (const DiscSize &size : sizes.sizes)
    radii.push_back(DiscSizes::radius(size, lattice.places));
  if (options.shuffled)
    packing::shuffle(radii, options.seed);
  Packing p;
  p.unit = sizes.unit;
  p.places = lattice.places;
  p.width = lattice.width;
  p.periodic = options.periodic;
  p.rule = options.rule;
  p.floor = options.floor;
  p.seed = options.seed;
  p.discs.reserve(radii.size());
  Deposit deposit(radii, lattice, options);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const Rest rest = deposit.lay(static_cast<Id>(i));
    p.discs.push_back(
        {whole(rest.x), whole(rest.y), radii[i], deposit.support(rest.left), deposit.support(rest.right)});
    if (options.progress)
      options.progress(i + 1);
  }
  p.front = deposit.front();
  return p;
}

} // namespace mdm
