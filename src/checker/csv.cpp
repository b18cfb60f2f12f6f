#include "gradation.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace mdm_check {
namespace {

constexpr std::string_view size_columns[] = {"size_mm", "size_um", "size_m", "size_in", "size_phi", "sieve"};
constexpr std::string_view mass_columns[] = {"mass",
                                             "retained_g",
                                             "retained_percent",
                                             "retained_fraction",
                                             "cumulative_retained_percent",
                                             "passing_percent",
                                             "passing_fraction"};

constexpr std::string_view optional_columns[] = {"tolerance_percent", "factor"};

using Fields = std::vector<std::string>;

struct Row {
  mpq_class size, value, factor;
  std::size_t line;
};

struct Table {
  Fields header;
  std::vector<Row> rows;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == std::string_view::npos ? std::string_view()
                                         : text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// The fields of a line; none if a quote is not closed or something follows it.
std::optional<Fields> split(std::string_view line, char delimiter) {
  Fields fields;
  while (true) {
    std::size_t end = line.find(delimiter);
    const std::string_view start = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    if (start.starts_with('"')) {
      std::string field;
      std::size_t at = 1;
      for (; at < start.size() && (start[at] != '"' || start.substr(at, 2) == "\"\""); ++at) {
        field += start[at];
        if (start[at] == '"')
          ++at;
      }
      if (at >= start.size())
        return std::nullopt;
      const std::string_view after = start.substr(at + 1);
      end = after.find(delimiter);
      if (!trimmed(after.substr(0, end)).empty())
        return std::nullopt;
      fields.push_back(field);
      line = after;
    } else {
      fields.emplace_back(trimmed(line.substr(0, end)));
    }
    if (end == std::string_view::npos)
      return fields;
    line.remove_prefix(end + 1);
  }
}

/// `#200`, `# 3-1/2`: what begins a row of a table of sieves, where any other # begins a comment.
bool is_sieve_number(std::string_view field) {
  if (!field.starts_with('#'))
    return false;
  field.remove_prefix(std::min(field.find_first_not_of(' ', 1), field.size()));
  return field.find_first_not_of("0123456789-/. ") == std::string_view::npos &&
         std::any_of(field.begin(), field.end(), is_digit);
}

/// Reads the decimals of one file, which may have a decimal comma where the delimiter is a semicolon.
class Numbers {
public:
  explicit Numbers(char delimiter) : comma_allowed_(delimiter == ';') {}

  /// The point that this text is written with.
  char point(std::string_view text, std::size_t line) {
    const bool comma = comma_allowed_ && text.find(',') != std::string_view::npos;
    (comma ? comma_seen_ : point_seen_) |= text.find_first_of(",.") != std::string_view::npos;
    if (comma_seen_ && point_seen_)
      throw Malformed(line, "decimal commas and decimal points in one file: write all numbers with the same");
    return comma ? ',' : '.';
  }

