#pragma once
/// \file
/// The smallest representative set whose class masses are exact.

#include "match/spread.hpp"
#include "sets/class_counts.hpp"
#include "sets/set_quality.hpp"

#include <mdm/match/solve.hpp>

namespace mdm {

/// Classes as a gradation: bounds and volume fractions rounded to decimals of `digits` significant digits, id
/// `id`. From there on these decimals are what is matched.
/// \throws InputError if two bounds become the same decimal, or a decimal would be beyond what is read
Gradation rounded_gradation(const std::vector<SizeClass> &classes, unsigned digits, const std::string &id);

/// What is wanted of a match of the gradation, with N_pc so large that no particle is more than P of its
/// class: of particles of one size 1 / P; of a spread, where it may be of any size of the class (l, u], (u /
/// l)^D / P of the class for which that is most.
/// \throws InputError if sizes are spread in a class that begins at 0
Representativity of_match(Representativity wanted, const Gradation &rounded, bool is_spread);

/// The least match of such a gradation with N_pc particles in each class with volume and N_min in all, by the
/// law x^D.
/// \throws InputError as solve
Match matched_set(const Gradation &rounded, const Representativity &wanted, const SolveOptions &options);

/// The same set with room for a spread. Its N is the smallest with which, besides, the mean volume of every
/// class's particles can be at most that of sizes uniform by volume, mu, and more than (V(lower bound) + mu)
/// / 2: that of the least match of classes cut at these two sizes, rounded down to `size_digits` digits, of
/// which `complete` speaks. These N particles are shared out anew so that the means are as near to mu as
/// whole numbers let them (uniform_counts); a note says how near. Drawn sizes then need little correction
/// (Theorem 16). Question, window and sizes are those of the classes as they are.
/// \throws InputError as solve
Match roomy_set(const Gradation &rounded, const Representativity &wanted, const SolveOptions &options,
                unsigned size_digits);

/// The particles of a complete match without a tolerance; it must outlive them.
ParticlesOf matched_particles(const Match &m);

/// Those of a spread of it (spread.hpp), of a size each.
/// \throws InputError as spread
ParticlesOf spread_particles(const Match &m, std::uint64_t seed);

/// The quality of such a match: its shares are exactly those of its gradation, which are the f_v that it is
/// compared with.
SetQuality matched_quality(const Match &m, const ModelCurve &curve, unsigned dimension, unsigned points,
                           const ParticlesOf &particles);

} // namespace mdm
