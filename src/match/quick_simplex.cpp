// The dual simplex method in doubles: a guide for exact arithmetic. A basic variable beyond its bound
// leaves the basis, and the one enters that makes the aim rise least (the ratio test), so that reduced
// costs keep their signs. Numbers below a tolerance are taken for 0. It may be wrong, and may give up: what
// it finds is tested by others.

#include "match/quick_simplex.hpp"

#include <algorithm>
#include <cmath>

namespace mdm {
namespace {

/// What is smaller is taken for 0: a violation, and an entry of the table.
constexpr double tiny_violation = 1e-10;
constexpr double tiny_entry = 1e-9;

/// Adds `factor` times n numbers to others.
void add_multiple(double *__restrict to, const double *__restrict from, double factor, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i)
    to[i] += factor * from[i];
}

} // namespace

QuickSimplex::QuickSimplex(std::size_t variables)
    : variables_(variables), lower_(variables, -unbounded), upper_(variables, unbounded),
      values_(variables, 0) {
  for (std::size_t x = 0; x < variables; ++x) {
    columns_.push_back(x);
    place_.push_back(x);
  }
}

std::size_t QuickSimplex::add_form(const Terms &terms) {
  const std::size_t form = values_.size();
  basic_.push_back(form);
  place_.push_back(form);
  table_.resize(basic_.size() * variables_, 0);
  for (const auto &[variable, coefficient] : terms)
    row(basic_.size() - 1)[variable] += coefficient;
  lower_.push_back(-unbounded);
  upper_.push_back(unbounded);
  values_.push_back(0);
  return form;
}

/// By how much `aim` rises with the column's variable.
double QuickSimplex::cost(std::size_t aim, std::size_t column) const {
  if (place_[aim] < variables_)
    return columns_[column] == aim ? 1 : 0;
  return row(place_[aim] - variables_)[column];
}

/// Columns' variables are at the bounds that are least for `aim`; the others follow.
void QuickSimplex::place_columns(std::size_t aim) {
  for (std::size_t c = 0; c < variables_; ++c) {
    const std::size_t x = columns_[c];
    const double price = cost(aim, c);
    if (price > tiny_entry && lower_[x] > -unbounded)
      values_[x] = lower_[x];
    else if (price < -tiny_entry && upper_[x] < unbounded)
      values_[x] = upper_[x];
    else
      values_[x] = std::min(std::max(values_[x], lower_[x]), upper_[x]);
  }
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
  std::optional<std::size_t> best;
  double least = 0, largest = 0;
  for (std::size_t c = 0; c < variables_; ++c) {
    const std::size_t x = columns_[c];
    const double entry = row(of)[c];
    const bool up = (entry > 0) == rise;
    if (std::fabs(entry) < tiny_entry || (up ? values_[x] >= upper_[x] : values_[x] <= lower_[x]))
      continue;
    const double price = std::fabs(cost(aim, c) / entry);
    if (best && (price > least + tiny_entry || (price > least - tiny_entry && std::fabs(entry) <= largest)))
      continue;
    best = c;
    least = price;
    largest = std::fabs(entry);
  }
  return best;
}

void QuickSimplex::exchange(std::size_t r, std::size_t column) {
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
    add_multiple(to, of, factor, variables_);
  }
  std::swap(basic_[r], columns_[column]);
  place_[basic_[r]] = variables_ + r;
  place_[columns_[column]] = column;
}

/// Moves a column's variable, and with it all others.
void QuickSimplex::move(std::size_t column, double by) {
  values_[columns_[column]] += by;
  for (std::size_t r = 0; r < basic_.size(); ++r)
    values_[basic_[r]] += row(r)[column] * by;
}

bool QuickSimplex::minimise(std::size_t aim, double enough) {
  place_columns(aim);
  // More pivots than usual are a cycle.
  for (std::size_t pivots = 0; pivots < 10 * values_.size(); ++pivots) {
    const std::optional<std::size_t> r = most_violated_row();
    if (!r || values_[aim] > enough) // it only rises
      return true;
    const std::size_t x = basic_[*r];
    const bool rise = values_[x] < lower_[x];
    const std::optional<std::size_t> column = entering(*r, rise, aim);
    if (!column)
      return false;
    const double missing = (rise ? lower_[x] : upper_[x]) - values_[x];
    move(*column, missing / row(*r)[*column]);
    values_[x] = rise ? lower_[x] : upper_[x];
    exchange(*r, *column);
  }
  return false;
}

} // namespace mdm
