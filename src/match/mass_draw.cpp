// One particle's mass, drawn uniform by volume: intervals of sizes of the same width hold the same mass in
// the mean, so that small particles are drawn more often. What comes in are the ends of a class in parts,
// and 64 random bits, the value of the partition function; what goes out is a number of parts from the
// least to the most. Its inverse is taken by integer roots, never by doubles: the draw is the same on every
// machine.

#include "match/mass_draw.hpp"

#include <algorithm>
#include <cassert>

namespace mdm {
MassDraw::MassDraw(Integer least, Integer most, const MassLaw &law)
    : least_(std::move(least)), most_(std::move(most)), law_(law) {
  assert(least_ > 0 && least_ <= most_);
  if (most_ > least_) // V is about 1 + (most - least) / most
    places_ += static_cast<unsigned>(bit_length(most_) - bit_length(Integer(most_ - least_)));
  if (law_.a == law_.b) {
    Integer root = floor_div(Integer(most_ << places_), least_);
    for (unsigned bit = 0; bit < 64; ++bit) {
      root = floor_root(Integer(root << places_), 2);
      roots_.push_back(root);
    }
    return;
  }
  // u/l = (most / least)^(b/a), so V = (most / least)^((a-b)/a), and the mass is most V^(-a/(a-b)).
  const bool steep = law_.a > law_.b;
  const unsigned m = steep ? law_.a - law_.b : law_.b - law_.a;
  const Integer above = power(steep ? most_ : least_, m), below = power(steep ? least_ : most_, m);
  top_ = floor_root(floor_div(Integer(above << (places_ * law_.a)), below), law_.a);
  scaled_ = power(most_, m) << (steep ? places_ * law_.a : 0);
}

Integer MassDraw::operator()(std::uint64_t r) const {
  return std::min(std::max(drawn(r), least_), most_);
}

Integer MassDraw::drawn(std::uint64_t r) const {
  if (law_.a == law_.b) {
    Integer mass = least_;
    for (std::size_t k = 0; k < roots_.size(); ++k)
      if ((r >> (63 - k) & 1) != 0)
        mass = Integer(mass * roots_[k]) >> places_;
    return mass;
  }
  const Integer one = Integer(1) << places_;
  const Integer y = (Integer(r) << 1) + 1;
  // A right shift rounds towards zero; V - 1 < 0 for a < b.
  const Integer way = Integer(y * abs(Integer(top_ - one))) >> 65;
  const Integer v = top_ > one ? Integer(top_ - way) : Integer(top_ + way);
  if (law_.a > law_.b)
    return floor_root(floor_div(scaled_, power(v, law_.a)), law_.a - law_.b);
  return floor_root(Integer(Integer(scaled_ * power(v, law_.a)) >> (places_ * law_.a)), law_.b - law_.a);
}

} // namespace mdm
