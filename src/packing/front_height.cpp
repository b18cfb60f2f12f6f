// The front of a deposit that is read from a file. What comes in are discs in the order of their deposit
// with what carries each; what goes out is the height of the lowest centre that nothing covers.
//
// The discs are laid again in their order. Invariant: the surface is the chain of those that nothing
// covers, from wall to wall or around one period. A disc comes behind the one on its left and before the
// one on its right, and what is between them is covered for good. Each disc comes in once and goes out
// once, so the cost is some steps a disc, plus the search for a bare piece of the floor. A support that is
// covered, or that does not come before the other, ends it without an answer: the file is no deposit in
// this order.

#include "packing/front_height.hpp"

#include <algorithm>
#include <limits>

namespace mdm::packing {
namespace {

/// The chain of discs that bounds a deposit from above, from wall to wall or around one period. A member may
/// have a bare piece of the floor behind it.
class Surface {
public:
  explicit Surface(const Packing &p)
      : p_(p), left_wall_(p.discs.size()), right_wall_(left_wall_ + 1), members_(right_wall_ + 1) {
    if (p.periodic)
      return;
    link(left_wall_, right_wall_, true);
    members_[left_wall_].is_on = members_[right_wall_].is_on = true;
    first_ = left_wall_;
  }

  /// Lays the next disc. False if its supports are not on the surface, or not in this order.
  bool lay(std::size_t disc) {
    const PackedDisc &d = p_.discs[disc];
    if (p_.periodic && disc == 0) {
      link(0, 0, true);
      members_[0].is_on = true;
      return d.left == on_floor && d.right == on_floor;
    }
    const bool on_bare_floor = d.left == on_floor || d.right == on_floor;
    const std::size_t bare = on_bare_floor ? before_bare_floor(d.x) : 0;
    if (bare == nowhere)
      return false;
    const std::size_t after = d.left == on_floor ? bare : member(d.left);
    const std::size_t before = d.right == on_floor ? members_[bare].next : member(d.right);
    if (!members_[after].is_on || !members_[before].is_on || !cover(after, before))
      return false;
    link(after, disc, d.left == on_floor);
    link(disc, before, d.right == on_floor);
    members_[disc].is_on = true;
    if (p_.periodic)
      first_ = disc;
    return true;
  }

  std::int64_t lowest_centre() const {
    std::int64_t lowest = std::numeric_limits<std::int64_t>::max();
    for (std::size_t i = 0; i < p_.discs.size(); ++i)
      if (members_[i].is_on)
        lowest = std::min(lowest, p_.discs[i].y);
    return lowest;
  }

private:
  static constexpr std::size_t nowhere = SIZE_MAX;

  struct Member {
    std::size_t next = 0;
    bool is_bare = false; ///< the floor behind it
    bool is_on = false;   ///< nothing covers it
  };

  std::size_t member(std::int32_t support) const {
    return support == on_left_wall    ? left_wall_
           : support == on_right_wall ? right_wall_
                                      : static_cast<std::size_t>(support);
  }

  void link(std::size_t left, std::size_t right, bool is_bare) {
    members_[left].next = right;
    members_[left].is_bare = is_bare;
  }

  /// Takes what is between two members off the surface. False if one does not come behind the other.
  bool cover(std::size_t after, std::size_t before) {
    if (after == right_wall_)
      return false;
    for (std::size_t i = members_[after].next; i != before; i = members_[i].next) {
      if (i == after || i == right_wall_)
        return false;
      members_[i].is_on = false;
    }
    return true;
  }

  std::int64_t x(std::size_t i) const {
    return i == left_wall_ ? 0 : i == right_wall_ ? p_.width : p_.discs[i].x;
  }

  /// The member behind which the floor is bare at x; nowhere if there is none.
  std::size_t before_bare_floor(std::int64_t at) const {
    for (std::size_t i = first_;;) {
      const std::size_t next = members_[i].next;
      std::int64_t length = x(next) - x(i), off = at - x(i);
      if (p_.periodic) {
        length += length <= 0 ? p_.width : 0;
        off += off < 0 ? p_.width : 0;
      }
      if (members_[i].is_bare && off >= 0 && off < length)
        return i;
      if (next == first_ || next == right_wall_)
        return nowhere;
      i = next;
    }
  }

  const Packing &p_;
  std::size_t left_wall_, right_wall_;
  std::vector<Member> members_;
  std::size_t first_ = 0;
};

} // namespace

std::optional<std::int64_t> front_height(const Packing &packing) {
  Surface surface(packing);
  for (std::size_t i = 0; i < packing.discs.size(); ++i)
    if (!surface.lay(i))
      return std::nullopt;
  return surface.lowest_centre();
}

} // namespace mdm::packing
