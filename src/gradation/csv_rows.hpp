#pragma once
/// \file
/// The rows of a CSV file whose first column holds sizes.

#include "text/lines.hpp"
#include "text/short_list.hpp"
#include "text/source.hpp"

#include <mdm/gradation/size_unit.hpp>

namespace mdm {

/// A column of sizes, by its name in the header.
enum class SizeKind { mm, um, m, inch, phi, sieve };
struct SizeColumn {
  std::string_view name;
  SizeKind kind;
};

/// The column of that name, or null.
const SizeColumn *find_size_column(std::string_view name);

/// The mistake in the name of a first column that is no size column; `example` is a header.
std::string unknown_size_column(std::string_view name, std::string_view example);

/// Refuses a comment that may be a sieve, with what to write: `#200,4` anywhere, `# 200,4` below sieves.
/// Throws InputError.
void check_comment(std::string_view line, bool below_sieves);

/// A pass over a CSV file, first its header, then its rows; the grammar is in proofs/certificate-format.md,
/// section 4. Empty lines and comments are skipped. All throw InputError with the line.
class CsvRows {
public:
  /// \param content text that Source::check_text has passed, without byte order mark
  CsvRows(std::string_view content, const Source &source) : lines_(content), source_(source) {}

  /// Reads the header, with a column of sizes first; fields() are then its names. `example` is one, for the
  /// message where there is none.
  void read_header(std::string_view example);
  /// Moves on to the next row, which must have as many fields as the header has; false at the end.
  bool next();

  const std::vector<std::string> &fields() const { return fields_; }
  /// The number of the line of the header or row.
  std::size_t line() const { return lines_.number(); }
  [[noreturn]] void refuse(const std::string &what) const { source_.refuse(lines_.number(), what); }

  /// The size in the row's first field, in unit(); phi that is no whole number is rounded, which notes()
  /// says.
  Rational size();
  /// The name of the column of sizes.
  std::string_view size_name() const { return size_column_->name; }
  bool is_phi() const { return size_column_->kind == SizeKind::phi; }
  /// The phi in the row's first field, |phi| <= 1000; nothing for the pan. \pre is_phi()
  std::optional<Rational> phi();
  /// The number in another field; the name of its column is for the message.
  Rational number(std::string_view column, std::size_t field);
  /// One unit of the last digit of a number.
  Rational last_digit(std::size_t field);

  SizeUnit unit() const;
  /// As in Gradation::Data.
  std::string file_unit() const;
  /// The assumptions made about sizes.
  std::vector<std::string> notes() const;

private:
  void split(std::string_view line);
  /// Moves on to the next line that is neither empty nor a comment; false at the end.
  bool next_line();
  Rational named(std::string_view column, Rational (CsvRows::*parse)(std::string_view), std::size_t field);
  Rational parse_size(std::string_view field);
  Rational parse_phi(std::string_view field);
  Rational decimal(std::string_view field);
  char decimal_sign(std::string_view number);

  Lines lines_;
  const Source &source_;
  const SizeColumn *size_column_ = nullptr; ///< null until the header is read
  char delimiter_ = ',';
  char sign_ = '\0';      ///< with the delimiter `;`: the decimal sign of the file, once there is one
  std::size_t width_ = 0; ///< columns
  std::vector<std::string> fields_;
  ShortList rounded_phi_;
};

} // namespace mdm
