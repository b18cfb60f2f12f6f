#pragma once
/// \file
/// Deposits of the six shapes of Voivret, Delenne and Radjai over the span: Figure 9 and what it rests on.

#include "packing/deposit.hpp"
#include "packing/texture.hpp"
#include "papers/size_models.hpp"

namespace mdm {

/// What all deposits of a study have in common; N_c = N_pc = 10.
struct PackingTerms {
  Integer at_least = 25000; ///< N_min
  Integer at_most = 100000; ///< N_max: what takes more discs is left out

  /// All but N_max as a text: equal where the deposits are the same.
  std::string text() const;
};

/// One deposit. Seed k draws the sizes and shuffles them, in a box that is width_factor(k) as wide as a
/// square one.
struct DepositQuestion {
  Shape shape;
  Classing classing = Classing::geometric;
  Rational span;
  DepositRule rule = DepositRule::lowest;
  std::uint64_t seed = 1;

  /// A text that is another one for another deposit.
  std::string key() const;
};

/// 1, 1.05, 0.95, 1.1, ... 0.8 for seeds 1 to 9, and so on: fractions at small spans depend on the width.
Rational width_factor(std::uint64_t seed);

/// What is known of a deposit.
struct DepositFacts {
  std::uint64_t discs = 0;
  Interval fraction;                ///< packing fraction in the inner window; its ends are decimals
  std::uint64_t contacts = 0;       ///< of two discs
  std::uint64_t outer_supports = 0; ///< sides of discs that the floor carries
  Coordination coordination;
  CellCounts cells;
};

/// The number of discs that Eq. 6-9 give; nothing where it is not decided.
std::optional<Integer> disc_count(const DepositQuestion &question, const PackingTerms &terms);
/// Their sizes.
DiscSizes drawn_discs(const DepositQuestion &question, const PackingTerms &terms);
/// The deposit in a periodic box, floor centred.
Packing deposited(const DepositQuestion &question, const PackingTerms &terms);
/// Cost: some 20 us a disc.
/// \throws InputError if there are too few discs for a box or a packing fraction
DepositFacts deposit_facts(const DepositQuestion &question, const PackingTerms &terms);
/// Equal discs from the left end of the floor, in a box that their number fits: the triangular lattice.
DepositFacts equal_disc_facts(const PackingTerms &terms);

/// A point of Figure 9.
struct PackingPoint {
  Shape shape;
  Classing classing = Classing::geometric;
  Rational span;
  std::optional<Integer> discs;
  std::vector<DepositFacts> deposits; ///< of the seeds 1, 2, ...; empty: left out

  /// The mean of the packing fractions. \pre there are deposits
  Interval mean() const;
  /// The largest packing fraction minus the smallest. \pre there are deposits
  Interval scatter() const;
  /// The mean coordination of all discs of all deposits. \pre there are deposits
  Rational coordination() const;
  /// The share of discs with so many contacts. \pre there are deposits
  Rational touching(std::uint32_t contacts) const;
  /// Cells of all deposits. \pre there are deposits
  CellCounts cells() const;
};

/// (1, 1), (1, 3), (2, 4), (3, 1), (4, 2), (4, 4), as the paper has them.
std::vector<Shape> packed_shapes();
/// Twelve spans, 0.02 to 0.97.
std::vector<Rational> packed_spans();

/// The points of Figure 9 without deposits: both classings, all shapes, the spans.
std::vector<PackingPoint> figure9_points(const std::vector<Rational> &spans, const PackingTerms &terms);

/// All that the paper's statements are held against.
struct PackingStudy {
  PackingTerms terms;
  std::vector<PackingPoint> points;  ///< of Figure 9
  std::vector<PackingPoint> dropped; ///< rule drop, shape (1, 1), geometric classes
  DepositFacts equal;                ///< equal_disc_facts()
};

} // namespace mdm
