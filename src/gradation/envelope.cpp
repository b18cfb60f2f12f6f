#include "gradation/csv_reader.hpp"
#include "gradation/csv_rows.hpp"
#include "gradation/limit_columns.hpp"
#include "gradation/phi.hpp"
#include "gradation/shown.hpp"
#include "gradation/workbook.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/envelope.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr std::string_view min_column = "passing_min_percent";
constexpr std::string_view max_column = "passing_max_percent";

struct LimitsRow {
  Rational size, least, most;
  std::size_t line;
};

/// \throws InputError if the size is irrational
Rational read_size(CsvRows &rows) {
  const std::optional<Rational> phi = rows.is_phi() ? rows.phi() : std::nullopt;
  if (phi && denominator(*phi) != 1)
    rows.refuse(
        fmt::format("size_phi {} is no whole number, and a band needs sizes that are decimals: give them in "
                    "mm, here {} rounded to 15 digits (of a gradation {})",
                    in_quotes(rows.fields()[0]), shown(phi_size(*phi)), convert_remedy));
  return rows.size();
}

LimitsRow read_row(CsvRows &rows) {
  LimitsRow row{read_size(rows), rows.number(min_column, 1), rows.number(max_column, 2), rows.line()};
  if (row.size < 0)
    rows.refuse(fmt::format("size {} is negative: give the opening of the sieve", shown(row.size)));
  if (row.least < 0)
    rows.refuse(
        fmt::format("{} {} is negative: write 0 where nothing needs to pass", min_column, shown(row.least)));
  if (row.least > 100)
    rows.refuse(
        fmt::format("{} {} is above 100: write 100 where all must pass", min_column, shown(row.least)));
  if (row.size == 0 && row.least > 0)
    rows.refuse(
        fmt::format("{} {} at size 0: nothing passes the pan, so write 0", min_column, shown(row.least)));
  if (row.most < 0)
    rows.refuse(
        fmt::format("{} {} is negative: write 0 where nothing may pass", max_column, shown(row.most)));
  if (row.most > 100)
    rows.refuse(fmt::format("{} {} is above 100: write 100 where all may pass", max_column, shown(row.most)));
  return row;
}

void check_different(const LimitsRow &finer, const LimitsRow &coarser, const Source &source) {
  if (finer.size == coarser.size)
    source.refuse(coarser.line, fmt::format("size {} repeats that of line {}: leave one out",
                                            shown(coarser.size), finer.line));
}

} // namespace

bool is_canonical_envelope(std::string_view content) {
  return !is_workbook(content) && is_canonical_csv(without_byte_order_mark(content)) &&
         (content.find(min_column) != std::string_view::npos ||
          content.find(max_column) != std::string_view::npos);
}

std::optional<std::string> contradiction(const Envelope &e) {
  std::size_t demanding = 0; // the sieve up to i that most must pass
  for (std::size_t i = 0; i < e.sizes.size(); ++i) {
    if (e.passing_min[i] > e.passing_min[demanding])
      demanding = i;
    if (e.passing_min[demanding] > e.passing_max[i])
      return fmt::format("at least {} percent must pass {} {}, but at most {} may pass {} {}",
                         shown(e.passing_min[demanding]), shown(e.sizes[demanding]), name(e.unit),
                         shown(e.passing_max[i]), shown(e.sizes[i]), name(e.unit));
  }
  return std::nullopt;
}

Envelope read_envelope(std::string_view content, const std::string &file) {
  const Source source(file);
  source.check_length(content, max_gradation_bytes);
  if (!is_canonical_envelope(content))
    if (std::optional<Envelope> e = envelope_in_table(content, file))
      return *std::move(e);
  const std::string_view text = without_byte_order_mark(content);
  source.check_text(text, max_gradation_bytes);
  CsvRows csv(text, source);
  csv.read_header("size_mm,passing_min_percent,passing_max_percent");
  if (csv.fields().size() != 3 || csv.fields()[1] != min_column || csv.fields()[2] != max_column)
    csv.refuse(fmt::format("a band has the columns {} and {} after that of the sizes, and no other",
                           min_column, max_column));
  const std::size_t header_line = csv.line();
  std::vector<LimitsRow> rows;
  while (csv.next()) {
    if (rows.size() == max_gradation_rows)
      csv.refuse(fmt::format("there are more than {} rows: give fewer sieves", max_gradation_rows));
    rows.push_back(read_row(csv));
  }
  if (rows.empty())
    source.refuse(header_line, "there is no row below the header: give the bounds at one sieve or more");
  std::stable_sort(rows.begin(), rows.end(),
                   [](const LimitsRow &a, const LimitsRow &b) { return a.size < b.size; });
  for (std::size_t i = 1; i < rows.size(); ++i)
    check_different(rows[i - 1], rows[i], source);
  Envelope e;
  e.id = stem(file);
  e.unit = csv.unit();
  e.notes = csv.notes();
  for (const LimitsRow &row : rows) {
    e.sizes.push_back(row.size);
    e.passing_min.push_back(row.least);
    e.passing_max.push_back(row.most);
  }
  return e;
}

} // namespace mdm
