// Whether a packing that is read is a deposit of a set. Decided in integers, and independent of how the
// packing came to be: radii are those of the set, each as often; no two discs overlap; all are in the box;
// each touches its two supports within the tolerance and has its centre between them; and laid again in
// their order (front_height.cpp) they have the front that the file says. What cannot be seen from places,
// such as the seed, is named as not verified.

#include "packing/packing_verdict.hpp"

#include "packing/front_height.hpp"
#include "packing/packing_writer.hpp"
#include "packing/wide.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

using packing::Wide;

/// From a disc's centre to what carries it.
struct Direction {
  std::int64_t x, y;
  std::int64_t touch; ///< the distance at which both touch
};

class Judge {
public:
  Judge(const Packing &packing, std::int64_t tolerance) : p_(packing), tolerance_(tolerance) {}

  /// What is wrong with disc i; empty if nothing.
  std::string objection(std::size_t i) const {
    const PackedDisc &d = p_.discs[i];
    const bool inside = p_.periodic ? d.x < p_.width : d.x >= d.r && d.x + d.r <= p_.width;
    if (!inside || d.y < d.r)
      return "is not inside the box";
    if (p_.rule == DepositRule::apollonian)
      return d.left == unsupported && d.right == unsupported ? "" : "is carried, as no circle of a gasket is";
    const Direction left = direction(d, d.left), right = direction(d, d.right);
    if (!touches(left) || !touches(right))
      return "does not touch what carries it";
    if (left.x > 0 || right.x < 0 || Wide{left.x} * right.y < Wide{left.y} * right.x)
      return "is not above and between what carries it";
    return "";
  }

private:
  bool touches(const Direction &to) const {
    const Wide far = to.touch + tolerance_;
    return to.touch > 0 && Wide{to.x} * to.x + Wide{to.y} * to.y <= far * far;
  }

  /// A touch of 0 where nothing carries it.
  Direction direction(const PackedDisc &d, std::int32_t support) const {
    switch (support) {
    case on_floor:
      return {0, -d.y, d.r};
    case on_left_wall:
      return {-d.x, 0, d.r};
    case on_right_wall:
      return {p_.width - d.x, 0, d.r};
    case unsupported:
      return {0, 0, 0};
    default:
      break;
    }
    const PackedDisc &other = p_.discs[static_cast<std::size_t>(support)];
    std::int64_t dx = other.x - d.x;
    if (p_.periodic && 2 * dx > p_.width)
      dx -= p_.width;
    else if (p_.periodic && 2 * dx < -p_.width)
      dx += p_.width;
    return {dx, other.y - d.y, d.r + other.r};
  }

  const Packing &p_;
  std::int64_t tolerance_;
};

std::vector<std::int64_t> sorted_radii(const Packing &p) {
  std::vector<std::int64_t> radii;
  for (const PackedDisc &d : p.discs)
    radii.push_back(d.r);
  std::sort(radii.begin(), radii.end());
  return radii;
}

std::vector<std::int64_t> sorted_radii(const DiscSizes &sizes, unsigned places) {
  std::vector<std::int64_t> radii;
  for (const DiscSize &size : sizes.sizes)
    radii.push_back(DiscSizes::radius(size, places));
  std::sort(radii.begin(), radii.end());
  return radii;
}

/// What is wrong with the front of the header, of a packing without other faults; empty if nothing.
std::string front_objection(const Packing &p) {
  if (p.discs.empty())
    return "";
  if (p.rule == DepositRule::apollonian)
    return p.front == 0 ? "" : "its front is not 0, as that of a gasket is";
  const std::optional<std::int64_t> front = packing::front_height(p);
  if (!front)
    return "its discs cannot be laid in this order: what carries one is covered by then";
  return p.front == *front
             ? ""
             : fmt::format("its front is {}, and the lowest centre of the discs that nothing covers "
                           "is at {}",
                           p.front, *front);
}

} // namespace

std::vector<std::string> packing_objections(const Packing &p, const PackingContacts &contacts,
                                            const DiscSizes &sizes) {
  std::vector<std::string> all;
  if (p.unit != sizes.unit)
    all.push_back(fmt::format("its lengths are in {}, those of the set in {}",
                              p.unit.empty() ? "any unit" : p.unit,
                              sizes.unit.empty() ? "any unit" : sizes.unit));
  if (p.discs.size() != sizes.sizes.size())
    all.push_back(fmt::format("it has {} discs, the set {}", p.discs.size(), sizes.sizes.size()));
  else if (sorted_radii(p) != sorted_radii(sizes, p.places))
    all.emplace_back("its radii are not half the sizes of the set, rounded up to its lattice");
  if (contacts.first_overlap)
    all.push_back(fmt::format("{} pairs of discs overlap, first {} and {}", contacts.overlaps,
                              contacts.first_overlap->first, contacts.first_overlap->second));
  const Judge judge(p, contacts.tolerance);
  std::size_t wrong = 0;
  std::string first;
  for (std::size_t i = 0; i < p.discs.size(); ++i)
    if (const std::string objection = judge.objection(i); !objection.empty() && wrong++ == 0)
      first = fmt::format("disc {} {}", i, objection);
  if (wrong > 0)
    all.push_back(wrong == 1 ? first
                             : fmt::format("{}, and {} more discs have such faults", first, wrong - 1));
  if (all.empty())
    if (const std::string objection = front_objection(p); !objection.empty())
      all.push_back(objection);
  return all;
}

std::vector<std::string> unverified(const Packing &p) {
  const std::string rule = fmt::format("rule {}", name(p.rule));
  if (p.rule == DepositRule::apollonian)
    return {rule};
  return {rule, fmt::format("floor {}", name(p.floor)), fmt::format("seed {}", p.seed)};
}

} // namespace mdm
