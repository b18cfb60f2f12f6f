#include "gradation/mastersizer_reader.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/number_shares.hpp"
#include "gradation/plain_words.hpp"
#include "gradation/sample_choice.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr std::string_view result_between = "result between", result_under = "result under",
                           result_below = "result below";

/// The column where a block of results begins; the end of the row if there is none.
std::size_t block(const CellRow &headers, std::string_view words) {
  const auto found = std::find_if(headers.cells.begin(), headers.cells.end(), [words](const std::string &c) {
    return plain_words(c).starts_with(words);
  });
  return static_cast<std::size_t>(found - headers.cells.begin());
}

class Mastersizer {
public:
  Mastersizer(const Cells &cells, const Source &source, const Reading &reading)
      : cells_(cells), source_(source), reading_(reading), sign_(cells.delimiter == ';') {}

  Table read(const std::string &id) {
    find_block();
    const std::vector<SampleNames> samples = find_samples();
    const std::size_t chosen = chosen_sample(samples, reading_.specimen, source_);
    sample_ = &cells_.rows[2 + chosen];
    table_.header_line = sample_->line;
    table_.id = samples[chosen].names.front().empty() ? id : samples[chosen].names.front();
    for (const SampleNames &sample : samples)
      table_.samples.push_back(sample.names.front());
    refuse_number_shares();
    find_sign();
    read_channels();
    check_whole();
    describe(samples.size());
    return std::move(table_);
  }

private:
  void find_block() {
    const CellRow &headers = cells_.rows[0];
    begin_ = block(headers, result_between);
    is_between_ = begin_ < headers.cells.size();
    if (!is_between_)
      begin_ = std::min(block(headers, result_under), block(headers, result_below));
    const std::string &header = headers.cells[begin_];
    const std::string words = plain_words(header);
    const std::string last = words.substr(words.rfind(' ') + 1);
    const ColumnUnit unit = unit_of_words(reading_.unit ? *reading_.unit : last);
    if (unit != ColumnUnit::um && unit != ColumnUnit::mm)
      source_.refuse(headers.line,
                     fmt::format("{} does not name the unit of the sizes: say it with {} um or mm",
                                 in_quotes(header), option("unit")));
    table_.unit = *length_of(unit);
    end_ = begin_ + 1;
    const auto goes_on = [&](std::size_t column) {
      const std::string_view name = headers.cell(column);
      return number_cell(cells_.rows[1].cell(column)) && (name.empty() || name == header);
    };
    while (goes_on(end_))
      ++end_;
  }

  std::vector<SampleNames> find_samples() const {
    const CellRow &headers = cells_.rows[0];
    const auto name = std::find_if(headers.cells.begin(), headers.cells.end(),
                                   [](const std::string &c) { return plain_words(c) == "sample name"; });
    const auto column = static_cast<std::size_t>(name - headers.cells.begin());
    std::vector<SampleNames> samples;
    for (std::size_t row = 2; row < cells_.rows.size(); ++row)
      samples.push_back({{std::string(cells_.rows[row].cell(column)), std::to_string(cells_.rows[row].line)},
                         cells_.rows[row].line});
    if (samples.empty())
      source_.refuse(cells_.rows[1].line, "there is no row of a sample below the sizes: export one");
    return samples;
  }

  void refuse_number_shares() const {
    const CellRow &headers = cells_.rows[0];
    for (std::size_t column = 0; column < begin_; ++column) {
      const std::string_view cell = sample_->cell(column);
      if (speaks_of_number_shares(headers.cells[column] + " " + std::string(cell)) ||
          states_other_shares(headers.cells[column], cell))
        source_.refuse(sample_->line, fmt::format("{} is {} here: {}", in_quotes(headers.cells[column]),
                                                  in_quotes(cell), number_shares_remedy));
    }
  }

  void find_sign() {
    DecimalSign sign(sign_, true);
    for (std::size_t column = begin_; column < end_; ++column)
      for (const CellRow *row : {&cells_.rows[1], sample_})
        if (const std::optional<NumberCell> number = number_cell(row->cell(column)))
          sign.see(number->digits);
    try {
      point_ = sign.sign();
    } catch (const InputError &error) {
      source_.refuse(sample_->line, error.what());
    }
  }

  /// A number of a row; the last channel between sizes may be empty.
  Rational number(const CellRow &row, std::size_t column, bool may_be_empty) const {
    if (may_be_empty && row.cell(column).empty())
      return 0;
    const std::optional<NumberCell> cell = number_cell(row.cell(column));
    if (!cell)
      source_.refuse(row.line, fmt::format("{} in column {} is no number: export the results again",
                                           in_quotes(row.cell(column)), column + 1));
    try {
      return parse_decimal(cell->digits, point_);
    } catch (const InputError &error) {
      source_.refuse(row.line, error.what());
    }
  }

  void read_channels() {
    for (std::size_t column = begin_; column < end_; ++column) {
      table_.lines.push_back(sample_->line);
      table_.sizes.push_back(number(cells_.rows[1], column, false));
      table_.values.push_back(number(*sample_, column, is_between_ && column + 1 == end_));
      if (!is_between_)
        table_.roundings.push_back(last_digit_unit(number_cell(sample_->cell(column))->digits, point_) / 2);
    }
  }

  /// Shares between the user's sizes are of all that was measured.
  void check_whole() const {
    if (!is_between_)
      return;
    Rational sum = 0, error = 0;
    for (std::size_t i = 0; i < table_.values.size(); ++i) {
      sum += table_.values[i];
      if (const std::optional<NumberCell> cell = number_cell(sample_->cell(begin_ + i)))
        error += last_digit_unit(cell->digits, point_) / 2;
    }
    if (abs(Rational(100 - sum)) > error)
      source_.refuse(sample_->line,
                     fmt::format("the shares add up to {}, not to 100: the rest is outside of these sizes: "
                                 "export sizes that hold all of it",
                                 approximate(sum, 6)));
  }

  void describe(std::size_t samples) {
    table_.column = find_mass_column(is_between_ ? "retained_percent" : "passing_percent");
    table_.format = "Mastersizer export, " + cells_.format;
    table_.sizes_from = fmt::format("row 2, in {}", name(table_.unit));
    table_.masses_from = fmt::format("the row of the sample, {}: {} by volume",
                                     in_quotes(cells_.rows[0].cells[begin_]), table_.column->words);
    table_.is_canonical = false;
    table_.notes.push_back(
        fmt::format("Sample {} of {}; shares are by volume.", in_quotes(table_.id), samples));
  }

  const Cells &cells_;
  const Source &source_;
  const Reading &reading_;
  bool sign_;
  char point_ = '.';
  bool is_between_ = false;
  std::size_t begin_ = 0, end_ = 0; ///< columns of the channels
  const CellRow *sample_ = nullptr;
  Table table_;
};

} // namespace

bool is_mastersizer(const Cells &cells) {
  if (cells.rows.size() < 2)
    return false;
  const CellRow &headers = cells.rows[0];
  for (const std::string_view words : {result_between, result_under, result_below}) {
    const std::size_t column = block(headers, words);
    if (column < headers.cells.size() && number_cell(cells.rows[1].cell(column)))
      return true;
  }
  return false;
}

Table read_mastersizer(const Cells &cells, const Source &source, const std::string &id,
                       const Reading &reading) {
  return Mastersizer(cells, source, reading).read(id);
}

} // namespace mdm
