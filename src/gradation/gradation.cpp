#include "gradation/shown.hpp"

#include <mdm/gradation/gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <optional>

namespace mdm {
namespace {

/// An opening, given to the power of the root, with its unit.
std::string named(const Gradation::Data &data, const Rational &size) {
  return fmt::format("{} {}", shown(RootSize{size, data.root}), name(data.unit));
}

void check_lengths(const Gradation::Data &data) {
  const std::size_t n = data.sizes.size();
  if (n < 2)
    throw InputError(fmt::format("a gradation needs at least two sizes, there are {}", n));
  const auto fits = [n](const std::vector<Rational> &column) { return column.empty() || column.size() == n; };
  if (data.masses.size() != n || !fits(data.factors) || !fits(data.tolerances) || !fits(data.roundings))
    throw InputError(
        fmt::format("masses, factors, tolerances and roundings must be as many as the sizes, {}", n));
}

void check_sizes(const Gradation::Data &data) {
  if (data.sizes.front().sign() < 0)
    throw InputError(fmt::format("size {} is negative", named(data, data.sizes.front())));
  const auto repeated = std::adjacent_find(data.sizes.begin(), data.sizes.end(), std::greater_equal<>());
  if (repeated != data.sizes.end())
    throw InputError(fmt::format("size {} does not ascend", named(data, *std::next(repeated))));
}

void check_masses(const Gradation::Data &data) {
  const auto negative =
      std::find_if(data.masses.begin(), data.masses.end(), [](const Rational &m) { return m.sign() < 0; });
  if (negative != data.masses.end())
    throw InputError(fmt::format("mass {} is negative", shown(*negative)));
  if (data.masses.back().sign() != 0)
    throw InputError(fmt::format("the largest sieve, {}, retains {}: add a larger sieve that retains 0",
                                 named(data, data.sizes.back()), shown(data.masses.back())));
  if (std::all_of(data.masses.begin(), data.masses.end(), [](const Rational &m) { return m.sign() == 0; }))
    throw InputError("no sieve retains anything: give at least one mass above 0");
}

void check_columns(const Gradation::Data &data) {
  if (std::any_of(data.factors.begin(), data.factors.end(), [](const Rational &c) { return c.sign() <= 0; }))
    throw InputError("a factor must be above 0");
  if (std::any_of(data.tolerances.begin(), data.tolerances.end(),
                  [](const Rational &e) { return e.sign() < 0; }))
    throw InputError("a tolerance must not be negative");
}

/// Removes the first `count` entries of a column that may be absent.
void drop_front(std::vector<Rational> &column, std::ptrdiff_t count) {
  if (!column.empty())
    column.erase(column.begin(), column.begin() + count);
}

/// The first openings, for a message.
std::string openings(const Gradation::Data &data) {
  constexpr std::size_t most = 30;
  std::string text;
  for (std::size_t j = 0; j < data.sizes.size() && j < most; ++j)
    text += (j == 0 ? "" : ", ") + shown(RootSize{data.sizes[j], data.root});
  return data.sizes.size() > most ? text + ", ..." : text;
}

} // namespace

Gradation::Gradation(Data data) : data_(std::move(data)) {
  check_invariant();
}

Gradation::Gradation(std::vector<Rational> sizes, std::vector<Rational> masses, SizeUnit unit, std::string id)
    : Gradation(Data{std::move(id), unit, std::move(sizes), std::move(masses), {}, {}, {}, {}}) {}

void Gradation::check_invariant() const {
  if (data_.unit == SizeUnit::in)
    throw InputError("a gradation is kept in mm, um or m: give its sizes in one of them");
  check_lengths(data_);
  check_sizes(data_);
  check_masses(data_);
  check_columns(data_);
}

void Gradation::refuse_roots() const {
  const auto irrational = std::find_if(data_.sizes.begin(), data_.sizes.end(), [this](const Rational &size) {
    return !RootSize{size, data_.root}.fraction();
  });
  throw InputError(fmt::format(
      "openings of phi that is no whole number are irrational{}, and here only fractions will do: {}",
      irrational == data_.sizes.end() ? "" : " (about " + named(data_, *irrational) + ")",
      fractions_remedy()));
}

std::string Gradation::opening_text(std::size_t j) const {
  return root() == 1 ? to_decimal(data_.sizes[j]) : opening(j).text();
}

std::vector<MaterialRows>::const_iterator Gradation::material_of(std::size_t j) const {
  return std::partition_point(materials_.begin(), materials_.end(),
                              [j](const MaterialRows &rows) { return rows.end <= j; });
}

const std::string &Gradation::material(std::size_t j) const {
  static const std::string none;
  return materials_.empty() ? none : material_of(j)->name;
}

bool Gradation::is_class(std::size_t j) const {
  return j < classes() && (materials_.empty() || j + 1 < material_of(j)->end);
}

std::size_t Gradation::coarsest() const {
  std::optional<std::size_t> coarsest;
  for (std::size_t j = 0; j < classes(); ++j)
    if (mass(j) != 0 && (!coarsest || powers()[*coarsest] < powers()[j]))
      coarsest = j;
  return coarsest.value();
}

Gradation Gradation::with_pan_size(const Rational &size) const {
  assert(materials_.empty());
  if (!has_pan())
    throw InputError(
        fmt::format("there is no pan to give a size to, the finest sieve has {}: leave the pan's size out",
                    named(data_, data_.sizes[0])));
  const Rational powered = power(size, root());
  if (size <= 0 || powered >= data_.sizes[1])
    throw InputError(fmt::format("pan size {} must lie between 0 and the finest sieve, {}", shown(size),
                                 named(data_, data_.sizes[1])));
  Data data = data_;
  data.sizes.front() = powered;
  return Gradation(std::move(data));
}

Gradation Gradation::cut_below(const Rational &size) const {
  assert(materials_.empty());
  const auto found = std::find_if(data_.sizes.begin(), data_.sizes.end(), [&](const Rational &power) {
    return RootSize{power, root()}.is_named_by(size);
  });
  if (found == data_.sizes.end())
    throw InputError(fmt::format("there is no sieve of {} to cut at: the sieves are {}", shown(size, unit()),
                                 openings(data_)));
  if (std::next(found) == data_.sizes.end())
    throw InputError(fmt::format("cutting at the largest sieve, {}, leaves nothing: cut at a finer one",
                                 shown(size, unit())));
  const std::ptrdiff_t count = found - data_.sizes.begin();
  if (std::all_of(data_.masses.begin() + count, data_.masses.end(),
                  [](const Rational &m) { return m.sign() == 0; }))
    throw InputError(fmt::format("cutting at {} leaves no mass: cut at a finer sieve", shown(size, unit())));
  return from_class(static_cast<std::size_t>(count));
}

Gradation Gradation::from_class(std::size_t j) const {
  assert(materials_.empty());
  const auto count = static_cast<std::ptrdiff_t>(j);
  Data data = data_;
  drop_front(data.sizes, count);
  drop_front(data.masses, count);
  drop_front(data.factors, count);
  drop_front(data.tolerances, count);
  drop_front(data.roundings, count);
  return Gradation(std::move(data));
}

Gradation Gradation::scaled(const Rational &factor) const {
  if (factor <= 0)
    throw InputError(fmt::format("size factor {} must be above 0", shown(factor)));
  const Rational powered = power(factor, root());
  Gradation scaled = *this;
  for (Rational &size : scaled.data_.sizes)
    size *= powered;
  return scaled;
}

} // namespace mdm
