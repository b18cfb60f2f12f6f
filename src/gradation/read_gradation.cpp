#include "gradation/ags4_reader.hpp"
#include "gradation/coulter_reader.hpp"
#include "gradation/csv_reader.hpp"
#include "gradation/diggs_reader.hpp"
#include "gradation/json_reader.hpp"
#include "gradation/mass_digits.hpp"
#include "gradation/table_file.hpp"
#include "gradation/text_encoding.hpp"
#include "gradation/workbook.hpp"
#include "text/json_member.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace mdm {
namespace {

/// The content from its first character on that is no white space.
std::string_view without_leading_space(std::string_view content) {
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : content.substr(first);
}

/// At most one byte more than a gradation may have.
std::string content_of(const std::string &path) {
  const auto fail = [&path](int error) {
    throw InputError(printable(path) + ": cannot be read: " + std::generic_category().message(error) +
                     ": name one that can be read");
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file)
    fail(errno);
  std::string content;
  std::array<char, 1 << 16> part{};
  while (content.size() <= max_gradation_bytes) {
    const std::size_t n = std::fread(part.data(), 1, part.size(), file.get());
    content.append(part.data(), n);
    if (n < part.size())
      break;
  }
  if (std::ferror(file.get()) != 0)
    fail(errno);
  return content;
}

std::vector<Rational> decimals(const std::vector<std::string> &texts, const std::string &what) {
  std::vector<Rational> numbers;
  for (const std::string &text : texts) {
    try {
      numbers.push_back(parse_decimal(text));
    } catch (const InputError &e) {
      throw InputError(what + " " + std::to_string(numbers.size() + 1) + ": " + e.what());
    }
  }
  return numbers;
}

bool is_json(std::string_view text) {
  return without_leading_space(text).starts_with('{');
}

bool is_xml(std::string_view text) {
  return without_leading_space(text).starts_with('<');
}

/// The kinds of files by what the options of reading are for.
enum class FileKind { sheet, table, other };

/// Refuses options that such a file has no use for.
void check_reading(const Reading &reading, const Source &source, FileKind kind) {
  if (reading.describes_table() && kind == FileKind::other)
    source.refuse(1, fmt::format("{}, {}, {}, {} and {} are for tables, and this file says by itself what it "
                                 "holds: leave them out",
                                 option("columns"), option("kind"), option("unit"), option("skip"),
                                 option("loss")));
  if (reading.sheet && kind != FileKind::sheet)
    source.refuse(1, option("sheet") + " is for workbooks, and this is none: leave it out");
}

UnderstoodGradation understood_json(std::string_view text, const Source &source, const std::string &id,
                                    const Reading &reading) {
  check_one_sample(reading, source);
  check_reading(reading, source, FileKind::other);
  source.check_text(text, max_gradation_bytes);
  return {
      read_json(text, source, id, reading.round, true), "JSON", "key sizes", "key masses: mass", {}, true};
}

/// Says which program writes what is no text and no workbook.
void check_readable(std::string_view content, const Source &source) {
  if (content.starts_with("\xD0\xCF\x11\xE0"))
    source.refuse(
        1, "this is a workbook of Excel 97 to 2003 (.xls), which is not read: save it as .xlsx or CSV");
  if (content.starts_with("%PDF"))
    source.refuse(1, "this is a PDF, which is not read: write its table as CSV");
}

/// The table of a text that is neither JSON nor AGS4.
Table text_table(std::string_view text, const Source &source, const std::string &id, const Reading &reading) {
  source.check_text(text, max_gradation_bytes);
  const bool is_table = !is_xml(text) && !is_coulter(text);
  check_reading(reading, source, is_table ? FileKind::table : FileKind::other);
  if (is_xml(text))
    return read_diggs(text, source, id, reading.specimen);
  // Neither options nor a header of the wider grammar make several materials one.
  const bool is_canonical =
      is_table && (is_material_csv(text) || (!reading.describes_table() && is_canonical_csv(text)));
  if (is_canonical || !is_table)
    check_one_sample(reading, source);
  if (is_canonical)
    return read_csv(text, source, id, reading.phi);
  return is_table ? read_text_table(text, source, id, reading) : read_coulter(text, source, id);
}

/// Takes the values to the digits that were asked for, and with them what their last digits say of their
/// rounding.
void settle_values(Table &table, const Reading &reading) {
  if (table.has_settled_digits)
    return;
  const auto widen = [&](std::vector<Rational> &roundings, const Rational &scale) {
    for (std::size_t i = 0; i < roundings.size(); ++i)
      roundings[i] =
          std::max<Rational>(roundings[i], digit_unit(table.values[i], *reading.round) / 2 * scale);
  };
  if (reading.round) {
    widen(table.mass_roundings, 1);
    if (!table.roundings.empty())
      widen(table.roundings, ratio(100, table.column->full));
  }
  const std::string_view of = table.column->form == MassForm::retained ? "" : table.column->words;
  if (const std::optional<std::string> note = settle_digits(table.values, reading.round, of))
    table.notes.push_back(*note);
}

Table table_of(std::string_view content, std::string_view text, const Source &source, const std::string &id,
               const Reading &reading) {
  if (is_workbook(content)) {
    check_reading(reading, source, FileKind::sheet);
    return read_sheet_table(content, source, id, reading);
  }
  if (is_ags4(content)) {
    check_reading(reading, source, FileKind::other);
    source.check_line_ends(without_byte_order_mark(content));
    return read_ags4(without_byte_order_mark(content), source, id, reading.specimen);
  }
  check_readable(content, source);
  return text_table(text, source, id, reading);
}

/// Roundings in the order of the sizes.
std::vector<Rational> by_size(const std::vector<Rational> &roundings, const std::vector<Rational> &sizes) {
  std::vector<std::pair<Rational, Rational>> rows;
  for (std::size_t i = 0; i < roundings.size(); ++i)
    rows.emplace_back(sizes[i], roundings[i]);
  std::sort(rows.begin(), rows.end());
  std::vector<Rational> sorted;
  for (const auto &[size, rounding] : rows)
    sorted.push_back(rounding);
  return sorted;
}

/// \param content the bytes of the file, \param text the same as UTF-8
UnderstoodGradation understood_table(std::string_view content, std::string_view text, const Source &source,
                                     const std::string &id, const Reading &reading) {
  Table table = table_of(content, text, source, id, reading);
  settle_values(table, reading);
  const std::string format = table.format, sizes = table.sizes_from, masses = table.masses_from,
                    kind(table.column->name);
  const std::vector<std::string> samples = table.samples;
  const bool is_canonical = table.is_canonical;
  std::vector<Rational> roundings = by_size(table.mass_roundings, table.sizes);
  return {to_gradation(std::move(table), source),
          format,
          sizes,
          masses,
          samples,
          is_canonical,
          kind,
          std::move(roundings)};
}

} // namespace

