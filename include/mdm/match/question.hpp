#pragma once
/// \file
/// The question about a gradation.

#include <mdm/gradation/gradation.hpp>
#include <mdm/gradation/mass_law.hpp>
#include <mdm/match/solids.hpp>
#include <mdm/match/tolerance.hpp>

#include <optional>

namespace mdm {

/// All that changes the problem and does not stand in the gradation file. A certificate repeats it.
struct Question {
  MassLaw law;                            ///< size to mass
  std::optional<Rational> pan_size;       ///< size > 0 to count the pan as
  std::optional<Rational> cut_below;      ///< opening below which classes are left out
  Rational size_factor = 1;               ///< > 0, multiplies every opening
  Integer min_per_class = 0;              ///< floor R of every class with mass; exact matches have 1 anyhow
  std::optional<Solids> solids;           ///< least volume of solids; spheres only
  Integer at_least = 1;                   ///< least number of particles, >= 1
  std::vector<AskedTolerance> tolerances; ///< all of them hold
  std::optional<Envelope> band;           ///< bounds on what passes
  bool band_alone = false;                ///< no gradation was given: it is the band's middle

  /// True if the shares need not be those of the gradation exactly.
  bool is_tolerant() const { return !tolerances.empty() || band; }
};

/// g with the pan, the cut and the size factor of the question, in this order.
/// \throws InputError if they do not fit g
Gradation asked_gradation(Gradation g, const Question &question);

/// The question in words, parts joined by `; `, for example `at least 10 particles in each class; law
/// x^(5/2)`. Empty for the plain question: spheres, nothing changed, nothing asked for.
/// \param unit  of its lengths
std::string in_words(const Question &question, SizeUnit unit);

} // namespace mdm
