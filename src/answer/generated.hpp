#pragma once
/// \file
/// A representative set as text, JSON and CSV.

#include "sets/matched_set.hpp"
#include "sets/set_sizes.hpp"
#include "text/sink.hpp"

namespace mdm {

/// A representative set and where it comes from.
struct GeneratedSet {
  std::shared_ptr<const ModelCurve> curve;
  std::string id;    ///< the curve in words
  std::string unit;  ///< of sizes; empty: any
  std::string terms; ///< classes and criteria, in words
  std::vector<SizeClass> classes;
  Representativity wanted;
  ClassCounts counts;                      ///< by Eq. 6-10
  std::optional<Integer> at_most;          ///< N_max
  std::optional<std::uint64_t> seed;       ///< by which their sizes are drawn; else they are quantiles
  std::optional<Match> match;              ///< the exact alternative, if it was asked for
  std::optional<std::uint64_t> spread;     ///< seed of the match's spread; else a class has one size
  unsigned match_digits = 0;               ///< of its gradation
  unsigned points = 0;                     ///< sizes at which C_r is taken
  std::optional<SetQuality> drawn_quality; ///< of the particles drawn by Eq. 6-10
  std::optional<SetQuality> match_quality; ///< of those of the match
  unsigned table = 0;                      ///< sizes of a table of h, V, F and f
  unsigned digits = 15;                    ///< significant digits of enclosures
  std::vector<std::string> notes;

  /// Particles of class j; nothing where that is not decided.
  std::optional<Integer> quantity(std::size_t j) const;
  /// The particles of all classes.
  std::optional<Integer> particles() const;
  /// The particles of the match.
  ParticlesOf match_particles() const;
  /// N_min <= N <= N_max (of the set by Eq. 6-10: max(sum N', N_min)); nothing if not decided.
  std::optional<bool> accessible() const;
};

/// One line of JSON, schema `mdm-generate-1`, without a newline at its end: id, unit, method, dimension,
/// seed, classes [{lower, upper, volume_fraction: enclosures, "estimate":["lo","hi"] (N'), "quantity",
/// number_fraction (P_i)}], particles, accessible, Cu, Cc, quality {points, drawn, match: {Cr, worst_error,
/// Cu, Cc, classes [{share, largest}]}}, curve [{size, passing, volume_density, partition, number_density,
/// curve_passing}] with a table (h, V, F and f of the set whose grading curve is linear between the bounds of
/// its classes, and h of the curve itself), notes, versions, and with `draws` sizes, class by class: "p/q"
/// where it is a fraction, else an enclosure. Memory does not grow with the number of sizes.
void generated_json(const GeneratedSet &set, const std::optional<Draws> &draws, const Sink &sink);

/// A row a class: class,lower_lo,lower_hi,upper_lo,upper_hi,volume_fraction_lo,volume_fraction_hi,quantity,
/// number_fraction_lo,number_fraction_hi; with `draws` instead a row a particle: class,size_lo,size_hi; with
/// a table instead size, passing, volume_density, partition, number_density and curve_passing, each with _lo
/// and _hi.
void generated_csv(const GeneratedSet &set, const std::optional<Draws> &draws, const Sink &sink);

/// N or its bounds in a line, and whether N_max is kept.
std::string headline(const GeneratedSet &set);

/// For people.
std::string generated_text(const GeneratedSet &set);

} // namespace mdm