bool is_workbook(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04");
}

bool is_ags4(std::string_view content) {
  return without_leading_space(without_byte_order_mark(content)).starts_with("\"GROUP\"");
}

UnderstoodGradation understand_gradation(std::string_view content, const std::string &file,
                                         const Reading &reading) {
  const Source source(file);
  source.check_length(content, max_gradation_bytes);
  const std::optional<DecodedText> decoded =
      is_workbook(content) || is_json(content) || is_canonical_csv(content) ? std::nullopt
                                                                            : decoded_text(content, source);
  const std::string_view text = decoded ? std::string_view(decoded->text) : without_byte_order_mark(content);
  UnderstoodGradation understood = is_json(text)
                                       ? understood_json(text, source, stem(file), reading)
                                       : understood_table(content, text, source, stem(file), reading);
  if (decoded && understood.format != "AGS4")
    understood.format += ", " + decoded->encoding;
  understood.is_canonical &= !decoded && !reading.round;
  return understood;
}

Gradation read_gradation(std::string_view content, const std::string &file, const Reading &reading) {
  return understand_gradation(content, file, reading).gradation;
}

Gradation read_gradation_file(const std::string &path, const Reading &reading) {
  return read_gradation(content_of(path), path, reading);
}

namespace {

std::vector<Reading> readings_of_sheets(std::string_view content, const Source &source,
                                        const Reading &reading) {
  std::vector<Reading> all;
  for (const std::string &name : written_sheets(content, source)) {
    all.push_back(reading);
    all.back().sheet = name;
  }
  if (all.empty())
    source.refuse(1, "nothing is written in the sheets of this workbook: give one with a gradation");
  return all;
}

std::vector<UnreadGradation> specimens_in(std::string_view content, const std::string &file,
                                          const Reading &reading) {
  const Source source(file);
  check_reading(reading, source, FileKind::other);
  source.check_length(content, max_gradation_bytes);
  const std::string_view text = without_byte_order_mark(content);
  source.check_line_ends(text);
  return ags4_specimens(text, file, stem(file));
}

} // namespace

std::vector<Reading> readings_of(std::string_view content, const std::string &file, const Reading &reading) {
  const Source source(file);
  source.check_length(content, max_gradation_bytes);
  if (is_workbook(content) && !reading.sheet)
    return readings_of_sheets(content, source, reading);
  if (!is_ags4(content) || reading.specimen)
    return {reading};
  std::vector<Reading> all;
  for (const UnreadGradation &specimen : specimens_in(content, file, reading)) {
    all.push_back(reading);
    all.back().specimen = specimen.id;
  }
  return all;
}

std::vector<UnreadGradation> gradations_in(std::string content, const std::string &file,
                                           const Reading &reading) {
  if (is_ags4(content) && !reading.specimen && !reading.round)
    return specimens_in(content, file, reading);
  const std::vector<Reading> readings = readings_of(content, file, reading);
  const auto whole = std::make_shared<const std::string>(std::move(content));
  std::vector<UnreadGradation> all;
  for (const Reading &one : readings) {
    const std::string id = one.specimen && !reading.specimen ? *one.specimen
                           : readings.size() == 1            ? stem(file)
                                                             : stem(file) + "/" + one.sheet.value_or("");
    all.push_back({id, [whole, file, one] { return read_gradation(*whole, file, one); }});
  }
  return all;
}

Gradation gradation_of(const std::vector<std::string> &sizes, const std::vector<std::string> &masses,
                       SizeUnit unit, const std::string &id) {
  return Gradation(decimals(sizes, "size"), decimals(masses, "mass"), unit, id);
}

Gradation read_json_gradation(std::string_view content, const std::string &where,
                              const std::string &fallback_id) {
  const Source source(where, false);
  std::string_view text = without_byte_order_mark(content);
  if (text.ends_with('\r')) // the line's LF was there and was taken
    text.remove_suffix(1);
  source.check_text(text, max_gradation_bytes);
  return read_json(text, source, fallback_id);
}

std::optional<std::string> json_gradation_id(std::string_view content) {
  return json_member(content, "id");
}

} // namespace mdm
