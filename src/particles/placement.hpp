#pragma once
/// \file
/// A start for a simulation: places for all particles of a set, none of which overlap.

#include "packing/sphere_deposit.hpp"
#include "particles/kept_places.hpp"
#include "particles/particle_set.hpp"

#include <array>
#include <cstdint>
#include <functional>

namespace mdm {

/// The most particles that simulations can have: programs count them in 32 bits.
inline constexpr std::uint64_t most_simulated = 2147483647;
/// \throws InputError if the set has more
void check_simulated(const ParticleSet &set);

/// The ground that particles start on; lengths in the unit of the set.
struct Footprint {
  Rational a, b;             ///< the sides
  std::optional<Rational> c; ///< height that must do; open: as high as the start needs
  /// Layers have walls, a mixed start walls or a cylinder, of which a and b are the diameter.
  Sides sides = Sides::walls;
  /// The centres of a mixed start are in the plane in the middle of b: of discs.
  bool is_flat = false;
};

/// The square that fits into a circle of that diameter, its side cut to 15 digits.
Footprint inscribed_square(const Rational &diameter);

/// A box with sides in the ratios of these, in which a mixed start has room; in the unit of the set.
Footprint roomy_box(const ParticleSet &set, const std::array<Rational, 3> &ratios);

/// A height of a box for insertion at random places, largest first, without overlaps: each try finds a place
/// with a chance of a fifth or more, because what particles keep free of others' centres is at most four
/// fifths of where centres can be. \pre x and y are more than the largest size; all in the unit of the set
double insertion_height(const ParticleSet &set, double x, double y);

/// The same of discs in a plane that is x wide: they keep at most four fifths of it free. \pre x is more than
/// the largest size
double disc_insertion_height(const ParticleSet &set, double x);

/// A plane in which discs are about as high as wide once they have settled, and three of the largest lie side
/// by side.
Footprint disc_plane(const ParticleSet &set);
/// A plane of that width, and of that height where there is one.
Footprint disc_plane(const ParticleSet &set, const Rational &width, const std::optional<Rational> &height);

/// Side of a square on which a set is about as high as wide once it has settled, and in which the two largest
/// lie side by side.
double settled_side(const ParticleSet &set);

/// The square on which a deposit is about as high as wide, and least_widths of the largest wide or more.
Footprint deposit_square(const ParticleSet &set);

/// The arrangement in which particles start.
enum class Start {
  layers,  ///< a slab for each class
  mixed,   ///< at random places of the whole box, inserted the largest first
  deposit, ///< dropped in random order and columns, and rolled to rest: see deposit_spheres()
  as_is    ///< where the particles of a file lie
};

/// Is told how many particles of a deposit lie.
using StartProgress = std::function<void(std::size_t)>;

/// A start: loose and tall, or deposited. All lengths are integers in units of u = 10^-places(), some 10^-3
/// to 10^-4 of the smallest size (of a deposit down to 10^-10), and below 2^52. In layers classes are slabs,
/// the largest at the bottom. A slab is a grid of cells of the same sides; a particle of a class takes a cell
/// of its slab, and a place in it, which a hash of the seed chooses: no two take the same cell, and no place
/// is nearer to a side of its cell than R, the class's largest radius as a double, rounded up to units,
/// plus 2.
///
/// No two particles overlap, as doubles and as decimals. Their cells differ; on an axis where they do, the
/// decimals of the places are R + R' >= r + r' + 4 or more apart, and so the particles are. A double is
/// within 2^-53 of its decimal, relatively, which is half a unit at most: the doubles of the places are r +
/// r' + 3 or more apart, and so are the decimals with the decimals of the radii. In the same way all are
/// inside the box.
///
/// Mixed, a particle is put where no centre is within R + R' of its own, decided in integers: the distance of
/// doubles is the same at least; so is the distance from the axis of a cylinder. The box is
/// insertion_height() high, by 4 / pi more for a cylinder. In a deposit too, decided in integers, with an R
/// for each size; the box is as high as its highest particle.
///
/// Cost: each() takes some 100 ns a particle. Layers need memory that does not depend on their number, a
/// mixed start some 80 bytes and a us or two a particle, a deposit some 200 bytes and 100 us or more.
class Placement {
public:
  /// Powers of ten up to this one are doubles: n / 10^places is then the double nearest to the decimal.
  static constexpr unsigned most_places = 22;

