#include "gradation/camsizer_reader.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/number_shares.hpp"
#include "gradation/shown.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

constexpr std::size_t lower_column = 0, upper_column = 1, share_column = 2, finer_column = 3,
                      camsizer_columns = 4;

bool is_camsizer_header(const CellRow &row) {
  const std::vector<std::string> &c = row.cells;
  const auto share = std::find(c.begin(), c.end(), "p3 [%]");
  const auto place = static_cast<std::size_t>(share - c.begin());
  const bool names_unit = std::any_of(c.begin(), share, [](const std::string &cell) {
    return cell.find("[mm]") != std::string::npos || cell.find("[\u00B5m]") != std::string::npos ||
           cell.find("[\u03BCm]") != std::string::npos;
  });
  // The two columns of sizes have one name or two.
  return (place == 1 || place == 2) && names_unit && place + 1 < c.size() && c[place + 1] == "Q3 [%]";
}

class Camsizer {
public:
  Camsizer(const Cells &cells, std::size_t header, const Source &source)
      : cells_(cells), header_(header), source_(source) {}

  Table read(const std::string &id) {
    end_ = header_ + 1;
    while (end_ < cells_.rows.size() && is_class(cells_.rows[end_]))
      ++end_;
    table_.id = id;
    table_.header_line = cells_.rows[header_].line;
    if (end_ == header_ + 1)
      source_.refuse(table_.header_line, "there is no row of a size class below this header");
    refuse_number_shares(cells_, header_, source_);
    find_unit();
    find_sign();
    for (row_ = header_ + 1; row_ < end_; ++row_)
      read_class();
    add_row(top_, 0);
    check_end();
    describe();
    return std::move(table_);
  }

private:
  static bool is_class(const CellRow &row) {
    for (std::size_t column = 0; column < camsizer_columns; ++column)
      if (!number_cell(row.cell(column)))
        return false;
    return true;
  }

  const CellRow &row() const { return cells_.rows[row_]; }
  [[noreturn]] void refuse(const std::string &what) const { source_.refuse(row().line, what); }

  void find_unit() {
    const std::vector<std::string> &header = cells_.rows[header_].cells;
    for (const std::string &cell : header) {
      if (cell.find("[mm]") != std::string::npos)
        return;
      if (cell.find("[\u00B5m]") != std::string::npos || cell.find("[\u03BCm]") != std::string::npos) {
        table_.unit = SizeUnit::um;
        return;
      }
    }
  }

  void find_sign() {
    DecimalSign sign(false, true);
    for (std::size_t i = header_ + 1; i < end_; ++i)
      for (std::size_t column = 0; column < camsizer_columns; ++column)
        sign.see(number_cell(cells_.rows[i].cell(column))->digits);
    try {
      point_ = sign.sign();
    } catch (const InputError &error) {
      source_.refuse(table_.header_line, error.what());
    }
  }

  std::string_view digits(std::size_t column) const { return number_cell(row().cell(column))->digits; }

  Rational number(std::size_t column) const {
    try {
      return parse_decimal(digits(column), point_);
    } catch (const InputError &error) {
      refuse(error.what());
    }
  }

  void add_row(const Rational &size, const Rational &value) {
    table_.lines.push_back(cells_.rows[std::min(row_, end_ - 1)].line);
    table_.sizes.push_back(size);
    table_.values.push_back(value);
  }

  void read_class() {
    const Rational lower = number(lower_column), upper = number(upper_column);
    if (upper <= lower)
      refuse(fmt::format("the class from {} to {} is empty: export the table again", shown(lower),
                         shown(upper)));
    if (row_ > header_ + 1 && lower != top_)
      refuse(fmt::format("the class begins at {}, the one above ends at {}: export all classes", shown(lower),
                         shown(top_)));
    add_row(lower, number(share_column));
    top_ = upper;
    check_sum();
  }

  /// Q3 is the sum of p3 so far, each rounded to its digits.
  void check_sum() {
    sum_ += number(share_column);
    error_ += last_digit_unit(digits(share_column), point_) / 2;
    finer_ = number(finer_column);
    finer_error_ = last_digit_unit(digits(finer_column), point_) / 2;
    if (abs(Rational(finer_ - sum_)) > error_ + finer_error_)
      refuse(fmt::format(
          "Q3 is {}, but p3 adds up to {} so far: export the whole table, from the finest class on",
          shown(finer_), shown(sum_)));
  }

  /// All of the sample is in the classes of this table.
  void check_end() const {
    const CellRow &last = cells_.rows[end_ - 1];
    if (const Rational missing = abs(Rational(100 - finer_)); missing > finer_error_)
      source_.refuse(
          last.line,
          fmt::format("Q3 ends at {}, not at 100: what is coarser than {} has no class here: export "
                      "the whole table",
                      shown(finer_), shown(top_)));
    for (std::size_t i = end_; i < cells_.rows.size(); ++i)
      if (is_camsizer_header(cells_.rows[i]))
        source_.refuse(cells_.rows[i].line,
                       "a second table of classes, which is not read: give a file of one measurement");
  }

  void describe() {
    table_.column = find_mass_column("retained_percent");
    table_.format = "CAMSIZER table";
    table_.sizes_from = fmt::format("bounds of the classes, in {}", name(table_.unit));
    table_.masses_from = "column p3 [%]: percent retained, by volume";
    table_.is_canonical = false;
    table_.notes.emplace_back("Shares are p3, by volume; Q3 agrees with them.");
  }

  const Cells &cells_;
  std::size_t header_, end_ = 0, row_ = 0;
  const Source &source_;
  char point_ = '.';
  Table table_;
  Rational top_ = 0, sum_ = 0, error_ = 0;
  Rational finer_ = 0, finer_error_ = 0; ///< Q3 of the class, and half a unit of its last digit
};

} // namespace

std::optional<std::size_t> camsizer_header(const Cells &cells) {
  const auto found = std::find_if(cells.rows.begin(), cells.rows.end(), is_camsizer_header);
  return found == cells.rows.end() ? std::nullopt
                                   : std::optional(static_cast<std::size_t>(found - cells.rows.begin()));
}

Table read_camsizer(const Cells &cells, std::size_t header, const Source &source, const std::string &id) {
  return Camsizer(cells, header, source).read(id);
}

} // namespace mdm
