// The linear program of a match within a tolerance in doubles (Theorem 12 without whole numbers): counts
// and masses, with the number of particles least. Variables are scaled to be about 1, and strict bounds are
// kept by a small margin. What it finds, a point, multipliers, and what a split would gain, steers;
// certain_bound.cpp and exact tests decide.

#include "match/tolerant_relaxation.hpp"

#include "match/near.hpp"

#include <algorithm>
#include <cmath>

namespace mdm {
namespace {

/// What is above 0 is to be above this part of about 1.
constexpr double strictly_above = 1e-8;

} // namespace

TolerantRelaxation::TolerantRelaxation(const TolerantProblem &problem, const std::vector<double> &typical,
                                       const Watch &watch)
    : problem_(problem), k_(problem.classes()), counts_(typical), program_(problem.variables(), watch) {
  mass_scale_ = 0;
  for (std::size_t j = 0; j < k_; ++j) {
    masses_.push_back(counts_[j] * near(problem.F(j)));
    mass_scale_ += masses_.back();
  }
  for (std::size_t p = 2 * k_; p < problem.variables(); ++p)
    program_.set_lower(p, 0);
  for (const LinearRow &row : problem.rows())
    add_row(row);
}

/// With its largest coefficient 1.
void TolerantRelaxation::add_row(const LinearRow &row) {
  QuickSimplex::Terms terms;
  double scale = 0;
  for (const auto &[variable, coefficient] : row.terms) {
    const double unit = variable < k_       ? counts_[variable]
                        : variable < 2 * k_ ? masses_[variable - k_]
                                            : mass_scale_;
    terms.emplace_back(variable, near(coefficient) * unit);
    scale = std::max(scale, std::fabs(terms.back().second));
  }
  if (!(scale > 0))
    scale = 1;
  for (auto &[variable, coefficient] : terms)
    coefficient /= scale;
  const std::size_t form = program_.add_form(terms);
  forms_.push_back({row.condition, row.j, row.j, scale});
  const bool is_strict = row.condition == TolerantCondition::some_mass;
  program_.set_lower(form, is_strict ? strictly_above : near(row.constant) / scale);
  if (row.condition == TolerantCondition::above_lower)
    strict_.push_back(form);
  if (row.condition == TolerantCondition::at_least) {
    count_ = form;
    count_scale_ = scale;
  }
}

std::size_t TolerantRelaxation::sum_form(std::size_t i, std::size_t j) {
  if (const auto known = sums_.find({i, j}); known != sums_.end())
    return known->second;
  const double scale = *std::max_element(counts_.begin() + static_cast<std::ptrdiff_t>(i),
                                         counts_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
  QuickSimplex::Terms terms;
  for (std::size_t b = i; b <= j; ++b)
    terms.emplace_back(b, counts_[b] / scale);
  const std::size_t form = program_.add_form(terms);
  forms_.push_back({TolerantCondition::least_sum, i, j, scale});
  sums_[{i, j}] = form;
  return form;
}

void TolerantRelaxation::set(const CountBounds &bounds, const std::optional<Integer> &most) {
  const auto set_both = [&](std::size_t variable, const CountBound &bound, double scale) {
    program_.set_lower(variable, near(bound.least) / scale);
    const Integer *upper = bound.most ? &*bound.most : most ? &*most : nullptr;
    program_.set_upper(variable, upper ? near(*upper) / scale : QuickSimplex::unbounded);
  };
  for (std::size_t j = 0; j < k_; ++j) {
    const CountBound &bound = bounds.classes[j];
    set_both(j, bound, counts_[j]);
    program_.set_lower(strict_[j], bound.least >= 1 ? strictly_above * near(bound.least) / counts_[j] : 0);
  }
  for (const auto &[of, bound] : bounds.sums)
    sum_form(of.first, of.second);
  for (const auto &[of, form] : sums_) {
    const auto bound = bounds.sums.find(of);
    set_both(form, bound == bounds.sums.end() ? CountBound{} : bound->second,
             forms_[form - problem_.variables()].scale);
  }
  program_.set_upper(count_, most ? near(*most) / count_scale_ : QuickSimplex::unbounded);
}

std::vector<Steering> TolerantRelaxation::steering() const {
  constexpr double noise = 1e-13; // of the largest
  const std::vector<QuickSimplex::Term> terms =
      is_feasible_ ? program_.bounds_of(count_) : program_.conflict();
  double largest = 0;
  for (const QuickSimplex::Term &term : terms)
    if (term.variable >= 2 * k_)
      largest = std::max(largest, term.multiplier);
  std::vector<Steering> result;
  if (is_feasible_)
    result.push_back({TolerantCondition::fewer, 0, 0, 1 / count_scale_});
  for (const QuickSimplex::Term &term : terms) {
    if (term.variable < problem_.variables() || term.multiplier <= noise * largest)
      continue;
    const Form &form = forms_[term.variable - problem_.variables()];
    TolerantCondition condition = form.condition;
    if (condition == TolerantCondition::above_lower || condition == TolerantCondition::up_to_upper)
      continue;
    if (condition == TolerantCondition::least_sum && term.is_upper)
      condition = TolerantCondition::most_sum;
    if (condition == TolerantCondition::at_least && term.is_upper)
      condition = TolerantCondition::fewer;
    else if (term.is_upper && condition != TolerantCondition::most_sum)
      continue;
    if (const double multiplier = term.multiplier / form.scale; std::isnormal(multiplier))
      result.push_back({condition, form.i, form.j, multiplier});
  }
  return result;
}

} // namespace mdm
