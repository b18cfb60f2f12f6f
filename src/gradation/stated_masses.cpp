#include "gradation/stated_masses.hpp"

#include "gradation/plain_words.hpp"
#include "gradation/shown.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

PrintedNumber percent_of(const PrintedNumber &percent, const PrintedNumber &whole) {
  return {percent.value * whole.value / 100,
          (percent.half * whole.value + whole.half * (percent.value + percent.half)) / 100};
}

/// The same statement with another mass.
StatedMass with_mass(StatedMass stated, PrintedNumber mass) {
  stated.mass = std::move(mass);
  return stated;
}

class StatementReader {
public:
  StatementReader(const AccountRows &rows, const AccountColumn &chosen, const Source &source)
      : rows_(rows), chosen_(chosen), source_(source) {}

  StatedMasses read(const std::vector<StatedNumber> &numbers) {
    for (const StatedNumber &number : numbers)
      take(number);
    take_container();
    if (!masses_.initial)
      std::swap(masses_.initial, masses_.total);
    find_wash_loss();
    return std::move(masses_);
  }

private:
  void take(const StatedNumber &number) {
    const MassStatement &s = number.statement;
    if (is_row(s.meaning))
      return leave_row(s);
    std::optional<StatedMass> *place = place_of(s.meaning);
    if (place == nullptr)
      return leave(number);
    if (s.is_percent)
      return take_percent(number);
    check_unit(s);
    const StatedMass stated = in_grams(number);
    if (*place && !agree((*place)->mass, stated.mass))
      source_.refuse(s.line, fmt::format("{} is {} here, and {} in line {}: leave the wrong one out",
                                         in_quotes(s.label), shown(number.number.value),
                                         shown((*place)->mass.value), (*place)->line));
    if (!*place)
      *place = stated;
  }

  /// A mass that is not in grams cannot be compared with a column that does not say its unit.
  void check_unit(const MassStatement &s) const {
    if (s.grams > 1 && chosen_.grams == 0 && !chosen_.is_share())
      source_.refuse(
          s.line, fmt::format("{} is not in g, and the column {} has no unit of mass: write it in the header",
                              in_quotes(s.label), in_quotes(chosen_.header)));
  }

  static bool is_row(RowMeaning meaning) {
    return meaning == RowMeaning::pan || meaning == RowMeaning::pan_and_wash ||
           meaning == RowMeaning::passing;
  }

  /// Null for what is not compared.
  std::optional<StatedMass> *place_of(RowMeaning meaning) {
    switch (meaning) {
    case RowMeaning::initial_mass:
      return &masses_.initial;
    case RowMeaning::total:
      return &masses_.total;
    case RowMeaning::sieved_mass:
      return &masses_.sieved;
    case RowMeaning::washed_mass:
      return &masses_.washed;
    case RowMeaning::wash_loss:
      return &masses_.wash_loss;
    case RowMeaning::sieve_loss:
      return &masses_.sieve_loss;
    case RowMeaning::container:
      return &container_;
    case RowMeaning::with_container:
      return &with_container_;
    case RowMeaning::washed_with_container:
      return &washed_with_container_;
    default:
      return nullptr;
    }
  }

  static StatedMass in_grams(const StatedNumber &number) {
    const MassStatement &s = number.statement;
    return {s.label, s.line, s.grams != 0, s.grams == 0 ? number.number : number.number * Rational(s.grams)};
  }

  /// A percentage is compared where it may hide fines.
  void take_percent(const StatedNumber &number) {
    const MassStatement &s = number.statement;
    const StatedMass stated{s.label, s.line, s.grams != 0, number.number};
    if (s.meaning == RowMeaning::wash_loss)
      masses_.wash_percent = stated;
    else if (s.meaning == RowMeaning::sieve_loss)
      masses_.sieve_loss_percent = stated;
    else
      leave(number);
  }

  /// A row of the table that is not in it; in a heading a pan may be an empty one.
  void leave_row(const MassStatement &s) {
    const bool is_there =
        rows_.all_fines() != nullptr || (s.meaning == RowMeaning::pan && rows_.pan() != nullptr);
    if (!is_there && chosen_.is_retained())
      source_.refuse(s.line,
                     fmt::format("{} stands beside the table: write it as a row of the table, or leave it "
                                 "out if it is an empty pan",
                                 in_quotes(s.label)));
    masses_.left.add(s.label);
  }

