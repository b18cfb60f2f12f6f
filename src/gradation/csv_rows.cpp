#include "gradation/csv_rows.hpp"

#include "gradation/phi.hpp"
#include "gradation/sieve_name.hpp"
#include "text/lines.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace mdm {
namespace {

constexpr std::array<SizeColumn, 6> size_columns = {{{"size_mm", SizeKind::mm},
                                                     {"size_um", SizeKind::um},
                                                     {"size_m", SizeKind::m},
                                                     {"size_in", SizeKind::inch},
                                                     {"size_phi", SizeKind::phi},
                                                     {"sieve", SizeKind::sieve}}};

std::string size_column_names() {
  std::string text;
  for (const SizeColumn &column : size_columns)
    text += (text.empty() ? "" : ", ") + std::string(column.name);
  return text;
}

/// Further mistakes that a header with an unknown first column may have.
std::string header_hint(std::string_view first, std::string_view example) {
  if (first.find('\t') != std::string_view::npos)
    return " (put commas, not tabs, between the fields)";
  if (!first.empty() && (is_digit(first[0]) || first[0] == '.'))
    return fmt::format(" (the first line must name the columns, such as '{}')", example);
  if (first.starts_with("mdm-certificate"))
    return " (this is a proof: give the gradation first, then the proof)";
  if (first.starts_with("mdm-packing"))
    return " (this is a packing: give the gradation)";
  if (first.starts_with('[') || first.starts_with('{'))
    return " (a JSON file holds one object; mdm batch reads many, one a line)";
  if (first == "material")
    return " (write size_mm,mass,material: the material stands behind)";
  std::string small(first);
  std::transform(small.begin(), small.end(), small.begin(), lower);
  if (small != first && find_size_column(small) != nullptr)
    return " (in small letters)";
  return {};
}

std::string counted(std::size_t fields) {
  return std::to_string(fields) + (fields == 1 ? " field" : " fields");
}

/// Among the names of sieves only metric openings are numbers, and only their units end so.
bool is_metric(std::string_view sieve) {
  return sieve.ends_with('m') || sieve.ends_with('M');
}

} // namespace

const SizeColumn *find_size_column(std::string_view name) {
  const auto found = std::find_if(size_columns.begin(), size_columns.end(),
                                  [name](const SizeColumn &c) { return c.name == name; });
  return found == size_columns.end() ? nullptr : &*found;
}

std::string unknown_size_column(std::string_view name, std::string_view example) {
  return fmt::format("first column {} is unknown: use one of {}{}", in_quotes(name), size_column_names(),
                     header_hint(name, example));
}

void check_comment(std::string_view line, bool below_sieves) {
  const std::string_view behind = below_sieves ? trimmed(line.substr(1)) : line.substr(1);
  if (!behind.empty() && is_digit(behind[0]))
    throw InputError(fmt::format("{} may be a sieve or a comment: {}", in_quotes(line),
                                 below_sieves ? "write No. 4 for a sieve, begin a comment with a word"
                                              : "write '# ' before a comment, No. 4 for a sieve"));
}

void CsvRows::read_header(std::string_view example) {
  if (!next_line())
    source_.refuse(std::max(lines_.number(), std::size_t{1}),
                   fmt::format("there is no header: begin with a line such as '{}'", example));
  const std::string_view line = trimmed(lines_.text());
  delimiter_ = line.find(';') == std::string_view::npos ? ',' : ';';
  split(line);
  width_ = fields_.size();
  size_column_ = find_size_column(fields_[0]);
  if (size_column_ == nullptr)
    refuse(unknown_size_column(fields_[0], example));
}

bool CsvRows::next() {
  if (!next_line())
    return false;
  split(trimmed(lines_.text()));
  if (fields_.size() != width_)
    refuse(fmt::format("the row has {}, the header has {}: {}", counted(fields_.size()), counted(width_),
                       delimiter_ == ',' && fields_.size() > width_
                           ? "with decimal commas, put ; between fields"
                           : "give each column its value"));
  return true;
}

