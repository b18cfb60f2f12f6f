#include "report/triaxial_log.hpp"

#include "particles/triaxial_columns.hpp"
#include "text/lines.hpp"
#include "text/source.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

/// Numbers, and behind them the name of the constant stress.
constexpr std::size_t triaxial_numbers = 7, triaxial_fields = triaxial_numbers + 1;

Rational number_of(const std::string &column, const std::string &text) {
  try {
    return parse_decimal(text);
  } catch (const InputError &e) {
    throw InputError(column + ": " + e.what());
  }
}

TriaxialState state_of(const std::vector<std::string> &fields, const std::vector<std::string> &names) {
  if (fields.size() != triaxial_fields)
    throw InputError(fmt::format("{} fields, not {}: leave the row out where the run was stopped in it",
                                 fields.size(), triaxial_fields));
  std::vector<Rational> numbers;
  for (std::size_t i = 0; i < triaxial_numbers; ++i)
    numbers.push_back(number_of(names[i], fields[i]));
  TriaxialState s{numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5], numbers[6]};
  for (const std::size_t strain : {0U, 1U})
    if (numbers[strain] >= 1)
      throw InputError(names[strain] + " " + in_quotes(fields[strain]) +
                       " is not below 1: strains are parts, not percent");
  for (const std::size_t i : {4U, 5U, 6U})
    if (numbers[i] < 0)
      throw InputError(names[i] + " " + in_quotes(fields[i]) + " is below 0");
  return s;
}

/// Takes the name of the constant stress, which is the same in all rows.
void take_constant(TriaxialLog &log, const std::string &column, const std::string &name) {
  if (name != "sigma_3" && name != "p")
    throw InputError(column + " " + in_quotes(name) + " is neither sigma_3 nor p");
  if (log.states.empty())
    log.constant = name;
  if (log.constant != name)
    throw InputError(column + " " + in_quotes(name) + " is another than that of the row before, " +
                     log.constant + ": give each test a file of its own");
}

} // namespace

bool is_triaxial_log(std::string_view content) {
  mdm::Lines lines(without_byte_order_mark(content));
  return lines.next() && trimmed(lines.text()) == triaxial_columns;
}

TriaxialLog read_triaxial_log(std::string_view content, const std::string &file) {
  const Source source(file);
  mdm::Lines lines(without_byte_order_mark(content));
  std::vector<std::string> names, fields;
  if (!lines.next() || trimmed(lines.text()) != triaxial_columns)
    source.refuse(1, std::string("the first line is not ") + triaxial_columns);
  split_fields(lines.text(), ',', names);
  TriaxialLog log;
  std::vector<TriaxialState> &states = log.states;
  while (lines.next()) {
    if (trimmed(lines.text()).empty())
      continue;
    try {
      if (!split_fields(lines.text(), ',', fields))
        throw InputError("a quoted field does not end");
      TriaxialState state = state_of(fields, names);
      if (!states.empty() && state.axial_strain <= states.back().axial_strain)
        throw InputError(names[0] + " " + in_quotes(fields[0]) +
                         " is not above that of the row before: leave out the rows that stand twice");
      take_constant(log, names[triaxial_numbers], fields[triaxial_numbers]);
      states.push_back(std::move(state));
    } catch (const InputError &e) {
      source.refuse(lines.number(), e.what());
    }
  }
  if (states.size() < 2)
    throw InputError(file + ": fewer than two rows: there is nothing to draw");
  return log;
}

} // namespace mdm
