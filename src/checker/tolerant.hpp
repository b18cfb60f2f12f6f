#pragma once

#include "verify.hpp"

#include <array>
#include <map>

// What a tree of section 6 is about: the problem in integers, and the bounds on counts that are in force.
namespace mdm::checker::tolerant {

/// The shares that belong to a class: the bounds on t_j / M and on P_j / M, g_j, and 1 / c_j.
enum Share : std::size_t { r, R, p, P, g, weight, shares };

/// Class j in integers: f_j and F_j in mass units, the shares in share units; q_j >= least.
struct Class {
  mpz_class f, F, least;
  std::array<mpz_class, shares> share;
};

/// A mass t is the integer t * mass_unit where it is compared with f or F.
struct Problem {
  std::vector<Class> classes; ///< class j at j - 1
  mpz_class mass_unit, share_unit;
  mpz_class half_total; ///< e / 2 in share units
  mpq_class w;          ///< least sum of t / c of every match
};

/// Of the particles in some classes; most is -1 where there is no bound.
struct Bounds {
  mpz_class least = 0, most = -1;
};

/// The bounds in force on counts.
struct CountsInForce {
  std::vector<Bounds> classes;         ///< of class j at j - 1
  std::map<ClassRange, Bounds> ranges; ///< of the classes i to j, i < j
  Bounds of(const ClassRange &range) const {
    const auto found = ranges.find(range);
    return found == ranges.end() ? Bounds{} : found->second;
  }
};

/// n and N have the right sides max(1, M') and -(B - 1).
mpz_class least_of_all(const Certificate &certificate);
mpz_class minus_most_of_all(const Certificate &certificate);

} // namespace mdm::checker::tolerant
