// The general simplex method in fractions, with bounds on variables and on linear forms of them (Dutertre,
// de Moura 2006). Every basic variable is kept as a form of the others. find() moves one that is beyond its
// bound to it, by a pivot with the variable that raises the aim least; if none can give way, the row itself
// is the contradiction, and its coefficients are the multipliers of a leaf (Farkas). minimise() goes on
// from there. It ends because after some pivots, and always in minimise(), the candidate of the least
// number is taken (Bland's rule), with which no basis comes twice. Rows are integers over one scale each,
// so that a pivot takes no fractions. Strict bounds are values with a multiple of an infinitesimal, for
// which concrete_values puts a number that is small enough.

#include "match/simplex.hpp"

#include "number/common_denominator.hpp"

#include <algorithm>
#include <cassert>

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

/// Adds r times a. Most numbers have nothing tiny.
void add_multiple(Infinitesimal &to, const Infinitesimal &a, const Rational &r) {
  if (a.value.sign() != 0)
    to.value += a.value * r;
  if (a.tiny.sign() != 0)
    to.tiny += a.tiny * r;
}

/// Divides a row's numbers, of which `scale` is one, by their greatest common divisor.
void reduce(Integer &scale, std::vector<Integer> &numbers) {
  Integer common = scale;
  for (const Integer &n : numbers) {
    if (common == 1)
      return;
    if (n.sign() != 0)
      mpz_gcd(common.backend().data(), common.backend().data(), n.backend().data());
  }
  if (common == 1)
    return;
  const auto divide = [&common](Integer &n) {
    mpz_divexact(n.backend().data(), n.backend().data(), common.backend().data());
  };
  divide(scale);
  for (Integer &n : numbers)
    if (n.sign() != 0)
      divide(n);
}

} // namespace

Simplex::Simplex(std::size_t variables, Watch watch)
    : watch_(std::move(watch)), columns_(variables), row_of_(variables), lower_(variables), upper_(variables),
      values_(variables) {
  for (std::size_t i = 0; i < variables; ++i)
    columns_[i] = i;
}

void Simplex::look() const {
  if (watch_.ends())
    throw Interrupted();
}

std::size_t Simplex::column_of(std::size_t variable) const {
  if (variable < columns_.size() && columns_[variable] == variable) // as it was at first
    return variable;
  return static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), variable) - columns_.begin());
}

/// Computes the row of a basic form, and its value.
void Simplex::define(std::size_t form, Row &row, const std::vector<std::pair<std::size_t, Rational>> &terms) {
  look();
  std::vector<Rational> coefficients(columns_.size());
  values_[form] = {};
  for (const auto &[variable, coefficient] : terms) {
    add_multiple(values_[form], values_[variable], coefficient);
    if (row_of_[variable]) {
      const Row &definition = rows_[*row_of_[variable]];
      for (std::size_t c = 0; c < columns_.size(); ++c)
        if (definition.of[c].sign() != 0)
          coefficients[c] += coefficient * ratio(definition.of[c], definition.scale);
    } else {
      coefficients[column_of(variable)] += coefficient;
    }
  }
  CommonDenominator cleared(coefficients);
  row = {form, std::move(cleared.denominator), std::move(cleared.numerators)};
}

std::size_t Simplex::add_form(const std::vector<std::pair<std::size_t, Rational>> &terms) {
  const std::size_t form = values_.size();
  values_.emplace_back();
  lower_.emplace_back();
  upper_.emplace_back();
  Row row;
  define(form, row, terms);
  row_of_.emplace_back(rows_.size());
  rows_.push_back(std::move(row));
  return form;
}

void Simplex::change_form(std::size_t form, const std::vector<std::pair<std::size_t, Rational>> &terms) {
  assert(row_of_[form]); // only a variable with a bound leaves the basis
  define(form, rows_[*row_of_[form]], terms);
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
  const Bound &bound = is_below(variable) ? lower_[variable] : upper_[variable];
  move(column_of(variable), difference(*bound, values_[variable]));
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
  for (const Row &row : rows_) {
    if (row.of[column].sign() == 0)
      continue;
    look();
    add_multiple(values_[row.basic], by, ratio(row.of[column], row.scale));
  }
}

/// Exchanges a row's basic variable with a column's.
void Simplex::pivot(std::size_t r, std::size_t c) {
  look();
  Row &row = rows_[r];
  const std::size_t entering = columns_[c];
  const std::size_t leaving = row.basic;
  // scale * leaving = a * entering + rest, so a * entering = scale * leaving - rest.
  std::vector<std::size_t> used;
  std::swap(row.scale, row.of[c]);
  const bool negative = row.scale.sign() < 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (row.of[i].sign() == 0)
      continue;
    if ((i == c) == negative)
      row.of[i] = -row.of[i];
    used.push_back(i);
  }
  if (negative)
    row.scale = -row.scale;
  row.basic = entering;
  columns_[c] = leaving;
  row_of_[entering] = r;
  row_of_[leaving].reset();
  for (Row &other : rows_) {
    if (&other == &row || other.of[c].sign() == 0)
      continue;
    look();
    const Integer common = gcd(other.of[c], row.scale);
    const Integer factor = other.of[c] / common;
    const Integer scale = row.scale / common;
    other.of[c] = 0;
    if (scale != 1) {
      other.scale *= scale;
      for (Integer &n : other.of)
        if (n.sign() != 0)
          n *= scale;
    }
    for (const std::size_t i : used)
      mpz_addmul(other.of[i].backend().data(), factor.backend().data(), row.of[i].backend().data());
    reduce(other.scale, other.of);
  }
}

