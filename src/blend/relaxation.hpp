#pragma once
/// \file
/// Blends with real shares: a linear program.

#include "blend/nearest_point.hpp"
#include "match/simplex.hpp"

#include <mdm/blend/blend.hpp>

namespace mdm {

/// The limits of a blend and its aim, decided exactly. Bounds on shares change as a search goes on. Squares
/// are least at the point nearest to the target; their demands and multiples are those of a tangent
/// (tangent.hpp), which has a relaxation of its own.
class BlendRelaxation {
public:
  /// Soon after the watch's end all that takes long throws Simplex::Interrupted.
  explicit BlendRelaxation(const BlendProblem &problem, const Watch &watch = {});

  void bound_share(std::size_t stockpile, const Rational &least, const Rational &most);
  /// Drops a limit, which is one of limits_of the problem.
  void leave_out(const BlendLimit &limit);
  void take_back(const BlendLimit &limit);
  /// Demands less than this of the aim, which is not squares.
  void demand_less(const Rational &value);

  /// True if some shares are within all bounds; else multiples() contradict each other.
  bool is_feasible();
  /// The least value; nothing if there are no shares.
  std::optional<Rational> least_value();
  /// The shares that come first of those with the least value.
  /// \pre least_value() found it, and no bounds have changed since
  std::vector<Rational> first_shares();
  /// Some shares with the least value.
  /// \pre as for first_shares()
  std::vector<Rational> some_shares() const;

  /// Conditions that add up to a contradiction; where less was demanded of the aim than it can have, they add
  /// up to aim >= value. Conditions share >= 0 and those on deviations alone are left out.
  std::vector<BlendMultiple> multiples() const;
  /// True if the contradiction needs that less was demanded of the aim.
  bool needs_aim() const;

private:
  /// A limit that a further variable widens.
  struct Soft {
    BlendLimit limit;
    std::size_t by; ///< the variable
    Rational value;
    std::size_t form = 0;
  };
  static std::vector<Soft> soft_limits(const BlendProblem &problem);
  static std::size_t further_variables(const BlendProblem &problem);
  bool is_widened(std::size_t sieve) const;
  void add_forms();
  void set_limit(const BlendLimit &limit, const Simplex::Bound &bound);
  void set_bounds();
  PlacedPoint placed(const std::vector<Rational> &shares) const;
  void aim_along(const std::vector<Rational> &direction);
  std::vector<Rational> values_of_shares() const;
  std::vector<Rational> first_shares_of_squares();
  std::vector<Rational> first_of_kept();

  const BlendProblem &problem_;
  std::vector<Soft> soft_;
  std::size_t further_; ///< variables behind the shares, >= 0
  Simplex program_;
  std::size_t sum_ = 0, first_passing_ = 0, aim_ = 0; ///< forms; the aim may be a variable
  PlacedPoint nearest_;                               ///< to the target, of squares
};

} // namespace mdm
