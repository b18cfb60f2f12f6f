#include "gradation/table.hpp"

#include "gradation/mass_digits.hpp"
#include "gradation/shown.hpp"
#include "text/option_name.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

namespace mdm {
namespace {

/// Turns a table into a gradation, step by step; after `sort` all columns ascend by size.
class Completion {
public:
  Completion(Table table, const Source &source) : t_(std::move(table)), source_(source) {}

  Gradation run() {
    check_rows();
    sort();
    if (t_.column->form == MassForm::retained)
      check_retained();
    else
      passing_to_masses();
    return Gradation({std::move(t_.id), t_.unit, std::move(t_.sizes), std::move(t_.values),
                      std::move(t_.factors), std::move(t_.tolerances), std::move(t_.roundings),
                      std::move(t_.notes), t_.root, std::move(t_.file_unit)});
  }

private:
  [[noreturn]] void refuse(std::size_t row, const std::string &what) const {
    source_.refuse(t_.lines[row], what);
  }

  /// A row's value with what it is.
  std::string value(std::size_t row) const {
    return fmt::format("{} {}", t_.column->words, shown(t_.values[row]));
  }

  std::string size(std::size_t row) const {
    return fmt::format("{} {}", shown(RootSize{t_.sizes[row], t_.root}), name(t_.unit));
  }

  void check_rows() const {
    if (t_.sizes.size() < 2)
      source_.refuse(
          t_.header_line,
          fmt::format("a gradation needs at least two rows below the header, there are {}", t_.sizes.size()));
    const bool limited = t_.column->form != MassForm::retained;
    for (std::size_t row = 0; row < t_.sizes.size(); ++row) {
      if (t_.sizes[row] < 0)
        refuse(row, fmt::format("size {} is negative: give the opening of the sieve", size(row)));
      if (t_.values[row] < 0)
        refuse(row, fmt::format("{} is negative: correct it", value(row)));
      if (limited && t_.values[row] > t_.column->full)
        refuse(row, fmt::format("{} is above {}", value(row), t_.column->full));
      if (!t_.factors.empty() && t_.factors[row] <= 0)
        refuse(row, fmt::format("factor {} is not above 0: give a ratio of densities, 1 for none",
                                shown(t_.factors[row])));
      if (!t_.tolerances.empty() && t_.tolerances[row] < 0)
        refuse(row, fmt::format("tolerance {} is negative: give percentage points from 0 on",
                                shown(t_.tolerances[row])));
    }
  }

  void sort() {
    std::vector<std::size_t> order(t_.sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t i, std::size_t j) { return t_.sizes[i] < t_.sizes[j]; });
    arrange(t_.sizes, order);
    arrange(t_.values, order);
    arrange(t_.factors, order);
    arrange(t_.tolerances, order);
    arrange(t_.roundings, order);
    arrange(t_.lines, order);
    const auto repeated = std::adjacent_find(t_.sizes.begin(), t_.sizes.end());
    if (repeated != t_.sizes.end()) {
      const auto row = static_cast<std::size_t>(repeated - t_.sizes.begin());
      refuse(row + 1,
             fmt::format("size {} repeats that of line {}: leave one out", size(row), t_.lines[row]));
    }
  }

  template <typename Entry>
  static void arrange(std::vector<Entry> &column, const std::vector<std::size_t> &order) {
    if (column.empty())
      return;
    std::vector<Entry> arranged;
    arranged.reserve(column.size());
    for (const std::size_t row : order)
      arranged.push_back(std::move(column[row]));
    column = std::move(arranged);
  }

  /// Cond1 (Arnold, Eq. 9).
  void check_retained() {
    const std::size_t last = t_.sizes.size() - 1;
    if (t_.values[last] != 0)
      refuse(last, fmt::format("the largest sieve, {}, has {}, not 0: add a row for a larger sieve with {} 0",
                               size(last), value(last), t_.column->words));
    Rational sum = 0;
    for (const Rational &mass : t_.values)
      sum += mass;
    if (sum == 0)
      source_.refuse(t_.header_line,
                     fmt::format("no row has a {} above 0: write what each sieve retains", t_.column->words));
    if (t_.column->full != 0 && sum != t_.column->full)
      t_.notes.push_back(fmt::format("The {} values add up to {}, not {}; they are used as they are.",
                                     t_.column->words, shown(sum), t_.column->full));
  }