  mpq_class read(std::string_view text, std::size_t line) {
    return read_decimal(text, point(text, line), line);
  }

private:
  bool comma_allowed_;
  bool comma_seen_ = false, point_seen_ = false;
};

mpq_class read_size(const std::string &field, std::string_view column, Numbers &numbers, std::size_t line) {
  std::string lower = field;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (lower == "pan")
    return 0;
  if (column == "sieve") {
    // Only a length in mm, um or m is a number; the other names have texts of the tables.
    const bool length = trimmed(lower).ends_with('m');
    const mpq_class size = sieve_opening(field, length ? numbers.point(field, line) : '.', line);
    if (size < 0)
      throw Malformed(line, "a negative size: give the opening of the sieve");
    return size;
  }
  const mpq_class value = numbers.read(field, line);
  if (column == "size_phi")
    return phi_opening(value, line);
  if (value < 0)
    throw Malformed(line, "a negative size: give the opening of the sieve");
  return column == "size_in" ? mpq_class(value * mpq_class(127, 5)) : value;
}

template <std::size_t n>
void demand_name(const Fields &header, std::size_t column, const std::string_view (&names)[n],
                 std::size_t line) {
  if (column < header.size() && std::count(names, names + n, header[column]) > 0)
    return;
  const bool ags4 = header[0] == "GROUP";
  throw Malformed(line, (column < header.size() ? quoted(header[column]) : "nothing") +
                            " as the name of column " + std::to_string(column + 1) +
                            (ags4 ? ": of an AGS4 file, give the CSV that mdm solve --proof wrote"
                                  : ": begin with a header such as size_mm,mass"));
}

void demand_header(const Fields &header, std::size_t line) {
  demand_name(header, 0, size_columns, line);
  demand_name(header, 1, mass_columns, line);
  for (std::size_t column = 2; column < header.size(); ++column) {
    demand_name(header, column, optional_columns, line);
    if (std::count(header.begin(), header.end(), header[column]) > 1)
      throw Malformed(line, "column " + quoted(header[column]) + " is there twice: drop one");
  }
}

Row read_row(const Fields &fields, const Fields &header, Numbers &numbers, std::size_t line) {
  if (fields.size() != header.size())
    throw Malformed(line, "the row has not as many fields as the header, " + std::to_string(fields.size()) +
                              " for " + std::to_string(header.size()) +
                              ": complete it or quote the delimiter");
  Row row{read_size(fields[0], header[0], numbers, line), numbers.read(fields[1], line), 1, line};
  if (row.value < 0)
    throw Malformed(line, quoted(fields[1]) + " is negative: no sieve retains less than nothing");
  for (std::size_t column = 2; column < fields.size(); ++column) {
    const mpq_class value = numbers.read(fields[column], line);
    const bool factor = header[column] == "factor";
    if (value < 0 || (factor && value == 0))
      throw Malformed(line, quoted(fields[column]) + " as " + header[column] +
                                " is too small: " + (factor ? "give a positive factor" : "give 0 or more"));
    if (factor)
      row.factor = value;
  }
  return row;
}

/// The lines of the file as rows of numbers, in the file's order.
Table read_table(std::string_view text) {
  Table table;
  char delimiter = ',';
  Numbers numbers(delimiter);
  for (std::size_t line_number = 1; !text.empty(); ++line_number) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (end != std::string_view::npos && line.ends_with('\r'))
      line.remove_suffix(1);
    const bool comment = trimmed(line).starts_with('#');
    const bool before_header = table.header.empty();
    if (trimmed(line).empty() || (comment && (before_header || table.header[0] != "sieve")))
      continue;
    if (before_header) {
      delimiter = line.find(';') == std::string_view::npos ? ',' : ';';
      numbers = Numbers(delimiter);
    }
    const std::optional<Fields> fields = split(line, delimiter);
    if (comment && !(fields && fields->size() == table.header.size() && is_sieve_number(fields->front())))
      continue;
    if (!fields)
      throw Malformed(line_number, "a quoted field does not end before the delimiter: close its quotes");
    if (before_header) {
      demand_header(*fields, line_number);
      table.header = *fields;
      continue;
    }
    if (table.rows.size() == most_rows)
      throw Malformed(line_number, "more than 1048576 rows: give fewer sieves");
    table.rows.push_back(read_row(*fields, table.header, numbers, line_number));
  }
  if (table.rows.size() < 2)
    throw Malformed(1, "fewer than two rows below a header: give the sizes of at least two sieves");
  return table;
}

/// Turns the percentages or fractions passing P_j of the rows, ascending by size, into masses.
void passing_to_masses(Table &table, Gradation &gradation, std::vector<std::size_t> &lines) {
  const std::string &mass_column = table.header[1];
  const bool cumulative = mass_column == "cumulative_retained_percent";
  const mpq_class full = mass_column == "passing_fraction" ? 1 : 100;
  std::vector<Row> &rows = table.rows;
  for (Row &row : rows) {
    if (row.value > full)
      throw Malformed(row.line,
                      mass_column + " is above " + full.get_str() + ": no sieve passes or retains more");
    if (cumulative)
      row.value = full - row.value;
  }
  if (rows.back().value != full)
    throw Malformed(rows.back().line,
                    "the largest sieve retains something: add the next larger sieve that retains nothing");
  const Row &finest = rows.front();
  if (finest.value > 0 && finest.size == 0)
    throw Malformed(finest.line, "something passes size 0: nothing is smaller, let nothing pass the pan");
  if (finest.value > 0) {
    if (std::count(table.header.begin(), table.header.end(), "factor") > 0)
      throw Malformed(finest.line, "something passes the finest sieve: add a row of the pan with its factor");
    gradation.openings.emplace_back(0);
    gradation.masses.push_back(finest.value);
    gradation.factors.emplace_back(1);
    lines.push_back(finest.line);
  }
  for (std::size_t j = 0; j < rows.size(); ++j) {
    if (j + 1 < rows.size() && rows[j].value > rows[j + 1].value)
      throw Malformed(rows[j].line,
                      "more passes than the next larger sieve lets through: correct one of the two rows");
    gradation.masses.push_back(j + 1 < rows.size() ? mpq_class(rows[j + 1].value - rows[j].value)
                                                   : mpq_class(0));
  }
}

} // namespace

Gradation read_csv(std::string_view text) {
  Table table = read_table(text);
  std::stable_sort(table.rows.begin(), table.rows.end(),
                   [](const Row &x, const Row &y) { return x.size < y.size; });
  const std::string &mass_column = table.header[1];
  Gradation gradation;
  std::vector<std::size_t> lines;
  if (mass_column == "mass" || mass_column.starts_with("retained_"))
    for (const Row &row : table.rows)
      gradation.masses.push_back(row.value);
  else
    passing_to_masses(table, gradation, lines);
  for (const Row &row : table.rows) {
    gradation.openings.push_back(row.size);
    gradation.factors.push_back(row.factor);
    lines.push_back(row.line);
  }
  demand_complete(gradation, lines);
  return gradation;
}

} // namespace mdm_check
