#pragma once
/// \file
/// The numbers of particles, class by class, that make a representative set.

#include "sets/size_classes.hpp"

#include <mdm/text/error.hpp>

namespace mdm {

/// The criteria of a representative set.
struct Representativity {
  Integer min_per_class = 10; ///< N_pc >= 1
  Integer at_least = 2000;    ///< N_min >= 1
  unsigned dimension = 3;     ///< D: 2, discs, or 3, spheres
  /// P: the most that one particle may be of the volume of its class (criterion 2 of section 1.2), 0 < P <=
  /// 1; nothing: any part.
  std::optional<Rational> largest_share{};
};

/// Numbers of particles; vectors have an entry for each class, 0 where the class has no volume.
struct ClassCounts {
  std::size_t scarcest = 0; ///< the class that sets the others: with the least n (Eq. 7), which gets N_pc
  std::vector<IntegerBounds> estimate; ///< N' (Eq. 8); lo < hi where 4096 bits do not decide the floor
  std::vector<Integer> numbers;        ///< N (Eq. 9); empty where an N' is not decided

  bool decided() const { return !numbers.empty(); }
  /// sum N'.
  IntegerBounds estimated() const;
  /// sum N; with Eq. 9 it may be less than N_min, by less than the number of classes.
  Integer particles() const;
};

/// A class would need more than 10^1000 particles.
struct TooManyParticles : InputError {
  using InputError::InputError;
};

/// d_m^p, p = D - 1, with d_m = F^-1(1/2) the median size of the class, uniform by volume: 2 (l u)^p / (l^p +
/// u^p).
Real median_power(const SizeClass &c, unsigned dimension);

/// The least number of particles of a class with volume: N_pc, and with P as many that a particle of the
/// upper bound is at most P of N V(d_m), as Eq. 7 counts the volume of the class: ceil((u / d_m)^D / P), or
/// one more where 4096 bits do not decide it.
Integer least_in_class(const SizeClass &c, const Representativity &wanted);

/// n = f_v / V(d_m) (Eq. 7), N' = floor(N_pc n / min n) (Eq. 8) and, where sum N' < N_min, N = floor(N_min /
/// sum N' N') (Eq. 9). Every floor is decided: with fractions, by refining, and where that leaves two
/// integers in the field of the bounds (Surd), to the power p: in dimension 3 squares are compared.
/// \throws TooManyParticles if a count has more than 1000 digits
/// \throws InputError if no class has volume, or one has so little that it cannot be told from 0
ClassCounts class_counts(const std::vector<SizeClass> &classes, const ModelCurve &curve,
                         const Representativity &wanted);

/// The cost of the floors of Eq. 8-9: the largest error of a class's share by volume if all its particles
/// were of size d_m.
/// \pre counts are decided
Real rounding_cost(const std::vector<SizeClass> &classes, const ClassCounts &counts, unsigned dimension);

/// max(sum N', N_min) <= N_max: the set can be had with N_max particles (Fig. 8). Nothing if not decided.
std::optional<bool> is_accessible(const ClassCounts &counts, const Representativity &wanted,
                                  const Integer &at_most);

} // namespace mdm
