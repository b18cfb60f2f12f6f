#pragma once
/// \file
/// The smallest representative set whose class masses are exact.

#include <mdm/grading/class_counts.hpp>
#include <mdm/match/solve.hpp>

namespace mdm {

/// Classes as a gradation: bounds and volume fractions rounded to decimals of `digits` significant digits, id
/// `id`. From there on these decimals are what is matched.
/// \throws InputError if two bounds become the same decimal
Gradation rounded_gradation(const std::vector<SizeClass> &classes, unsigned digits, const std::string &id);

/// The least match of such a gradation with N_pc particles in each class with volume and N_min in all, by the
/// law x^D.
/// \throws InputError as solve
Match matched_set(const Gradation &rounded, const Representativity &wanted, const SolveOptions &options);

} // namespace mdm
