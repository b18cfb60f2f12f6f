#include <mdm/match/simplex.hpp>

#include <algorithm>

namespace mdm {
namespace {

Infinitesimal difference(const Infinitesimal &a, const Infinitesimal &b) {
  return {a.value - b.value, a.tiny - b.tiny};
}

Infinitesimal product(const Infinitesimal &a, const Rational &r) {
  return {a.value * r, a.tiny * r};
}

void add(Infinitesimal &to, const Infinitesimal &a) {
  to.value += a.value;
  to.tiny += a.tiny;
}

} // namespace

Simplex::Simplex(std::size_t variables)
    : columns_(variables), row_of_(variables), lower_(variables), upper_(variables), values_(variables) {
  for (std::size_t i = 0; i < variables; ++i)
    columns_[i] = i;
}

std::size_t Simplex::add_form(const std::vector<std::pair<std::size_t, Rational>> &terms) {
  const std::size_t form = values_.size();
  Row row{form, std::vector<Rational>(columns_.size())};
  values_.emplace_back();
  lower_.emplace_back();
  upper_.emplace_back();
  for (const auto &[variable, coefficient] : terms) {
    add(values_[form], product(values_[variable], coefficient));
    if (row_of_[variable]) {
      const Row &definition = rows_[*row_of_[variable]];
      for (std::size_t c = 0; c < columns_.size(); ++c)
        row.of[c] += coefficient * definition.of[c];
    } else {
      const auto column = std::find(columns_.begin(), columns_.end(), variable);
      row.of[static_cast<std::size_t>(column - columns_.begin())] += coefficient;
    }
  }
  row_of_.emplace_back(rows_.size());
  rows_.push_back(std::move(row));
  return form;
}

void Simplex::set_lower(std::size_t variable, const Bound &bound) {
  lower_[variable] = bound;
  settle(variable);
}

void Simplex::set_upper(std::size_t variable, const Bound &bound) {
  upper_[variable] = bound;
  settle(variable);
}

/// A variable of a column is always within its bounds, unless they contradict each other.
void Simplex::settle(std::size_t variable) {
  if (row_of_[variable] || (!is_below(variable) && !is_above(variable)))
    return;
  const auto column = std::find(columns_.begin(), columns_.end(), variable);
  const Bound &bound = is_below(variable) ? lower_[variable] : upper_[variable];
  move(static_cast<std::size_t>(column - columns_.begin()), difference(*bound, values_[variable]));
}

bool Simplex::is_below(std::size_t variable) const {
  return lower_[variable] && values_[variable] < *lower_[variable];
}

bool Simplex::is_above(std::size_t variable) const {
  return upper_[variable] && *upper_[variable] < values_[variable];
}

bool Simplex::can_rise(std::size_t variable) const {
  return !upper_[variable] || values_[variable] < *upper_[variable];
}

bool Simplex::can_fall(std::size_t variable) const {
  return !lower_[variable] || *lower_[variable] < values_[variable];
}

/// Changes the value of a column's variable, and with it those of the basic variables.
void Simplex::move(std::size_t column, const Infinitesimal &by) {
  add(values_[columns_[column]], by);
  for (const Row &row : rows_)
    if (row.of[column].sign() != 0)
      add(values_[row.basic], product(by, row.of[column]));
}

/// Exchanges a row's basic variable with a column's.
void Simplex::pivot(std::size_t r, std::size_t c) {
  Row &row = rows_[r];
  const std::size_t entering = columns_[c];
  const std::size_t leaving = row.basic;
  // leaving = a * entering + rest, so entering = leaving / a - rest / a.
  const Rational inverse = 1 / row.of[c];
  const Rational negative = -inverse;
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (i == c || row.of[i].sign() == 0)
      continue;
    row.of[i] *= negative;
    used.push_back(i);
  }
  row.of[c] = inverse;
  row.basic = entering;
  columns_[c] = leaving;
  row_of_[entering] = r;
  row_of_[leaving].reset();
  for (Row &other : rows_) {
    if (&other == &row || other.of[c].sign() == 0)
      continue;
    const Rational factor = other.of[c];
    for (const std::size_t i : used)
      other.of[i] += factor * row.of[i];
    other.of[c] = factor * inverse;
  }
}

