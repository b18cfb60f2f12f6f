#pragma once
/// \file
/// What a laboratory's sheet says of masses above and below its table, with what follows from it: the dry
/// mass of what was weighed in a container, and what was washed out.

#include "gradation/account_column.hpp"
#include "gradation/account_rows.hpp"
#include "gradation/mass_statements.hpp"
#include "text/short_list.hpp"

namespace mdm {

/// A mass beside words, or a percentage.
struct StatedMass {
  std::string label;
  std::size_t line;
  bool is_in_grams; ///< else in the unit of the columns
  PrintedNumber mass;
};

/// What is said of one sample, each once.
struct StatedMasses {
  std::optional<StatedMass> initial, sieved, washed, wash_loss, sieve_loss;
  std::optional<StatedMass> total; ///< beside an initial mass
  std::optional<StatedMass> wash_percent, sieve_loss_percent;
  std::vector<StatedMass> fines_percent; ///< what is said to be fine
  ShortList left;                        ///< masses that nothing is compared with ...
  std::vector<StatedMass> uncompared; ///< ... those of them with a unit, or of fines, but for moist ones and
                                      ///< containers
};

/// Understands what stands beside a table.
/// \param rows  of the table; `chosen` is its first column
/// \throws InputError where one mass is given twice, where masses do not fit each other, where a row of the
/// table stands beside it, and where it is not certain what a mass is
StatedMasses stated_masses(const std::vector<StatedNumber> &numbers, const AccountRows &rows,
                           const AccountColumn &chosen, const Source &source);

/// A mass in the unit of a column; nothing where there is none.
std::optional<PrintedNumber> in_unit_of(const AccountColumn &column, const std::optional<StatedMass> &stated);

} // namespace mdm
