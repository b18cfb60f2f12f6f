#pragma once
/// \file
/// What sedimentology says of a gradation, on the phi scale: phi = -log2(size in mm).

#include "soil/fractions.hpp"

#include <string>
#include <vector>

namespace mdm {

/// A number with the word for it.
struct NamedMeasure {
  Available<Real> value;
  std::string word; ///< empty where there is none; `undecided` where 1,200 digits do not tell it from a limit
};

/// Mean, sorting, skewness (positive towards the fines) and kurtosis.
struct PhiMeasures {
  NamedMeasure mean, sorting, skewness, kurtosis;
};

/// A class (above, up_to], or several of one density, in which the mass over the width in phi is greater than
/// in the neighbours.
struct SizeMode {
  RootSize above, up_to; ///< mm
};

/// All measures of a sediment, sizes in mm.
struct SedimentDescription {
  std::string id;
  /// Folk and Ward (1957): mean (phi16 + phi50 + phi84)/3, sorting (phi84 - phi16)/4 + (phi95 - phi5)/6.6,
  /// skewness (phi16 + phi84 - 2 phi50)/(2 (phi84 - phi16)) + (phi5 + phi95 - 2 phi50)/(2 (phi95 - phi5)),
  /// kurtosis (phi95 - phi5)/(2.44 (phi75 - phi25)); phi_p is the size that p percent are coarser than.
  PhiMeasures graphic;
  /// Moments of the classes' middles in phi. Not available where a pan at size 0 holds mass.
  PhiMeasures moments;
  /// Trask (1932): sqrt(D75/D25), and D25 D75/D50^2.
  Available<Real> trask_sorting, trask_skewness;
  std::vector<SizeMode> modes; ///< the highest first
  /// The textures of Folk (1954), Shepard (1954) and the USDA; empty where they are not known.
  std::string folk, shepard, usda;
  std::vector<Fraction> wentworth;
  std::vector<std::string> notes;

  /// True if a word is undecided.
  bool limited() const;
};

/// A number at a limit has the word above it.
SedimentDescription describe_sediment(const Gradation &g, bool extrapolate = false);

} // namespace mdm
