#pragma once
/// \file
/// The integer problem of a match within a tolerance.

#include <mdm/gradation/mass_law.hpp>
#include <mdm/match/evidence.hpp>
#include <mdm/match/tolerance.hpp>

#include <utility>
#include <vector>

namespace mdm {

/// sum coefficient * variable >= constant: a condition of the problem with its class (0 where it has none).
struct LinearRow {
  TolerantCondition condition;
  std::size_t j = 0;
  std::vector<std::pair<std::size_t, Rational>> terms;
  Rational constant = 0;
  Rational width = 0; ///< of a share: between the two bounds that this is one of
};

/// The demands on a match within a tolerance besides its tolerance.
struct TolerantDemands {
  Integer min_per_class = 0;      ///< in classes with m_j > 0
  Integer at_least = 1;           ///< particles
  std::optional<Rational> weight; ///< least sum of x^a (over all particles)
};

/// Minimise q_1 + ... + q_k over integers q_j >= 0 and masses t_j with the rows (Theorem 12). Variables are
/// numbered q_j = j, t_j = k + j, p_j = 2k + j, j from 0. Masses are in units in which all f_j and F_j are
/// integers.
class TolerantProblem {
public:
  /// \throws InputError if the law is irrational at an opening
  TolerantProblem(const Gradation &g, const MassLaw &law, const Tolerance &tolerance,
                  const TolerantDemands &demands);

  std::size_t classes() const { return f_.size(); }
  std::size_t variables() const { return variables_; }
  /// All conditions but least_count, most_count, excess_sign (bounds on single variables) and fewer. Cost:
  /// rows times classes; a problem keeps no rows, as many classes have far too many.
  std::vector<LinearRow> rows() const;
  /// At least rows times variables.
  std::size_t table_size() const;
  const Integer &f(std::size_t j) const { return f_[j]; }
  const Integer &F(std::size_t j) const { return F_[j]; }
  /// Least q_j.
  const Integer &least(std::size_t j) const { return least_[j]; }
  /// A mass of 1 (c x^a of the gradation) in the units of t.
  const Rational &unit() const { return unit_; }

  const Tolerance &tolerance() const { return tolerance_; }
  /// g_j.
  const std::vector<Rational> &target() const { return target_; }
  /// 1 / c_j in the units of t, and the least sum of t_j / c_j that is demanded.
  const Rational &per_mass(std::size_t j) const { return per_mass_[j]; }
  const std::optional<Rational> &weight() const { return weight_; }
  /// Particles that are asked for, at least 1.
  const Integer &at_least() const { return at_least_; }

  /// True if the particles q and masses t are a match: every condition holds, by exact arithmetic. Cost: a
  /// pass over the classes.
  bool is_match(const std::vector<Integer> &q, const std::vector<Rational> &t) const;

private:
  bool has_shares(const std::vector<Rational> &t) const;

  Tolerance tolerance_;
  std::vector<Rational> target_, per_mass_;
  std::vector<Integer> f_, F_, least_;
  std::optional<Rational> weight_;
  Integer at_least_;
  Rational unit_;
  std::size_t variables_ = 0;
};

/// With no more numbers in its table the exact linear program takes about as much time as windows of the
/// mass, or less.
inline constexpr std::size_t exact_table = 1600;

} // namespace mdm
