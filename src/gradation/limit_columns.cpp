#include "gradation/limit_columns.hpp"

#include "gradation/header_words.hpp"
#include "gradation/lab_table.hpp"
#include "gradation/plain_words.hpp"
#include "gradation/shown.hpp"
#include "gradation/table_file.hpp"
#include "gradation/text_encoding.hpp"
#include "gradation/workbook.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

namespace mdm {
namespace {

constexpr std::string_view lower_words =
    "lower low min minimum minimal untere unterer inferieur inferieure minimo minima inferiore";
constexpr std::string_view upper_words = "upper high max maximum maximal obere oberer superieur superieure "
                                         "maximo maxima superiore massimo massima";
constexpr std::string_view other_words =
    "limit limits bound boundary grenze grenzwert grenzlinie limite limites band envelope spec specification "
    "specified "
    "required grading curve passing finer durchgang siebdurchgang passant tamisat pasa que passante of the";
/// Those of limits that are no limits of the percent that passes.
constexpr std::string_view retained_words = "retained coarser oversize rueckstand siebrueckstand "
                                            "rueckstaende retenu retenue retenus refus refuse retenido "
                                            "retenida retenidos trattenuto trattenuta trattenuti";

/// The columns of sizes and limits, and the row of their headers.
struct LimitColumns {
  std::size_t size, lower, upper, row;
};

enum class Limit { none, lower, upper };

/// How many of the words are in a list.
std::ptrdiff_t count(const std::vector<std::string> &words, std::string_view list) {
  return std::count_if(words.begin(), words.end(),
                       [list](const std::string &word) { return has_word(list, word); });
}

/// What a header says that has one word of a limit, whatever its others are.
Limit any_limit_of(std::string_view header) {
  const std::vector<std::string> words = words_in(header, ColumnUnit::percent);
  const std::ptrdiff_t lower = count(words, lower_words), upper = count(words, upper_words);
  return lower + upper != 1 ? Limit::none : lower == 1 ? Limit::lower : Limit::upper;
}

/// What a header says, if all its words are of limits in percent.
Limit limit_of(std::string_view header) {
  const std::vector<std::string> words = words_in(header, ColumnUnit::percent);
  const bool has_others = count(words, other_words) + 1 != static_cast<std::ptrdiff_t>(words.size());
  return has_others ? Limit::none : any_limit_of(header);
}

bool says_retained(std::string_view text) {
  return count(words_in(text, ColumnUnit::percent), retained_words) > 0;
}

/// Refuses limits of what is retained, which a word of a line says.
void check_passing(const Cells &cells, const LimitColumns &columns, const Source &source) {
  for (std::size_t row = 0; row <= columns.row; ++row)
    for (const std::string &cell : cells.rows[row].cells)
      if (says_retained(cell))
        source.refuse(
            cells.rows[row].line,
            fmt::format("{} is about what is retained, and limits are of the percent that passes: make "
                        "these of them (100 less what all coarser sieves and this one retain), or take "
                        "the words out",
                        in_quotes(cell)));
}

/// Refuses limits of several specifications in a row of headers.
void check_one_pair(const Cells &cells, std::size_t row, const Source &source) {
  std::vector<std::string> lower, upper;
  for (const std::string &header : cells.rows[row].cells)
    if (const Limit limit = any_limit_of(header); limit != Limit::none)
      (limit == Limit::lower ? lower : upper).push_back(in_quotes(header));
  if (lower.size() > 1 && lower.size() == upper.size())
    source.refuse(
        cells.rows[row].line,
        fmt::format("there are {} pairs of limits, as {} and {}, {} and {}: give each in a file of its own",
                    lower.size(), lower[0], upper[0], lower[1], upper[1]));
}

std::optional<LimitColumns> columns_in(const Cells &cells, std::size_t row, const Source &source) {
  std::vector<std::size_t> sizes, lower, upper;
  const std::vector<std::string> &headers = cells.rows[row].cells;
  for (std::size_t i = 0; i < headers.size(); ++i) {
    const std::optional<HeaderMeaning> meaning = header_meaning(headers[i]);
    const Limit limit = says_retained(headers[i]) ? any_limit_of(headers[i]) : limit_of(headers[i]);
    if (limit != Limit::none)
      (limit == Limit::lower ? lower : upper).push_back(i);
    else if (meaning && (meaning->meaning == ColumnMeaning::size || meaning->meaning == ColumnMeaning::sieve))
      sizes.push_back(i);
  }
  if (sizes.size() == 1)
    check_one_pair(cells, row, source);
  if (sizes.size() != 1 || lower.size() != 1 || upper.size() != 1)
    return std::nullopt;
  return LimitColumns{sizes[0], lower[0], upper[0], row};
}

std::optional<LimitColumns> columns_in(const Cells &cells, const Source &source) {
  for (std::size_t row = 0; row < cells.rows.size(); ++row)
    if (const std::optional<LimitColumns> columns = columns_in(cells, row, source)) {
      check_passing(cells, *columns, source);
      return columns;
    }
  return std::nullopt;
}

/// The rows of the sizes and one column of limits, by size. \pre the header is the first row
Table limits_in(const Cells &cells, const LimitColumns &columns, std::size_t column, const Source &source) {
  Reading reading;
  reading.columns = fmt::format("{},{}", columns.size + 1, column + 1);
  reading.kind = "passing_percent";
  Table table = read_lab_table(cells, source, "", reading);
  std::vector<std::size_t> order(table.sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&table](std::size_t i, std::size_t j) { return table.sizes[i] < table.sizes[j]; });
  Table sorted = table;
  for (std::size_t i = 0; i < order.size(); ++i) {
    sorted.sizes[i] = table.sizes[order[i]];
    sorted.values[i] = table.values[order[i]];
    sorted.lines[i] = table.lines[order[i]];
  }
  return sorted;
}

/// Refuses what is no percent passing of ascending sizes.
void check(const Table &limits, const Source &source) {
  for (std::size_t i = 0; i < limits.sizes.size(); ++i) {
    const auto refuse = [&](const std::string &what) { source.refuse(limits.lines[i], what); };
    const Rational &value = limits.values[i];
    if (limits.sizes[i] < 0)
      refuse(fmt::format("size {} is negative: give the opening of the sieve", shown(limits.sizes[i])));
    if (value < 0 || value > 100)
      refuse(fmt::format("the limit {} is no percent from 0 to 100: correct it", shown(value)));
    if (limits.sizes[i] == 0 && value > 0)
      refuse(
          fmt::format("the limit {} at size 0: nothing passes the pan, so leave the row out", shown(value)));
    if (i > 0 && limits.sizes[i] == limits.sizes[i - 1])
      refuse(fmt::format("size {} repeats that of line {}: leave one out", shown(limits.sizes[i]),
                         limits.lines[i - 1]));
    if (i > 0 && value < limits.values[i - 1])
      refuse(fmt::format(
          "the limit {} is below {} of the next finer sieve: limits of the percent that passes do not "
          "fall with size; of other limits make these",
          shown(value), shown(limits.values[i - 1])));
  }
}

std::optional<Envelope> envelope_of(Cells cells, const Source &source, const std::string &file) {
  const std::optional<LimitColumns> columns = columns_in(cells, source);
  if (!columns)
    return std::nullopt;
  const auto header = cells.rows.begin() + static_cast<std::ptrdiff_t>(columns->row);
  const std::string lower_name(header->cell(columns->lower)), upper_name(header->cell(columns->upper)),
      size_name(header->cell(columns->size));
  cells.rows.erase(cells.rows.begin(), header);
  const Table lower = limits_in(cells, *columns, columns->lower, source),
              upper = limits_in(cells, *columns, columns->upper, source);
  if (lower.sizes != upper.sizes)
    source.refuse(
        lower.header_line,
        fmt::format("the columns {} and {} do not have limits at the same sieves: write 0 or 100 where "
                    "there is no limit",
                    in_quotes(lower_name), in_quotes(upper_name)));
  check(lower, source);
  check(upper, source);
  if (*std::max_element(upper.values.begin(), upper.values.end()) <= 1)
    source.refuse(upper.header_line,
                  "no limit is above 1, so they may be fractions: give them in percent, in columns "
                  "passing_min_percent and passing_max_percent");
  Envelope envelope{
      stem(file),
      lower.unit,
      lower.sizes,
      lower.values,
      upper.values,
      {fmt::format("Read as {}: sizes from {}; the percent that passes from columns {} and {}.", lower.format,
                   lower.sizes_from, in_quotes(lower_name), in_quotes(upper_name))}};
  std::copy_if(lower.notes.begin(), lower.notes.end(), std::back_inserter(envelope.notes),
               [](const std::string &note) { return note.starts_with("Rows "); });
  return envelope;
}

} // namespace

bool is_limit(std::string_view header) {
  return limit_of(header) != Limit::none;
}

std::optional<Envelope> envelope_in_table(std::string_view content, const std::string &file) {
  const Source source(file);
  if (is_workbook(content)) {
    Cells cells = read_workbook(content, std::nullopt, source);
    const std::string sheet = cells.sheet;
    std::optional<Envelope> envelope = envelope_of(std::move(cells), source, file);
    if (envelope && !sheet.empty())
      if (std::optional<std::string> note =
              note_on_other_sheets(content, sheet, "give other limits in a file of their own", source))
        envelope->notes.push_back(*std::move(note));
    return envelope;
  }
  const std::optional<DecodedText> decoded = decoded_text(content, source);
  const std::string_view text = decoded ? std::string_view(decoded->text) : without_byte_order_mark(content);
  source.check_text(text, max_gradation_bytes);
  for (const char delimiter : {'\t', ';', ','})
    if (text.find(delimiter) != std::string_view::npos)
      if (std::optional<Envelope> e = envelope_of(cells_of_text(text, delimiter, 0, source), source, file))
        return e;
  return std::nullopt;
}

} // namespace mdm