  /// The mass that passes the sieve of a row.
  Rational passing(std::size_t row) const {
    return t_.column->form == MassForm::passing ? t_.values[row] : Rational(t_.column->full - t_.values[row]);
  }

  void passing_to_masses() {
    const std::size_t last = t_.sizes.size() - 1;
    std::vector<Rational> masses;
    masses.reserve(t_.sizes.size() + 1);
    for (std::size_t row = 0; row < last; ++row) {
      masses.push_back(passing(row + 1) - passing(row));
      if (masses.back() < 0)
        refuse_order(row);
    }
    masses.push_back(0);
    if (passing(last) != t_.column->full)
      refuse_largest(last);
    const Rational finest = passing(0);
    t_.values = std::move(masses);
    if (finest != 0)
      add_pan(finest);
  }

  [[noreturn]] void refuse_order(std::size_t row) const {
    const bool passes = t_.column->form == MassForm::passing;
    refuse(row + 1, fmt::format("{} at {} is {} {} at {}, but it must not {} with size: correct one of them",
                                value(row + 1), size(row + 1), passes ? "below" : "above",
                                shown(t_.values[row]), size(row), passes ? "decrease" : "increase"));
  }

  [[noreturn]] void refuse_largest(std::size_t last) const {
    const unsigned needed = t_.column->form == MassForm::passing ? t_.column->full : 0;
    if (needed == 100 && passing(last) == 1)
      refuse(last, fmt::format("the largest sieve, {}, has {}: name the column passing_fraction if these are "
                               "fractions, or add a row for a larger sieve with {} 100",
                               size(last), value(last), t_.column->words));
    refuse(last,
           fmt::format("the largest sieve, {}, has {}, not {}: add a row for a larger sieve with {} {}{}",
                       size(last), value(last), needed, t_.column->words, needed, round_remedy(last)));
  }

  /// The other remedy where the largest sieve passes all but a rounding error.
  std::string round_remedy(std::size_t last) const {
    const std::optional<unsigned> digits = digits_that_give(passing(last), t_.column->full);
    if (!digits)
      return {};
    return t_.column->form == MassForm::passing
               ? fmt::format(", or take all values to {0} digits with {1} {0}", *digits, option("round"))
               : ", or correct the value to 0 if that is what it means";
  }

  /// Puts what passes the finest sieve into a pan of size 0.
  void add_pan(const Rational &mass) {
    if (t_.sizes.front() == 0)
      refuse(0, fmt::format("{} at size 0: nothing passes the pan, so this must be {}", value_at_pan(mass),
                            t_.column->form == MassForm::passing ? 0 : t_.column->full));
    if (!t_.factors.empty())
      refuse(0, fmt::format(
                    "something passes the finest sieve, {}, and the pan below has no factor: add a row for "
                    "the size 'pan'",
                    size(0)));
    t_.notes.push_back(fmt::format("A pan of size 0 was added for the {} {} that pass the finest sieve, {}.",
                                   shown(mass), t_.column->full == 100 ? "percent" : "parts of 1", size(0)));
    t_.sizes.insert(t_.sizes.begin(), Rational(0));
    t_.values.insert(t_.values.begin(), mass);
    t_.roundings.insert(t_.roundings.begin(), Rational(0));
    if (!t_.tolerances.empty()) {
      t_.tolerances.insert(t_.tolerances.begin(), Rational(0));
      t_.notes.emplace_back("The added pan has the tolerance 0; give it a row of its own for another.");
    }
  }

  std::string value_at_pan(const Rational &passed) const {
    const Rational written =
        t_.column->form == MassForm::passing ? passed : Rational(t_.column->full - passed);
    return fmt::format("{} {}", t_.column->words, shown(written));
  }

  Table t_;
  const Source &source_;
};

} // namespace

const MassColumn *find_mass_column(std::string_view name) {
  const auto found = std::find_if(mass_columns.begin(), mass_columns.end(),
                                  [name](const MassColumn &c) { return c.name == name; });
  return found == mass_columns.end() ? nullptr : &*found;
}

Gradation to_gradation(Table table, const Source &source) {
  return Completion(std::move(table), source).run();
}

} // namespace mdm