/// The column of least variable (Bland's rule, so that no cycle can arise) that can make a row's basic
/// variable rise or fall.
std::optional<std::size_t> Simplex::entering(const Row &row, bool rise) const {
  std::optional<std::size_t> best;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const int sign = row.of[c].sign();
    if (sign == 0 || (best && columns_[*best] < columns_[c]))
      continue;
    if ((sign > 0) == rise ? can_rise(columns_[c]) : can_fall(columns_[c]))
      best = c;
  }
  return best;
}

/// No column can make the row's basic variable rise (or fall) to its bound: the bounds of all that hold it.
void Simplex::explain(const Row &row, bool rise) {
  conflict_.assign(1, {row.basic, !rise, 1});
  for (std::size_t c = 0; c < columns_.size(); ++c)
    if (const int sign = row.of[c].sign(); sign != 0)
      conflict_.push_back({columns_[c], (sign > 0) == rise, abs(row.of[c])});
}

bool Simplex::find() {
  for (std::size_t x = 0; x < values_.size(); ++x)
    if (lower_[x] && upper_[x] && *upper_[x] < *lower_[x]) {
      conflict_ = {{x, false, 1}, {x, true, 1}};
      return false;
    }
  for (;;) {
    const Row *worst = nullptr;
    for (const Row &row : rows_)
      if ((is_below(row.basic) || is_above(row.basic)) && (worst == nullptr || row.basic < worst->basic))
        worst = &row;
    if (worst == nullptr)
      return true;
    const std::size_t variable = worst->basic;
    const bool rise = is_below(variable);
    const std::optional<std::size_t> column = entering(*worst, rise);
    if (!column) {
      explain(*worst, rise);
      return false;
    }
    const Infinitesimal missing = difference(rise ? *lower_[variable] : *upper_[variable], values_[variable]);
    const std::size_t r = *row_of_[variable];
    move(*column, product(missing, Rational(1 / rows_[r].of[*column])));
    pivot(r, *column);
  }
}

/// Moves a column's variable up or down as far as all bounds allow and exchanges it with the variable that
/// stops it, the least one of several. False if nothing stops it.
bool Simplex::step(std::size_t column, bool rise) {
  const std::size_t entering = columns_[column];
  constexpr std::size_t itself = static_cast<std::size_t>(-1);
  std::size_t stop = itself;
  std::optional<Infinitesimal> room;
  if (const Bound &own = rise ? upper_[entering] : lower_[entering])
    room = rise ? difference(*own, values_[entering]) : difference(values_[entering], *own);
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Row &row = rows_[r];
    const int sign = row.of[column].sign();
    if (sign == 0)
      continue;
    const Bound &bound = (sign > 0) == rise ? upper_[row.basic] : lower_[row.basic];
    if (!bound)
      continue;
    const Rational per_value = (rise ? 1 : -1) / row.of[column];
    Infinitesimal distance = product(difference(*bound, values_[row.basic]), per_value);
    if (!room || distance < *room || (distance == *room && stop != itself && row.basic < rows_[stop].basic)) {
      room = std::move(distance);
      stop = r;
    }
  }
  if (!room)
    return false;
  move(column, rise ? *room : product(*room, -1));
  if (stop != itself)
    pivot(stop, column);
  return true;
}

std::vector<Rational> Simplex::concrete_values(std::size_t from, std::size_t to) const {
  Rational eps = 1;
  // room.value + room.tiny * eps >= 0 must hold; at half of the eps where it ends, nothing is at an end.
  const auto shrink = [&eps](const Infinitesimal &room) {
    if (room.tiny < 0)
      eps = std::min(eps, Rational(room.value / (-2 * room.tiny)));
  };
  for (std::size_t x = 0; x < values_.size(); ++x) {
    if (lower_[x])
      shrink(difference(values_[x], *lower_[x]));
    if (upper_[x])
      shrink(difference(*upper_[x], values_[x]));
  }
  std::vector<Rational> values;
  for (std::size_t x = from; x < to; ++x)
    values.push_back(values_[x].value + values_[x].tiny * eps);
  return values;
}

void Simplex::minimise(std::size_t variable) {
  if (!row_of_[variable]) {
    const auto column = std::find(columns_.begin(), columns_.end(), variable);
    step(static_cast<std::size_t>(column - columns_.begin()), false);
  }
  while (row_of_[variable]) {
    const Row &row = rows_[*row_of_[variable]];
    const std::optional<std::size_t> column = entering(row, false);
    if (!column || !step(*column, row.of[*column].sign() < 0))
      return;
  }
}

} // namespace mdm