  void leave(const StatedNumber &number) {
    const MassStatement &s = number.statement;
    if (speaks_of_washing(s.label) && number_may_be_mass(s))
      source_.refuse(s.line,
                     fmt::format("{} may be what was washed out, or not: write 'Wash loss' for what went, "
                                 "'Dry mass before wash' and 'Dry mass after wash' for the rest",
                                 in_quotes(s.label)));
    const bool names_finest = s.label.starts_with('-') && words_of(s.label).front() == "200"; // ASTM's
    if (s.is_percent && (may_be_fines(s.label) || names_finest))
      masses_.fines_percent.push_back({s.label, s.line, false, number.number});
    if (s.grams != 0 || speaks_of_mass(s.label))
      masses_.left.add(s.label);
    if ((s.grams != 0 || (may_be_fines(s.label) && !s.is_percent)) &&
        !speaks_of_moisture_or_container(s.label))
      masses_.uncompared.push_back(in_grams(number));
  }
  /// Numbers of standards, dates and times stand beside words of washing too.
  static bool number_may_be_mass(const MassStatement &s) {
    return s.grams != 0 || s.is_percent || speaks_of_mass(s.label) || names_washed_part(s.label);
  }

  /// The dry mass of what was weighed in a container.
  void take_container() {
    if (container_ && with_container_ && !masses_.initial)
      masses_.initial = with_mass(*with_container_, with_container_->mass - container_->mass);
    if (!washed_with_container_ || masses_.washed)
      return;
    if (!container_)
      source_.refuse(
          washed_with_container_->line,
          fmt::format("{} has the mass of its container, which is not given: write 'Dry mass after "
                      "wash' without it, or the row 'Tare'",
                      in_quotes(washed_with_container_->label)));
    masses_.washed = with_mass(*washed_with_container_, washed_with_container_->mass - container_->mass);
  }

  /// What was washed out is the difference of two masses, or a percentage of the first.
  void find_wash_loss() {
    const std::optional<StatedMass> &initial = masses_.initial, &washed = masses_.washed;
    std::optional<StatedMass> &loss = masses_.wash_loss;
    if (loss && initial && washed && !agree(loss->mass, initial->mass - washed->mass))
      source_.refuse(loss->line, fmt::format("{} is {}, and {} less {} is {}: correct one of them",
                                             in_quotes(loss->label), shown(loss->mass.value),
                                             in_quotes(initial->label), in_quotes(washed->label),
                                             shown(Rational(initial->mass.value - washed->mass.value))));
    if (initial && washed && (washed->mass - initial->mass).range().lo > 0)
      source_.refuse(washed->line,
                     fmt::format("{} is {}, and {} is {}: a sample gains nothing by washing: correct one of "
                                 "them",
                                 in_quotes(washed->label), shown(washed->mass.value),
                                 in_quotes(initial->label), shown(initial->mass.value)));
    if (!loss && initial && washed) {
      loss = with_mass(*washed, initial->mass - washed->mass);
      loss->label = initial->label + " less " + washed->label;
    } else if (!loss && initial && masses_.wash_percent) {
      loss = with_mass(*masses_.wash_percent, percent_of(masses_.wash_percent->mass, initial->mass));
      loss->label += " of " + initial->label;
    }
  }

  const AccountRows &rows_;
  const AccountColumn &chosen_;
  const Source &source_;
  StatedMasses masses_;
  std::optional<StatedMass> container_, with_container_, washed_with_container_;
};

} // namespace

StatedMasses stated_masses(const std::vector<StatedNumber> &numbers, const AccountRows &rows,
                           const AccountColumn &chosen, const Source &source) {
  return StatementReader(rows, chosen, source).read(numbers);
}

std::optional<PrintedNumber> in_unit_of(const AccountColumn &column,
                                        const std::optional<StatedMass> &stated) {
  if (!stated)
    return std::nullopt;
  return stated->is_in_grams && column.grams > 1 ? stated->mass * ratio(1, column.grams) : stated->mass;
}

} // namespace mdm