/// The least variable of columns that can make a row's basic variable rise or fall: with Bland's rule no
/// cycle can arise.
std::optional<std::size_t> Simplex::least_entering(const Row &row, bool rise) const {
  std::optional<std::size_t> best;
  for (std::size_t c = 0; c < columns_.size(); ++c)
    if ((!best || columns_[c] < columns_[*best]) && can_move(row, c, rise))
      best = c;
  return best;
}

/// The column that makes `aim` rise least: values that are least for it stay so (dual simplex).
std::optional<std::size_t> Simplex::cheapest_entering(const Row &row, bool rise, std::size_t aim) const {
  const Row *cost = row_of_[aim] ? &rows_[*row_of_[aim]] : nullptr;
  const auto cost_of = [&](std::size_t c) {
    return cost ? Integer(abs(cost->of[c])) : Integer(columns_[c] == aim ? 1 : 0);
  };
  std::optional<std::size_t> best;
  Integer best_cost;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    if (!can_move(row, c, rise))
      continue;
    look();
    Integer other = cost_of(c);
    if (best) {
      const Integer a = other * abs(row.of[*best]), b = best_cost * abs(row.of[c]);
      if (b < a || (a == b && columns_[*best] < columns_[c]))
        continue;
    }
    best = c;
    best_cost = std::move(other);
  }
  return best;
}

bool Simplex::can_move(const Row &row, std::size_t column, bool rise) const {
  const int sign = row.of[column].sign();
  return sign != 0 && ((sign > 0) == rise ? can_rise(columns_[column]) : can_fall(columns_[column]));
}

/// No column can make the row's basic variable rise (or fall) to its bound: the bounds of all that hold it.
void Simplex::explain(const Row &row, bool rise) {
  conflict_.assign(1, {row.basic, !rise, Rational(row.scale)});
  for (std::size_t c = 0; c < columns_.size(); ++c)
    if (const int sign = row.of[c].sign(); sign != 0)
      conflict_.push_back({columns_[c], (sign > 0) == rise, Rational(abs(row.of[c]))});
}

/// A row whose basic variable is out of bounds: the one of shortest numbers, which stay short so; or, by
/// Bland's rule, that of the least variable.
std::optional<std::size_t> Simplex::violated_row(bool by_bland) const {
  std::optional<std::size_t> best;
  std::size_t best_length = 0;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Row &row = rows_[r];
    if (!is_below(row.basic) && !is_above(row.basic))
      continue;
    std::size_t length = by_bland ? row.basic : bit_length(row.scale);
    for (std::size_t c = 0; c < row.of.size() && !by_bland; ++c)
      length += row.of[c].sign() == 0 ? 0 : bit_length(row.of[c]);
    if (best && best_length <= length)
      continue;
    best = r;
    best_length = length;
  }
  return best;
}

bool Simplex::find(std::size_t aim) {
  for (std::size_t x = 0; x < values_.size(); ++x)
    if (lower_[x] && upper_[x] && *upper_[x] < *lower_[x]) {
      conflict_ = {{x, false, 1}, {x, true, 1}};
      return false;
    }
  const std::size_t patience = 2 * values_.size(); // after so many pivots it may be in a cycle
  for (std::size_t pivots = 0;; ++pivots) {
    const bool by_bland = pivots >= patience;
    const std::optional<std::size_t> r = violated_row(by_bland);
    if (!r)
      return true;
    const Row &row = rows_[*r];
    const bool rise = is_below(row.basic);
    const std::optional<std::size_t> column =
        by_bland ? least_entering(row, rise) : cheapest_entering(row, rise, aim);
    if (!column) {
      explain(row, rise);
      return false;
    }
    const Infinitesimal missing =
        difference(rise ? *lower_[row.basic] : *upper_[row.basic], values_[row.basic]);
    move(*column, product(missing, ratio(row.scale, row.of[*column])));
    pivot(*r, *column);
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
    look();
    const Bound &bound = (sign > 0) == rise ? upper_[row.basic] : lower_[row.basic];
    if (!bound)
      continue;
    const Rational per_value = ratio(rise ? row.scale : Integer(-row.scale), row.of[column]);
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
    look();
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
  if (!row_of_[variable])
    step(column_of(variable), false);
  while (row_of_[variable]) {
    const Row &row = rows_[*row_of_[variable]];
    const std::optional<std::size_t> column = least_entering(row, false);
    if (!column || !step(*column, row.of[*column].sign() < 0))
      return;
  }
}

} // namespace mdm
