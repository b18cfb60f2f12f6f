#pragma once
/// \file
/// The numbers of one gradation in Arnold's table and figures.

#include "match/published.hpp"
#include "soil/indices.hpp"
#include "soil/uscs.hpp"

#include <mdm/gradation/gradation.hpp>

namespace mdm {

/// Numbers of particles of spheres: the least match, and what the published algorithms return. These have
/// nothing where they do not reach their end.
struct SurveyCounts {
  Integer exact; ///< N_MDM, proved
  /// SI with x_nS at the middle of its class alone, as the paper's code ran it.
  std::optional<Integer> spanned_integer;
  /// SI as printed: 100 sizes x_nS from 0.001 of the class to its upper sieve.
  std::optional<Integer> spanned_integer_printed;
  std::optional<Integer> fixed_size; ///< FS with sizes at the middle, total error up to 1 %
  Integer rounded;                   ///< S_approx (Eq. 18) with sizes at the middle
  /// Iterations that SI mid-class, SI as printed and FS took.
  std::size_t middle_iterations = 0, printed_iterations = 0, fixed_size_iterations = 0;
};

/// One gradation of the study.
struct SurveyRow {
  std::string id;
  std::vector<Rational> sizes;   ///< X_G in mm
  std::vector<Rational> passing; ///< share that passes each
  Rational finest_share;         ///< of the mass, in the finest class with mass; the paper's "percent fines"
  Available<Real> c_u, c_c, i_gs, i_c;
  Rational phi_1, zeta_1;
  Available<UscsGroup> group; ///< of the fines: low-plasticity silt
  SurveyCounts counts;
};

/// Cost: a few milliseconds for 10 classes.
SurveyRow survey(const Gradation &g);

/// The two runs that Figure 2 compares, with sizes at the middle: SI, and FS with a total error up to 1 %.
struct Convergence {
  std::string id;
  Published spanned_integer, fixed_size;
};

/// Runs both algorithms.
Convergence convergence(const Gradation &g);

} // namespace mdm
