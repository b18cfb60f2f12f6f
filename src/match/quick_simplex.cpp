// The dual simplex method in doubles: a guide for exact arithmetic. A basic variable beyond its bound
// leaves the basis, and the one enters that makes the aim rise least (the ratio test), so that reduced
// costs keep their signs. Bounds that change leave the costs right, so that a search goes on from the last
// basis. Numbers below a tolerance are taken for 0; after some hundred pivots the table is made anew from
// the forms. It may be wrong, and may give up: what it finds is proved or tested by others.

#include "match/quick_simplex.hpp"

#include <algorithm>
#include <cmath>

namespace mdm {
namespace {

/// What is smaller is taken for 0: a violation, and an entry of the table.
constexpr double tiny_violation = 1e-10;
constexpr double tiny_entry = 1e-9;
/// After so many the table is made anew.
constexpr std::size_t most_pivots = 400;

/// Adds `factor` times n numbers to others.
void add_multiple(double *__restrict to, const double *__restrict from, double factor, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i)
    to[i] += factor * from[i];
}

} // namespace

QuickSimplex::QuickSimplex(std::size_t variables, Watch watch)
    : variables_(variables), watch_(std::move(watch)), lower_(variables, -unbounded),
      upper_(variables, unbounded), values_(variables, 0) {
  for (std::size_t x = 0; x < variables; ++x) {
    columns_.push_back(x);
    place_.push_back(x);
  }
}

std::size_t QuickSimplex::add_form(const Terms &terms) {
  Row of(variables_, 0);
  for (const auto &[variable, coefficient] : terms)
    add_to(of, variable, coefficient);
  table_.insert(table_.end(), of.begin(), of.end());
  const std::size_t form = values_.size();
  forms_.push_back(terms);
  basic_.push_back(form);
  place_.push_back(variables_ + basic_.size() - 1);
  lower_.push_back(-unbounded);
  upper_.push_back(unbounded);
  values_.push_back(0);
  return form;
}

void QuickSimplex::refresh() {
  const std::vector<std::size_t> wanted = columns_;
  std::vector<bool> is_column(values_.size(), false);
  for (const std::size_t x : wanted)
    is_column[x] = true;
  std::fill(table_.begin(), table_.end(), 0);
  for (std::size_t x = 0; x < variables_; ++x)
    columns_[x] = place_[x] = x;
  for (std::size_t r = 0; r < basic_.size(); ++r) {
    basic_[r] = variables_ + r;
    place_[basic_[r]] = variables_ + r;
    for (const auto &[variable, coefficient] : forms_[r])
      row(r)[variable] += coefficient;
  }
  // Each form that is to be a column takes the place of a variable that is not: the one of the largest entry.
  for (std::size_t r = 0; r < basic_.size(); ++r) {
    if (!is_column[basic_[r]])
      continue;
    std::optional<std::size_t> best;
    for (std::size_t c = 0; c < variables_; ++c)
      if (!is_column[columns_[c]] && (!best || std::fabs(row(r)[c]) > std::fabs(row(r)[*best])))
        best = c;
    if (best && std::fabs(row(r)[*best]) > tiny_entry)
      exchange(r, *best);
  }
  pivots_ = 0;
}

const double *QuickSimplex::cost_of(std::size_t aim) const {
  return place_[aim] < variables_ ? nullptr : row(place_[aim] - variables_);
}

/// Columns' variables are at the bounds that are least for `aim`; the others follow.
void QuickSimplex::place_columns(std::size_t aim) {
  const double *const cost = cost_of(aim);
  for (std::size_t c = 0; c < variables_; ++c) {
    const std::size_t x = columns_[c];
    const double price = cost ? cost[c] : (x == aim ? 1 : 0);
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
  const double *const cost = cost_of(aim);
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
  ++pivots_;
}

/// Moves a column's variable, and with it all others.
void QuickSimplex::move(std::size_t column, double by) {
  values_[columns_[column]] += by;
  for (std::size_t r = 0; r < basic_.size(); ++r)
    values_[basic_[r]] += row(r)[column] * by;
}

/// The bounds that hold a row's variable where it is.
std::vector<QuickSimplex::Term> QuickSimplex::terms_of(std::size_t r, bool rise) const {
  std::vector<Term> terms;
  for (std::size_t c = 0; c < variables_; ++c)
    if (const double entry = row(r)[c]; entry != 0)
      terms.push_back({columns_[c], (entry > 0) == rise, std::fabs(entry)});
  return terms;
}

std::vector<QuickSimplex::Term> QuickSimplex::bounds_of(std::size_t form) const {
  if (place_[form] < variables_)
    return {{form, false, 1}};
  return terms_of(place_[form] - variables_, false);
}

void QuickSimplex::add_to(Row &to, std::size_t variable, double coefficient) const {
  to.resize(variables_, 0);
  if (place_[variable] < variables_) {
    to[place_[variable]] += coefficient;
    return;
  }
  add_multiple(to.data(), row(place_[variable] - variables_), coefficient, variables_);
}

double QuickSimplex::price(std::size_t aim, const Row &of, bool rise) const {
  const double *const cost = cost_of(aim);
  double least = unbounded;
  for (std::size_t c = 0; c < variables_; ++c) {
    const std::size_t x = columns_[c];
    const bool up = (of[c] > 0) == rise;
    if (std::fabs(of[c]) < tiny_entry || (up ? values_[x] >= upper_[x] : values_[x] <= lower_[x]))
      continue;
    least = std::min(least, std::fabs((cost ? cost[c] : (x == aim ? 1 : 0)) / of[c]));
  }
  return least;
}

bool QuickSimplex::minimise(std::size_t aim, double enough) {
  conflict_.clear();
  if (pivots_ >= most_pivots)
    refresh();
  place_columns(aim);
  // More pivots than usual are a cycle.
  for (std::size_t pivots = 0; pivots < 10 * values_.size() && !watch_.ends(); ++pivots) {
    const std::optional<std::size_t> r = most_violated_row();
    if (!r || values_[aim] > enough) // it only rises
      return true;
    const std::size_t x = basic_[*r];
    const bool rise = values_[x] < lower_[x];
    const std::optional<std::size_t> column = entering(*r, rise, aim);
    if (!column) {
      conflict_ = terms_of(*r, rise);
      conflict_.push_back({x, !rise, 1});
      return false;
    }
    const double missing = (rise ? lower_[x] : upper_[x]) - values_[x];
    move(*column, missing / row(*r)[*column]);
    values_[x] = rise ? lower_[x] : upper_[x];
    exchange(*r, *column);
  }
  return false;
}

} // namespace mdm