  /// A particle with its centre, in units.
  struct Sphere {
    std::size_t class_index; ///< in the set
    const ParticleSize *size;
    std::array<std::int64_t, 3> at;
  };

  /// \param set must outlive the placement
  /// \param floor open: a square, so that layers are about as high as wide, or a mixed start will be once it
  /// has settled
  /// \param progress of a deposit
  /// \throws InputError if there are more than most_simulated particles, the largest is wider than the footprint, the
  /// start is higher than it may be, or lengths are too far apart for doubles; for a deposit if there are
  /// more than most_deposited, or the footprint is narrower than least_widths of the largest
  Placement(const ParticleSet &set, const std::optional<Footprint> &floor, std::uint64_t seed,
            Start start = Start::layers, const StartProgress &progress = {});
  Placement(ParticleSet &&set, const std::optional<Footprint> &floor, std::uint64_t seed) = delete;
  /// The places of a file, rounded to some 10^-9 of the smallest size or less; they may overlap.
  /// \param is_repeated  the box is repeated as that of the file; else as the sides say
  /// \throws InputError as above
  Placement(const ParticleSet &set, const KeptPlaces &places, Sides sides, bool is_repeated);

  const ParticleSet &set() const { return *set_; }
  /// The box is [0, a] x [0, b] x [0, height], in units.
  const std::array<std::int64_t, 3> &box() const { return box_; }
  /// The box's sides; a cylinder stands in the box and touches its sides.
  Sides sides() const { return sides_; }
  /// The axes along which the box is repeated.
  std::array<bool, 3> repeated() const;
  /// `, repeated in x and y`; empty of a box that is not.
  std::string repeated_text() const;
  /// True if the places are those of a file.
  bool is_kept() const { return is_kept_; }
  unsigned places() const { return places_; }
  /// A length in units as a decimal.
  std::string text(std::int64_t units) const;

  /// Gives all particles, the largest class first and its sizes descending; the same at every call.
  void each(const std::function<void(const Sphere &)> &take) const;

  /// True if all centres are in a plane, of discs.
  bool is_flat() const { return is_flat_; }
  /// Volume of the box by that of the particles, or of discs area by area, by their diameters and by their
  /// radii, minus 1: lower and upper bound.
  std::pair<Rational, Rational> void_ratio() const;

private:
  /// The grid of a class.
  struct Slab {
    std::size_t class_index;
    std::int64_t radius;              ///< R
    std::array<std::int64_t, 3> cell; ///< sides
    std::array<std::uint64_t, 3> n;   ///< cells along each axis
    std::int64_t base;                ///< height of the bottom
  };

  void choose_unit();
  std::int64_t units(const Rational &length) const;
  std::int64_t radius(const ParticleClass &c) const;
  std::int64_t radius(const ParticleSize &size) const;
  void set_height(const Footprint &floor);
  void choose_floor(const std::optional<Footprint> &floor);
  void choose_mixed_box(const std::optional<Footprint> &floor);
  bool is_in_circle(const std::array<std::int64_t, 3> &centre, std::int64_t r) const;
  void mix();
  Footprint deposit_ground(const std::optional<Footprint> &floor) const;
  void choose_deposit_unit(const Footprint &ground);
  void refine_unit(const Rational &longest);
  void list_in_order(std::vector<std::int64_t> &radii);
  void deposit(const std::optional<Footprint> &floor, const StartProgress &progress);
  void add_slab(std::size_t class_index);
  Sphere place(const Slab &slab, const ParticleSize &size, std::uint64_t i) const;

  const ParticleSet *set_;
  std::uint64_t seed_;
  unsigned places_ = 0;
  std::array<std::int64_t, 3> box_{};
  Sides sides_ = Sides::walls;
  std::optional<std::array<bool, 3>> kept_repeated_; ///< of a file's box
  bool is_kept_ = false, is_flat_ = false;
  std::vector<Slab> slabs_;     ///< of layers
  std::vector<Sphere> spheres_; ///< of all starts but layers
};

} // namespace mdm
