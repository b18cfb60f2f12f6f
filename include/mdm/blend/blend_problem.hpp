#pragma once
/// \file
/// The question which mix of stockpiles meets a specification.

#include <mdm/gradation/envelope.hpp>
#include <mdm/gradation/gradation.hpp>
#include <mdm/soil/fineness_modulus.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mdm {

/// The modulus of a mean percent m that passes its n sieves: n (1 - m / 100).
Rational modulus_of_mean(FinenessModulus modulus, const Rational &mean);
/// The mean percent that passes the sieves of a modulus.
Rational mean_of_modulus(FinenessModulus modulus, const Rational &value);

/// Limits on a fineness modulus, closed.
struct ModulusLimits {
  FinenessModulus modulus;
  std::optional<Rational> least, most;
};

/// Limits on the coarseness factor (Shilstone 1990), closed: of the mass that stays on 2.36 mm the percent
/// that stays on 9.5 mm. A blend of which nothing stays on 2.36 mm keeps them.
struct CoarsenessLimits {
  Rational least = 0, most = 100; ///< in order from 0 to 100
};

/// A sieve at which a blend is judged. Percents are of the mass that passes.
struct BlendSieve {
  Rational size;                  ///< mm
  Rational least = 0, most = 100; ///< limits, closed; 0 and 100 are none
  std::optional<Rational> target; ///< percent
  /// In the place of a sieve: what passes is the mean of what passes the sieves of the modulus. It has no
  /// size and no target.
  std::optional<FinenessModulus> modulus = std::nullopt;
  /// In the place of a sieve, for a limit c of the coarseness factor: what passes is what passes 9.5 mm, less
  /// c / 100 of what passes 2.36 mm. It has no size and no target, and c from below is a limit from above.
  std::optional<Rational> coarseness = std::nullopt;

  bool is_sieve() const { return !modulus && !coarseness; }
};

/// The percents of a mass that pass two sieves.
struct CoarsePassing {
  Rational at_9_5_mm, at_2_36_mm;
};

/// A material that a blend may have a share of.
struct Stockpile {
  std::string name;
  std::vector<Rational> passing; ///< percent, at each sieve of the problem
  Rational least = 0, most = 1;  ///< limits on its share of the mass, closed, from 0 to 1
  Rational cost = 0;             ///< of a unit of mass, >= 0
  std::optional<CoarsePassing> coarse = std::nullopt; ///< where the coarseness factor is limited
};

/// What a blend has least of. Deviations are those of what passes from the target, in percentage points.
enum class BlendAim {
  none,
  cost,          ///< of a unit of mass
  deviation,     ///< the sum over all sieves
  max_deviation, ///< the largest
  squares,       ///< the sum of their squares
  widening       ///< the points by which limits of sieves must be widened, all by the same
};

/// `none`, `cost`, `deviation`, `max-deviation`, `squares` or `widening`.
std::string_view name(BlendAim aim);
/// True of aims at a target.
bool aims_at_target(BlendAim aim);
/// The aim of that name that can be asked for, none among them; nothing if there is none: widening follows
/// from the others.
std::optional<BlendAim> blend_aim_named(std::string_view text);

/// Shares n_i / steps >= 0 with whole n_i and the sum 1, such that at each sieve the shares of what passes
/// sum to something within the limits.
struct BlendProblem {
  std::vector<Stockpile> stockpiles; ///< at least one
  std::vector<BlendSieve> sieves;    ///< ascending by size, then the fineness moduli, then the factor
  std::optional<CoarsenessLimits> coarseness = std::nullopt;
  std::uint64_t steps = 100; ///< from 1 to most_blend_steps
  BlendAim aim = BlendAim::none;
  std::optional<std::size_t> at_most; ///< stockpiles that have a share
  std::vector<std::size_t> widened;   ///< sieves whose limits are widened, of that aim
  std::vector<std::string> notes;     ///< what the readers assumed, and what was interpolated or left out
};

/// The most steps that the whole may have.
inline constexpr std::uint64_t most_blend_steps = 1'000'000'000;

/// A condition on a blend.
struct BlendLimit {
  enum class Kind {
    passing, ///< what passes the sieve `index`
    target,  ///< the same, of the deviation from its target
    share,   ///< the share of the stockpile `index`
    sum      ///< all shares sum to 1
  };
  Kind kind;
  std::size_t index;
  bool is_upper;

  bool operator==(const BlendLimit &) const = default;
};

/// The side of the condition that is no variable: percent, or a share.
Rational value_of(const BlendLimit &limit, const BlendProblem &problem);

/// `at most 90 % passing 12.5 mm`, `at least 10 % of A`, `shares that sum to 100 %`.
std::string in_words(const BlendLimit &limit, const BlendProblem &problem);

/// What passes a size.
struct PassingAt {
  Rational percent;
  bool interpolated = false; ///< between two sieves, linear in size
};

/// Percent of the mass of g that passes `size` >= 0 (mm): exact at its sieves, beyond its coarsest and below
/// a finest that all stays on; between two sieves linear in size, which keeps fractions exact. Nothing where
/// it falls into a pan that holds mass.
/// \throws InputError if openings of g are irrational
std::optional<PassingAt> passing_at(const Gradation &g, const Rational &size);

/// The problem of gradations and the limits of a specification: all sieves of it that limit something, and
/// the others where all gradations tell what passes. Names are the gradations' ids.
/// \throws InputError where two have the same name, a gradation or the target does not tell what passes a
/// sieve that is needed, or a modulus is limited twice or to more than it can be
BlendProblem blend_problem(const std::vector<Gradation> &stockpiles, const Envelope &specification,
                           const std::optional<Gradation> &target = std::nullopt,
                           const std::vector<ModulusLimits> &moduli = {},
                           const std::optional<CoarsenessLimits> &coarseness = std::nullopt);

/// Limits the coarseness factor: adds a sieve for each limit that is one, behind the others.
/// \pre the stockpiles have what passes 9.5 mm and 2.36 mm
void limit_coarseness(BlendProblem &problem, const CoarsenessLimits &limits);

/// That of a blend; nothing where nothing stays on 2.36 mm.
/// \pre it is limited
std::optional<Rational> coarseness_factor(const BlendProblem &problem, const std::vector<Rational> &shares);

/// The sieves of which at least one limit is to be kept; no moduli and no factor.
std::vector<std::size_t> limited_sieves(const BlendProblem &problem);

/// All limits of sieves from the coarsest on, then those of shares; without those that hold of themselves.
std::vector<BlendLimit> limits_of(const BlendProblem &problem);

} // namespace mdm