bool CsvRows::next_line() {
  const bool below_sieves = size_column_ != nullptr && size_column_->kind == SizeKind::sieve;
  while (lines_.next()) {
    const std::string_view line = trimmed(lines_.text());
    if (!line.starts_with('#')) {
      if (!line.empty())
        return true;
      continue;
    }
    try {
      check_comment(line, below_sieves);
    } catch (const InputError &e) {
      refuse(e.what());
    }
  }
  return false;
}

void CsvRows::split(std::string_view line) {
  if (!split_fields(line, delimiter_, fields_))
    refuse("a quoted field does not end with a quote before the next delimiter: close it");
}

Rational CsvRows::size() {
  return named(size_column_->name, &CsvRows::parse_size, 0);
}

std::optional<Rational> CsvRows::phi() {
  assert(is_phi());
  if (is_pan(fields_[0]))
    return std::nullopt;
  return named(size_column_->name, &CsvRows::parse_phi, 0);
}

Rational CsvRows::parse_phi(std::string_view field) {
  const Rational phi = decimal(field);
  check_phi(phi);
  return phi;
}

Rational CsvRows::number(std::string_view column, std::size_t field) {
  return named(column, &CsvRows::decimal, field);
}

Rational CsvRows::last_digit(std::size_t field) {
  return last_digit_unit(fields_[field], decimal_sign(fields_[field]));
}

/// Reads a field; what is wrong with it is said with the line and the column's name.
Rational CsvRows::named(std::string_view column, Rational (CsvRows::*parse)(std::string_view),
                        std::size_t field) {
  try {
    return (this->*parse)(fields_[field]);
  } catch (const InputError &error) {
    refuse(fmt::format("{} {}", column, error.what()));
  }
}

Rational CsvRows::parse_size(std::string_view field) {
  if (is_pan(field))
    return 0;
  if (size_column_->kind == SizeKind::sieve)
    return sieve_opening(field, is_metric(field) ? decimal_sign(field) : '.');
  const Rational number = decimal(field);
  switch (size_column_->kind) {
  case SizeKind::inch:
    return number * in_mm(SizeUnit::in);
  case SizeKind::phi:
    if (denominator(number) != 1)
      rounded_phi_.add(field);
    return phi_size(number);
  default:
    return number;
  }
}

Rational CsvRows::decimal(std::string_view field) {
  return parse_decimal(field, decimal_sign(field));
}

/// The decimal sign of a number; all numbers of a file must agree.
char CsvRows::decimal_sign(std::string_view number) {
  if (delimiter_ == ',')
    return '.';
  const std::size_t at = number.find_first_of(",.");
  if (at == std::string_view::npos)
    return '.';
  if (sign_ == '\0')
    sign_ = number[at];
  if (sign_ != number[at])
    throw InputError(fmt::format("{} has a decimal '{}', numbers above have '{}': use one of them throughout",
                                 in_quotes(number), number[at], sign_));
  return sign_;
}

std::string CsvRows::file_unit() const {
  return size_column_->kind == SizeKind::inch ? "inches" : size_column_->kind == SizeKind::phi ? "phi" : "";
}

SizeUnit CsvRows::unit() const {
  switch (size_column_->kind) {
  case SizeKind::um:
    return SizeUnit::um;
  case SizeKind::m:
    return SizeUnit::m;
  default:
    return SizeUnit::mm;
  }
}

std::vector<std::string> CsvRows::notes() const {
  std::vector<std::string> notes;
  if (size_column_->kind == SizeKind::inch)
    notes.emplace_back("Sizes in inches were converted to mm.");
  if (!rounded_phi_.empty())
    notes.push_back(
        fmt::format("Sizes of phi that is no integer were rounded to 15 significant digits in mm: phi {}.",
                    rounded_phi_.text()));
  return notes;
}

} // namespace mdm
