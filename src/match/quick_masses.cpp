// Masses for given counts in doubles, as far from all bounds as can be: the linear program of
// central_masses.cpp, with masses as parts of the way from q f to q F, so that numbers are near 1. What it
// finds is moved to short fractions and tested by is_match(), exactly. Where it finds nothing, the distance
// to a solution says whether that is clear or so close that exact numbers have to tell.

#include "match/quick_masses.hpp"

#include "match/near.hpp"
#include "match/quick_simplex.hpp"

#include <cmath>

namespace mdm {
namespace {

/// The linear program of the masses t_j that are farthest from all bounds: t_j = (1 + z_j h_j) times the
/// middle of what q_j particles can hold, and 1 - d times the width between two bounds is the distance from
/// them. Masses are in units of the sum of these middles.
class Program {
public:
  Program(const TolerantProblem &problem, const std::vector<Integer> &q)
      : problem_(problem), k_(problem.classes()), program_(problem.tolerance().total ? 2 * k_ + 1 : k_ + 1) {
    double all = 0;
    for (std::size_t j = 0; j < k_; ++j) {
      middle_.push_back(near(Integer(problem.f(j) + problem.F(j))) / 2 * near(q[j]));
      half_.push_back(near(Integer(problem.F(j) - problem.f(j))) / 2 * near(q[j]));
      all += middle_.back();
    }
    for (std::size_t j = 0; j < k_; ++j) {
      middle_[j] /= all;
      half_[j] /= all;
      add_class(j, q[j] > 0);
    }
    unit_ = all;
    program_.set_lower(d(), 0);
    add_shares();
    if (problem.tolerance().total)
      add_total(near(*problem.tolerance().total) / 2);
    if (problem.weight() && *problem.weight() > 0)
      add_weight(near(*problem.weight()));
  }

  /// d, or a number above `enough` where it is above that; nothing if there is no solution.
  std::optional<double> solve(double enough) {
    if (!std::isfinite(unit_) || !program_.minimise(d(), enough) || !std::isfinite(program_.value(d())))
      return std::nullopt;
    return program_.value(d());
  }
  double z(std::size_t j) const { return program_.value(j); }
  /// A tolerance of nothing has no middle.
  bool has_point() const { return has_point_; }

private:
  using Terms = std::vector<std::pair<std::size_t, double>>;
  std::size_t d() const { return k_; }
  std::size_t p(std::size_t j) const { return k_ + 1 + j; }

  void add_class(std::size_t j, bool holds_particles) {
    if (!holds_particles) {
      program_.set_lower(j, 0);
      program_.set_upper(j, 0);
      return;
    }
    program_.set_lower(program_.add_form({{j, 1}, {d(), 2}}), 1);
    program_.set_lower(program_.add_form({{j, -1}, {d(), 2}}), 1);
  }

  /// scale * (sum of t over [from, to) - share * M), without its constant, which is returned.
  double deviation(Terms &terms, std::size_t from, std::size_t to, double share, double scale) const {
    double constant = 0;
    for (std::size_t j = 0; j < k_; ++j) {
      const double c = scale * ((from <= j && j < to ? 1 : 0) - share);
      constant += c * middle_[j];
      if (half_[j] > 0)
        terms.emplace_back(j, c * half_[j]);
    }
    return constant;
  }

  void add_share(std::size_t from, std::size_t to, const ShareBounds &b) {
    const double lo = near(b.lo), hi = near(b.hi);
    has_point_ = has_point_ || (!(lo < hi) && to - from < k_);
    const double scale = 1 / (hi - lo);
    const auto add = [&](double share, double sign) {
      Terms terms = {{d(), 1}};
      const double constant = deviation(terms, from, to, share, sign * scale);
      program_.set_lower(program_.add_form(terms), 1 - constant);
    };
    if (lo > 0 && to - from < k_)
      add(lo, 1);
    if (hi < 1)
      add(hi, -1);
  }

  void add_shares() {
    const Tolerance &tolerance = problem_.tolerance();
    for (std::size_t j = 0; j < tolerance.retained.size(); ++j)
      add_share(j, j + 1, tolerance.retained[j]);
    for (std::size_t j = 0; j < tolerance.passing.size(); ++j)
      add_share(0, j + 1, tolerance.passing[j]);
  }

  /// Excesses are in units of what they may be in sum.
  void add_total(double most) {
    has_point_ = has_point_ || !(most > 0);
    Terms total = {{d(), 1}};
    const double all = deviation(total, 0, k_, 0, 1);
    for (std::size_t j = 0; j < k_; ++j) {
      Terms terms = {{p(j), 1}};
      const double share = near(problem_.target()[j]);
      const double constant = deviation(terms, j, j + 1, share, -1 / most);
      program_.set_lower(program_.add_form(terms), -constant);
      program_.set_lower(p(j), 0);
      total.emplace_back(p(j), -1);
    }
    program_.set_lower(program_.add_form(total), 1 - all);
  }

  void add_weight(double least) {
    Terms terms;
    double constant = 0;
    for (std::size_t j = 0; j < k_; ++j) {
      const double c = near(problem_.per_mass(j)) * unit_ / least;
      constant += c * middle_[j];
      if (half_[j] > 0)
        terms.emplace_back(j, c * half_[j]);
    }
    program_.set_lower(program_.add_form(terms), 1 - constant);
  }

  const TolerantProblem &problem_;
  std::size_t k_;
  QuickSimplex program_;
  std::vector<double> middle_, half_;
  double unit_ = 0;
  bool has_point_ = false;
};

/// (1 + z) / 2 of the way from f q to F q, in steps of 2^-40.
Rational mass_at(const Integer &f, const Integer &F, const Integer &q, double z) {
  constexpr int bits = 40;
  const auto parts = static_cast<std::int64_t>(std::llround(std::ldexp((1 + z) / 2, bits)));
  return q * (f + ratio((F - f) * parts, Integer(Integer(1) << bits)));
}

} // namespace

QuickMasses quick_masses(const TolerantProblem &problem, const std::vector<Integer> &q) {
  constexpr double noise = 1e-6;
  constexpr std::size_t most_numbers = std::size_t{1} << 20; // of a table; some 300 classes
  if (problem.table_size() > most_numbers)
    return {};
  Program program(problem, q);
  if (program.has_point())
    return {};
  const std::optional<double> d = program.solve(1 + noise);
  if (!d || *d > 1 + noise)
    return {std::nullopt, !d};
  std::vector<Rational> t;
  for (std::size_t j = 0; j < q.size(); ++j)
    t.push_back(q[j] == 0 ? Rational(0) : mass_at(problem.f(j), problem.F(j), q[j], program.z(j)));
  if (problem.is_match(q, t))
    return {std::move(t), false};
  return {};
}

} // namespace mdm
