#include "match/quick_simplex.hpp"

#include <algorithm>
#include <cmath>

namespace mdm {
namespace {

/// What is smaller is taken for 0: a violation, and an entry of the table.
constexpr double tiny_violation = 1e-9;
constexpr double tiny_entry = 1e-9;

} // namespace

QuickSimplex::QuickSimplex(std::size_t variables)
    : variables_(variables), lower_(variables, -unbounded), upper_(variables, unbounded),
      values_(variables, 0) {
  for (std::size_t x = 0; x < variables; ++x)
    columns_.push_back(x);
}

std::size_t QuickSimplex::add_form(const std::vector<std::pair<std::size_t, double>> &terms) {
  table_.resize(table_.size() + variables_, 0);
  for (const auto &[variable, coefficient] : terms)
    row(basic_.size())[variable] += coefficient;
  basic_.push_back(values_.size());
  lower_.push_back(-unbounded);
  upper_.push_back(unbounded);
  values_.push_back(0);
  return values_.size() - 1;
}

/// Columns' variables keep within their bounds; the others follow.
void QuickSimplex::update_values() {
  for (const std::size_t x : columns_)
    values_[x] = std::min(std::max(values_[x], lower_[x]), upper_[x]);
  for (std::size_t r = 0; r < basic_.size(); ++r) {
    double sum = 0;
    for (std::size_t c = 0; c < variables_; ++c)
      sum += row(r)[c] * values_[columns_[c]];
    values_[basic_[r]] = sum;
  }
}

std::optional<std::size_t> QuickSimplex::most_violated_row() const {
  std::optional<std::size_t> worst;
  double most = tiny_violation;
  for (std::size_t r = 0; r < basic_.size(); ++r) {
    const std::size_t x = basic_[r];
    const double violation = std::max(lower_[x] - values_[x], values_[x] - upper_[x]);
    if (violation > most) {
      most = violation;
      worst = r;
    }
  }
  return worst;
}

/// The column that makes `aim` rise least as the row's variable moves to its bound.
std::optional<std::size_t> QuickSimplex::entering(std::size_t of, bool rise, std::size_t aim) const {
  const auto place = std::find(basic_.begin(), basic_.end(), aim);
  const double *cost =
      place == basic_.end() ? nullptr : row(static_cast<std::size_t>(place - basic_.begin()));
  std::optional<std::size_t> best;
  double least = 0, largest = 0;
  for (std::size_t c = 0; c < variables_; ++c) {
    const std::size_t x = columns_[c];
    const double entry = row(of)[c];
    const bool up = (entry > 0) == rise;
    if (std::fabs(entry) < tiny_entry || (up ? values_[x] >= upper_[x] : values_[x] <= lower_[x]))
      continue;
    const double price = std::fabs((cost ? cost[c] : (x == aim ? 1 : 0)) / entry);
    if (best && (price > least + tiny_entry || (price > least - tiny_entry && std::fabs(entry) <= largest)))
      continue;
    best = c;
    least = price;
    largest = std::fabs(entry);
  }
  return best;
}

void QuickSimplex::pivot(std::size_t r, std::size_t column) {
  double *const of = row(r);
  const double entry = of[column];
  for (std::size_t c = 0; c < variables_; ++c)
    of[c] = c == column ? 1 / entry : -of[c] / entry;
  for (std::size_t other = 0; other < basic_.size(); ++other) {
    double *const to = row(other);
    const double factor = to[column];
    if (other == r || factor == 0)
      continue;
    to[column] = 0;
    for (std::size_t c = 0; c < variables_; ++c)
      to[c] += factor * of[c];
  }
  std::swap(basic_[r], columns_[column]);
}

bool QuickSimplex::minimise(std::size_t aim) {
  update_values();
  // More pivots than usual are a cycle.
  for (std::size_t pivots = 0; pivots < 10 * values_.size(); ++pivots) {
    const std::optional<std::size_t> r = most_violated_row();
    if (!r)
      return true;
    const std::size_t x = basic_[*r];
    const bool rise = values_[x] < lower_[x];
    const std::optional<std::size_t> column = entering(*r, rise, aim);
    if (!column)
      return false;
    values_[x] = rise ? lower_[x] : upper_[x];
    pivot(*r, *column);
    update_values();
  }
  return false;
}

} // namespace mdm
