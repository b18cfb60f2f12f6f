#include "csv_reader.hpp"

#include "table.hpp"
#include "text.hpp"

#include <mdm/gradation/phi.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/sieve_name.hpp>
#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// A column of sizes, by its name in the header.
enum class SizeKind { mm, um, m, inch, phi, sieve };
struct SizeColumn {
  std::string_view name;
  SizeKind kind;
};
constexpr std::array<SizeColumn, 6> size_columns = {{{"size_mm", SizeKind::mm},
                                                     {"size_um", SizeKind::um},
                                                     {"size_m", SizeKind::m},
                                                     {"size_in", SizeKind::inch},
                                                     {"size_phi", SizeKind::phi},
                                                     {"sieve", SizeKind::sieve}}};

constexpr std::string_view tolerance_column = "tolerance_percent";
constexpr std::string_view factor_column = "factor";

/// The column of that name, or nothing.
template <typename Column, std::size_t n>
const Column *find_column(const std::array<Column, n> &columns, std::string_view name) {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [name](const Column &c) { return c.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

template <typename Column, std::size_t n>
std::string names(const std::array<Column, n> &columns) {
  std::string text;
  for (const Column &column : columns)
    text += (text.empty() ? "" : ", ") + std::string(column.name);
  return text;
}

/// True for `#200`, `# 3-1/2`: the field of a sieve where a line could be a comment.
bool is_sieve_number(std::string_view field) {
  return field.starts_with('#') &&
         field.substr(1).find_first_not_of("0123456789-/. ") == std::string_view::npos &&
         std::any_of(field.begin(), field.end(), is_digit);
}

std::string counted(std::size_t fields) {
  return std::to_string(fields) + (fields == 1 ? " field" : " fields");
}

class CsvReader {
public:
  CsvReader(std::string_view content, const Source &source, const std::string &id)
      : lines_(content), source_(source) {
    table_.id = id;
  }

  Gradation read() {
    while (lines_.next()) {
      const std::string_view line = trimmed(lines_.text());
      if (line.empty())
        continue;
      if (size_column_ == nullptr) {
        if (line.front() != '#')
          read_header(line);
      } else if (line.front() != '#' || is_sieve_row(line)) {
        read_row(line);
      }
    }
    if (size_column_ == nullptr)
      source_.refuse(std::max(lines_.number(), std::size_t{1}),
                     "there is no header: begin with a line such as 'size_mm,passing_percent'");
    add_notes();
    return to_gradation(std::move(table_), source_);
  }

private:
  [[noreturn]] void refuse(const std::string &what) const { source_.refuse(lines_.number(), what); }

  void split(std::string_view line) {
    if (!split_fields(line, delimiter_, fields_))
      refuse("a quoted field does not end with a quote before the next delimiter: close it");
  }

  void read_header(std::string_view line) {
    delimiter_ = line.find(';') == std::string_view::npos ? ',' : ';';
    split(line);
    table_.header_line = lines_.number();
    size_column_ = find_column(size_columns, fields_[0]);
    if (size_column_ == nullptr)
      refuse(fmt::format("first column {} is unknown: use one of {}{}", in_quotes(fields_[0]),
                         names(size_columns), header_hint()));
    if (fields_.size() == 3 && fields_[1] == "passing_min_percent" && fields_[2] == "passing_max_percent")
      refuse("this is a band of allowed gradations, for --band: it needs a curve, a file with one of the "
             "columns " +
             names(mass_columns));
    if (fields_.size() < 2)
      refuse("a second column is missing: use one of " + names(mass_columns));
    table_.column = find_column(mass_columns, fields_[1]);
    if (table_.column == nullptr)
      refuse(fmt::format("second column {} is unknown: use one of {}", in_quotes(fields_[1]),
                         names(mass_columns)));
    for (std::size_t i = 2; i < fields_.size(); ++i)
      read_optional_column(i);
    if (size_column_->kind == SizeKind::um)
      table_.unit = SizeUnit::um;
    if (size_column_->kind == SizeKind::m)
      table_.unit = SizeUnit::m;
  }

  /// What else may be wrong with a header whose first column is unknown.
  std::string header_hint() const {
    if (fields_[0].find('\t') != std::string::npos)
      return " (put commas, not tabs, between the fields)";
    if (!fields_[0].empty() && (is_digit(fields_[0][0]) || fields_[0][0] == '.'))
      return " (the first line must name the columns, such as 'size_mm,passing_percent')";
    if (fields_[0].starts_with('[') || fields_[0].starts_with('{'))
      return " (a JSON file holds one object; mdm batch reads many, one a line)";
    if (std::any_of(fields_[0].begin(), fields_[0].end(), [](char c) { return lower(c) != c; }))
      return " (in small letters)";
    return {};
  }

  void read_optional_column(std::size_t i) {
    std::size_t *place = fields_[i] == tolerance_column ? &tolerance_
                         : fields_[i] == factor_column  ? &factor_
                                                        : nullptr;
    if (place == nullptr)
      refuse(fmt::format("column {} is unknown: after the first two there may be {} and {}",
                         in_quotes(fields_[i]), tolerance_column, factor_column));
    if (*place != 0)
      refuse(fmt::format("column {} is there twice: leave one out", fields_[i]));
    *place = i;
    width_ = i + 1;
  }

  /// The grammar's one exception to comments: a row of a sieve such as `#200`.
  bool is_sieve_row(std::string_view line) {
    return size_column_->kind == SizeKind::sieve && split_fields(line, delimiter_, fields_) &&
           fields_.size() == width_ && is_sieve_number(fields_[0]);
  }

  void read_row(std::string_view line) {
    split(line);
    if (fields_.size() != width_)
      refuse(fmt::format("the row has {}, the header has {}: {}", counted(fields_.size()), counted(width_),
                         delimiter_ == ',' && fields_.size() > width_
                             ? "with decimal commas, put ; between fields"
                             : "give each column its value"));
    if (table_.lines.size() == max_gradation_rows)
      refuse(fmt::format("there are more than {} rows: give fewer sieves", max_gradation_rows));
    table_.lines.push_back(lines_.number());
    table_.sizes.push_back(named(size_column_->name, &CsvReader::size, 0));
    table_.values.push_back(named(table_.column->name, &CsvReader::decimal, 1));
    if (tolerance_ != 0)
      table_.tolerances.push_back(named(tolerance_column, &CsvReader::decimal, tolerance_));
    if (factor_ != 0)
      table_.factors.push_back(named(factor_column, &CsvReader::decimal, factor_));
  }

  /// Reads a field; what is wrong with it is said with the line and the column's name.
  Rational named(std::string_view column, Rational (CsvReader::*parse)(std::string_view), std::size_t field) {
    try {
      return (this->*parse)(fields_[field]);
    } catch (const InputError &error) {
      refuse(fmt::format("{} {}", column, error.what()));
    }
  }

  Rational size(std::string_view field) {
    if (is_pan(field))
      return 0;
    if (size_column_->kind == SizeKind::sieve)
      return sieve_opening(field, is_metric(field) ? decimal_sign(field) : '.');
    const Rational number = decimal(field);
    switch (size_column_->kind) {
    case SizeKind::inch:
      return number * ratio(254, 10);
    case SizeKind::phi:
      if (denominator(number) != 1)
        rounded_phi_.add(field);
      return phi_size(number);
    default:
      return number;
    }
  }

  /// Of the names of sieves, only metric openings are numbers, and only their units end so.
  static bool is_metric(std::string_view sieve) { return lower(sieve.back()) == 'm'; }

  Rational decimal(std::string_view field) { return parse_decimal(field, decimal_sign(field)); }

  /// The decimal sign of a number; all numbers of a file must agree.
  char decimal_sign(std::string_view number) {
    if (delimiter_ == ',')
      return '.';
    const std::size_t at = number.find_first_of(",.");
    if (at == std::string_view::npos)
      return '.';
    if (sign_ == '\0')
      sign_ = number[at];
    if (sign_ != number[at])
      throw InputError(
          fmt::format("{} has a decimal '{}', numbers above have '{}': use one of them throughout",
                      in_quotes(number), number[at], sign_));
    return sign_;
  }

  void add_notes() {
    if (size_column_->kind == SizeKind::inch)
      table_.notes.emplace_back("Sizes in inches were converted to mm.");
    if (!rounded_phi_.empty())
      table_.notes.push_back(
          fmt::format("Sizes of phi that is no integer were rounded to 15 significant digits in mm: phi {}.",
                      rounded_phi_.text()));
  }

  Lines lines_;
  const Source &source_;
  Table table_;
  const SizeColumn *size_column_ = nullptr; ///< null until the header is read
  char delimiter_ = ',';
  char sign_ = '\0';          ///< with the delimiter `;`: the decimal sign of the file, once there is one
  std::size_t width_ = 2;     ///< columns
  std::size_t tolerance_ = 0; ///< index of the column, 0 if there is none
  std::size_t factor_ = 0;    ///< index of the column, 0 if there is none
  std::vector<std::string> fields_;
  ShortList rounded_phi_;
};

} // namespace

Gradation read_csv(std::string_view content, const Source &source, const std::string &id) {
  return CsvReader(content, source, id).read();
}

} // namespace mdm
