#include "gradation.hpp"

#include "text.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace mdm_check {
namespace {

/// A row of a CSV file or an element of the arrays of a JSON file. The value is what the second column says;
/// the place in the file is for messages.
struct Row {
  mpq_class size = 0, value = 0, factor = 1, tolerance = 0;
  std::string_view place;
};

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char &c : out)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

// The tables of section 5: opening in mm, and name.
constexpr std::string_view astm_inches =
    "125 5 | 106 4.24 | 100 4 | 90 3-1/2 | 75 3 | 63 2-1/2 | 53 2.12 | 50 2 | 45 1-3/4 | 37.5 1-1/2 | "
    "31.5 1-1/4 | 26.5 1.06 | 25 1 | 22.4 7/8 | 19 3/4 | 16 5/8 | 13.2 0.530 | 12.5 1/2 | 11.2 7/16 | "
    "9.5 3/8 | 8 5/16 | 6.7 0.265 | 6.3 1/4 |";
constexpr std::string_view astm_numbers =
    "5.6 3-1/2 | 4.75 4 | 4 5 | 3.35 6 | 2.8 7 | 2.36 8 | 2 10 | 1.7 12 | 1.4 14 | 1.18 16 | 1 18 | "
    "0.85 20 | 0.71 25 | 0.6 30 | 0.5 35 | 0.425 40 | 0.355 45 | 0.3 50 | 0.25 60 | 0.212 70 | 0.18 80 | "
    "0.15 100 | 0.125 120 | 0.106 140 | 0.09 170 | 0.075 200 | 0.063 230 | 0.053 270 | 0.045 325 | "
    "0.038 400 | 0.032 450 | 0.025 500 | 0.02 635 |";
constexpr std::string_view tyler_numbers =
    "8 2-1/2 | 6.7 3 | 5.6 3-1/2 | 4.75 4 | 4 5 | 3.35 6 | 2.8 7 | 2.36 8 | 2 9 | 1.7 10 | 1.4 12 | "
    "1.18 14 | 1 16 | 0.85 20 | 0.71 24 | 0.6 28 | 0.5 32 | 0.425 35 | 0.355 42 | 0.3 48 | 0.25 60 | "
    "0.212 65 | 0.18 80 | 0.15 100 | 0.125 115 | 0.106 150 | 0.09 170 | 0.075 200 | 0.063 250 | "
    "0.053 270 | 0.045 325 | 0.038 400 |";

/// The name of a sieve after the changes of section 4.
std::string normal_name(std::string_view field) {
  std::string out;
  bool gap = false;
  for (const char c : lower_case(field)) {
    if (c == ' ' || c == '\t') {
      gap = true;
      continue;
    }
    if (gap && !out.empty() && is_digit(out.back()) && is_digit(c))
      out += '-';
    gap = false;
    out += c;
    if (out.ends_with("\xC2\xB5") || out.ends_with("\xCE\xBC"))
      out.replace(out.size() - 2, 2, "u");
  }
  for (const std::string_view ending : {"\"", "inches", "inch", "in."})
    if (out.ends_with(ending))
      return out.substr(0, out.size() - ending.size()) + "in";
  return out;
}

/// The opening in mm of a sieve's normal name, where a length is written with the decimal `point`.
mpq_class sieve_opening(std::string_view name, char point, std::string_view place) {
  static const struct {
    std::string_view before, after, table;
    mpq_class mm; ///< the unit of a length
  } kinds[] = {{"", "mm", "", 1},
               {"", "um", "", {1, 1000}},
               {"", "m", "", 1000},
               {"no.", "", astm_numbers, 0},
               {"no", "", astm_numbers, 0},
               {"#", "", astm_numbers, 0},
               {"tyler", "mesh", tyler_numbers, 0},
               {"tyler", "", tyler_numbers, 0},
               {"", "in", astm_inches, 0}};
  for (const auto &[before, after, table, mm] : kinds) {
    if (!name.starts_with(before) || !name.ends_with(after))
      continue;
    const std::string_view rest = name.substr(before.size(), name.size() - before.size() - after.size());
    if (table.empty())
      return read_decimal(rest, point, place) * mm;
    const std::size_t found = table.find(" " + std::string(rest) + " |");
    if (found == std::string_view::npos)
      break;
    const std::size_t begin = table.find_last_of(' ', found - 1) + 1;
    return read_decimal(table.substr(begin, found - begin), '.', place);
  }
  throw Malformed(place, quoted(name) + " is no known sieve: write its opening, such as 0.075 mm");
}

/// v within 2^-1001 and 2^1001, rounded to 15 significant digits.
mpq_class rounded_to_15_digits(const mpq_class &v) {
  constexpr long places = 330;
  const mpz_class scaled(v * ten_to(places));
  const unsigned long tail = scaled.get_str().size() - 15;
  const mpz_class rounded = (scaled + 5 * power(10, tail - 1)) / power(10, tail);
  return rounded * ten_to(static_cast<long>(tail) - places);
}

/// 2^-phi (mm): exact for an integer, else the nearest decimal of 15 significant digits.
mpq_class phi_opening(const mpq_class &phi, std::string_view place) {
  demand_form(abs(phi) <= 1000, place, "a phi beyond 1000: no grain has this size");
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), phi.get_num_mpz_t(), phi.get_den_mpz_t());
  const mpz_class magnitude = power(2, mpz_class(abs(whole)).get_ui());
  const mpq_class size = whole < 0 ? mpq_class(magnitude) : mpq_class(1, magnitude);
  if (phi == whole)
    return size;
  // 2^-phi = 2^g * size / 2 with 0 < g < 1, and 2^g = exp(g ln 2) in units of 2^-bits from the series
  // ln 2 = sum 2 / ((2n+1) 3^(2n+1)) and exp y = sum y^n / n!, 0 < y < 0.7. Fewer than 2 * bits truncations,
  // each of them worth less than 8 units in the end: the value lies in [sum, sum + 16 * bits]. It is
  // irrational, so that the two ends round alike when there are enough bits.
  const mpq_class g = 1 + whole - phi;
  for (unsigned long bits = 128;; bits *= 2) {
    mpz_class ln2 = 0, sum = 0;
    mpz_class term = power(2, bits + 1) / 3;
    for (unsigned long n = 1; term > 0; n += 2, term /= 9)
      ln2 += term / n;
    const mpz_class y = ln2 * g.get_num() / g.get_den();
    term = power(2, bits);
    for (unsigned long n = 1; term > 0; ++n) {
      sum += term;
      term = (term * y >> bits) / n;
    }
    const mpq_class unit = size / power(2, bits + 1);
    const mpq_class rounded = rounded_to_15_digits(sum * unit);
    if (rounded == rounded_to_15_digits((sum + 16 * bits) * unit))
      return rounded;
  }
}

/// Turns the percentages or fractions P_j passing, ascending by size, into masses. Where they descend a mass
/// becomes negative: with the last P_j full and the first not negative, none is out of bounds otherwise.
void passing_to_masses(std::vector<Row> &rows, const mpq_class &full, bool has_factors) {
  demand_form(rows.back().value == full, rows.back().place,
              "the largest sieve retains something: add one that retains nothing");
  const Row finest = rows.front();
  demand_form(finest.value >= 0, finest.place, "less than nothing passes here: correct it");
  if (finest.value > 0) {
    demand_form(finest.size > 0 && !has_factors, finest.place,
                "something passes the finest sieve: add a row of the pan where nothing does");
    rows.insert(rows.begin(), {0, 0, 1, 0, finest.place});
  }
  for (std::size_t j = 0; j + 1 < rows.size(); ++j)
    rows[j].value = rows[j + 1].value - rows[j].value;
  rows.back().value = 0;
}

/// What both formats demand of their rows, ascending by size, whose values are masses.
Gradation complete(std::vector<Row> rows, bool has_tolerances) {
  Gradation gradation;
  bool some = false;
  for (Row &row : rows) {
    demand_form(row.size >= 0, row.place, "a negative size: give the opening of the sieve");
    demand_form(gradation.openings.empty() || row.size > gradation.openings.back(), row.place,
                "a size that is there twice or out of order: give each sieve once, sorted");
    demand_form(row.value >= 0, row.place,
                "a negative mass, or more passes than the next sieve lets through: correct it");
    demand_form(row.factor > 0 && row.tolerance >= 0, row.place,
                "a factor or tolerance is too small: give positive factors, tolerances from 0 up");
    some = some || row.value > 0;
    gradation.openings.push_back(std::move(row.size));
    gradation.masses.push_back(std::move(row.value));
    gradation.factors.push_back(std::move(row.factor));
    if (has_tolerances)
      gradation.tolerances.push_back(std::move(row.tolerance));
  }
  demand_form(gradation.masses.back() == 0, rows.back().place,
              "the largest sieve retains something: add one that retains nothing");
  demand_form(some, rows.front().place, "nothing is retained anywhere: give the masses");
  return gradation;
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

using Fields = std::vector<std::string>;

/// The fields of a line; none at all if a quote is not closed or something follows it.
Fields split(std::string_view line, char delimiter) {
  Fields fields;
  for (bool more = true; more;) {
    line = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    const bool quotes = line.starts_with('"');
    std::string field;
    if (quotes) {
      std::size_t at = 1;
      for (; at < line.size() && (line[at] != '"' || line.substr(at, 2) == "\"\""); ++at) {
        at += line[at] == '"' ? 1U : 0U;
        field += line[at];
      }
      if (at >= line.size())
        return {};
      line.remove_prefix(at + 1);
    }
    const std::size_t end = std::min(line.find(delimiter), line.size());
    const std::string_view bare = trimmed(line.substr(0, end));
    if (quotes && !bare.empty())
      return {};
    fields.push_back(quotes ? field : std::string(bare));
    more = end < line.size();
    line.remove_prefix(more ? end + 1 : end);
  }
  return fields;
}

class Csv {
public:
  Gradation read(std::string_view text) {
    const std::string_view all = text;
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      std::string_view line = text.substr(0, end);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
      if (end != std::string_view::npos && line.ends_with('\r'))
        line.remove_suffix(1);
      read_line(line);
    }
    demand_form(rows_.size() >= 2, all, "fewer than two rows below a header: give at least two sieves");
    std::stable_sort(rows_.begin(), rows_.end(), [](const Row &x, const Row &y) { return x.size < y.size; });
    const std::string &kind = header_[1];
    const mpq_class full = kind == "passing_fraction" ? 1 : 100;
    if (kind == "cumulative_retained_percent")
      for (Row &row : rows_)
        row.value = full - row.value;
    if (kind.starts_with("passing_") || kind.starts_with("cumulative_"))
      passing_to_masses(rows_, full, has_column("factor"));
    return complete(std::move(rows_), has_column("tolerance_percent"));
  }

private:
  bool has_column(const char *name) const { return std::count(header_.begin(), header_.end(), name) > 0; }

  void read_line(std::string_view line) {
    const bool comment = trimmed(line).starts_with('#');
    if (trimmed(line).empty() || (comment && (header_.empty() || header_[0] != "sieve")))
      return;
    if (header_.empty() && line.find(';') != std::string_view::npos)
      delimiter_ = ';';
    const Fields fields = split(line, delimiter_);
    // `#200`, `# 3-1/2` begins a row of a table of sieves, where any other # begins a comment.
    if (comment && (fields.size() != header_.size() || !fields[0].starts_with('#') ||
                    fields[0].find_first_not_of("0123456789-/. ", 1) != std::string::npos ||
                    fields[0].find_first_of("0123456789") == std::string::npos))
      return;
    demand_form(!fields.empty(), line, "a quoted field does not end before the delimiter: close its quotes");
    if (header_.empty())
      read_header(fields, line);
    else
      read_row(fields, line);
  }

  void read_header(const Fields &fields, std::string_view line) {
    static const Fields names[] = {{"size_mm", "size_um", "size_m", "size_in", "size_phi", "sieve"},
                                   {"mass", "retained_g", "retained_percent", "retained_fraction",
                                    "cumulative_retained_percent", "passing_percent", "passing_fraction"},
                                   {"tolerance_percent", "factor"}};
    for (std::size_t i = 0; i < std::max<std::size_t>(fields.size(), 2); ++i) {
      const Fields &allowed = names[std::min<std::size_t>(i, 2)];
      const std::string name = i < fields.size() ? fields[i] : "";
      if (std::count(allowed.begin(), allowed.end(), name) == 0 ||
          std::count(fields.begin(), fields.end(), name) > 1)
        throw Malformed(
            line, quoted(name) + " as the name of column " + std::to_string(i + 1) +
                      ": begin with a header such as size_mm,mass (AGS4: give mdm solve --proof's CSV)");
    }
    header_ = fields;
  }

  void read_row(const Fields &fields, std::string_view line) {
    if (fields.size() != header_.size())
      throw Malformed(line, std::to_string(fields.size()) + " fields below a header of " +
                                std::to_string(header_.size()) + ": complete the row or quote the delimiter");
    demand_form(rows_.size() < limit::rows, line, "more than 1048576 rows: give fewer sieves");
    Row row;
    row.place = line;
    row.size = size(fields[0], line);
    row.value = number(fields[1], line);
    for (std::size_t i = 2; i < fields.size(); ++i)
      (header_[i] == "factor" ? row.factor : row.tolerance) = number(fields[i], line);
    rows_.push_back(std::move(row));
  }

  mpq_class size(const std::string &field, std::string_view line) {
    const std::string &kind = header_[0];
    if (lower_case(field) == "pan")
      return 0;
    if (kind == "sieve") {
      // Only a length in mm, um or m is a number; the other names have texts of the tables.
      const std::string name = normal_name(field);
      return sieve_opening(name, name.ends_with('m') ? point(name, line) : '.', line);
    }
    const mpq_class value = number(field, line);
    if (kind == "size_phi")
      return phi_opening(value, line);
    return kind == "size_in" ? mpq_class(value * mpq_class(127, 5)) : value;
  }

  mpq_class number(std::string_view field, std::string_view line) {
    return read_decimal(field, point(field, line), line);
  }

  /// The point that a number is written with: where the delimiter is a semicolon, it may be a comma.
  char point(std::string_view number, std::string_view line) {
    if (number.find_first_of(",.") == std::string_view::npos)
      return '.';
    const char point = delimiter_ == ';' && number.find(',') != std::string_view::npos ? ',' : '.';
    demand_form(point_ == '\0' || point_ == point, line,
                "decimal commas and decimal points in one file: write all numbers with the same");
    return point_ = point;
  }

  Fields header_;
  std::vector<Row> rows_;
  char delimiter_ = ',';
  char point_ = '\0'; ///< of the numbers so far
};

/// Reads JSON in one pass, with every number from its text.
class Json {
public:
  explicit Json(std::string_view text) : rest_(text) {}

  Gradation read() {
    static const std::map<std::string, mpq_class Row::*> columns = {{"sizes", &Row::size},
                                                                    {"masses", &Row::value},
                                                                    {"factors", &Row::factor},
                                                                    {"tolerances_percent", &Row::tolerance}};
    std::vector<Row> rows;
    std::map<std::string, std::size_t> lengths = {{"sizes", 0}, {"masses", 0}};
    mpq_class unit = 1;
    object([&](const std::string &key) {
      const auto column = columns.find(key);
      if (column != columns.end()) {
        std::size_t &length = lengths[key];
        sequence('[', ']', [&] {
          demand_form(length < limit::rows, rest_, "more than 1048576 numbers: give fewer sieves");
          if (length == rows.size())
            rows.emplace_back();
          Row &row = rows[length++];
          row.*column->second = decimal();
          row.place = key == "sizes" ? rest_ : row.place;
        });
      } else if (key == "unit") {
        const std::string name = string();
        demand_form(name == "mm" || name == "um" || name == "m" || name == "in", rest_,
                    "an unknown unit: write mm, um, m or in");
        unit = name == "in" ? mpq_class(127, 5) : mpq_class(1);
      } else if (key == "id" && peek() != '"') {
        number();
      } else {
        skip_value();
      }
    });
    demand_form(peek() == '\0', rest_, "something follows the JSON object: give one object");
    for (const auto &[key, length] : lengths)
      if (length != rows.size() || length < 2)
        fail("\"" + key + "\" has not one number for each of at least two sizes: give them");
    if (rows.front().size > rows.back().size)
      std::reverse(rows.begin(), rows.end());
    for (Row &row : rows)
      row.size *= unit;
    return complete(std::move(rows), lengths.count("tolerances_percent") > 0);
  }

private:
  [[noreturn]] void fail(const std::string &what) const { throw Malformed(rest_, what); }

  /// The next character that is no white space; 0 at the end.
  char peek() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
    return rest_.empty() ? '\0' : rest_[0];
  }
  char next() {
    const char c = rest_.empty() ? '\0' : rest_[0];
    rest_.remove_prefix(rest_.empty() ? 0 : 1);
    return c;
  }
  bool take(char c) {
    const bool yes = peek() == c;
    rest_.remove_prefix(yes ? 1 : 0);
    return yes;
  }
  void demand(char c) {
    if (!take(c))
      fail(quoted(rest_.substr(0, 81)) + " in the JSON, where '" + c + "' belongs: put it there");
  }

  /// Calls element() at each element of an array, or of what else has commas between two brackets.
  void sequence(char open, char close, const std::function<void()> &element) {
    demand_form(++depth_ <= 64, rest_, "JSON nested more than 64 deep: flatten it");
    demand(open);
    if (!take(close)) {
      do
        element();
      while (take(','));
      demand(close);
    }
    --depth_;
  }
  /// Calls member(key) at each value of an object.
  void object(const std::function<void(const std::string &)> &member) {
    std::set<std::string> keys;
    sequence('{', '}', [&] {
      const auto [key, is_new] = keys.insert(string());
      if (!is_new)
        fail("key " + quoted(*key) + " is twice in an object: drop one");
      demand(':');
      member(*key);
    });
  }
  void skip_value() {
    const char c = peek();
    if (c == '{')
      object([this](const std::string &) { skip_value(); });
    else if (c == '[')
      sequence('[', ']', [this] { skip_value(); });
    else if (c == '"')
      string();
    else if (c == 't' || c == 'f' || c == 'n')
      for (const char letter : std::string_view(c == 't' ? "true" : c == 'f' ? "false" : "null"))
        demand_form(next() == letter, rest_, "an unknown word in the JSON: write true, false or null");
    else
      number();
  }

  std::string string() {
    demand('"');
    std::string out;
    for (char c = next(); c != '"'; c = next()) {
      demand_form(static_cast<unsigned char>(c) >= 0x20, rest_,
                  "a string of the JSON is not closed: close it");
      if (c == '\\')
        escape(out);
      else
        out += c;
    }
    return out;
  }
  void escape(std::string &out) {
    constexpr std::string_view letters = "\"\\/bfnrt", meanings = "\"\\/\b\f\n\r\t";
    const char c = next();
    const std::size_t simple = letters.find(c);
    if (simple != std::string_view::npos) {
      out += meanings[simple];
      return;
    }
    demand_form(c == 'u', rest_, "an unknown escape in a string of the JSON: write \\\\ for a backslash");
    std::uint32_t code = code_unit();
    if (code >= 0xD800 && code < 0xDC00 && next() == '\\' && next() == 'u') {
      const std::uint32_t low = code_unit();
      code = low >= 0xDC00 && low < 0xE000 ? 0x10000 + (code - 0xD800) * 0x400 + (low - 0xDC00) : code;
    }
    demand_form(code < 0xD800 || code >= 0xE000, rest_, "half a surrogate pair: write the character itself");
    const std::uint32_t following = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    out += static_cast<char>((following == 0 ? 0 : 0xF00U >> following & 0xFFU) | code >> (6 * following));
    for (std::uint32_t i = following; i-- > 0;)
      out += static_cast<char>(0x80U | (code >> (6 * i) & 0x3FU));
  }
  std::uint32_t code_unit() {
    std::uint32_t unit = 0;
    const std::string_view digits = rest_.substr(0, 4);
    const char *const end = std::from_chars(digits.data(), digits.data() + digits.size(), unit, 16).ptr;
    demand_form(end == rest_.data() + 4, rest_, "\\u needs four hexadecimal digits: write them");
    rest_.remove_prefix(4);
    return unit;
  }

  /// The text of a number as JSON writes it.
  std::string_view number() {
    peek();
    const std::string_view begin = rest_;
    const Decimal d = split_decimal(rest_, '.');
    if (d.sign == "+" || d.whole.empty() || (d.whole.size() > 1 && d.whole[0] == '0') ||
        d.point.empty() != d.fraction.empty() || d.e.empty() != d.exponent.empty())
      fail(quoted(begin.substr(0, 81)) + " is no value of JSON: write a string or a number");
    rest_ = d.rest;
    return begin.substr(0, begin.size() - rest_.size());
  }
  /// A string that holds a decimal, or a number.
  mpq_class decimal() {
    if (peek() == '"')
      return read_decimal(string(), '.', rest_);
    const std::string_view written = number();
    const mpq_class value = read_decimal(written, '.', written);
    demand_form(abs(value) < power(2, 1024), written,
                "beyond the range of JSON numbers: write it as a string");
    return value;
  }

  std::string_view rest_;
  int depth_ = 0;
};

} // namespace

Gradation read_gradation(std::string_view text) {
  demand_form(text.size() <= limit::gradation_bytes, text, "more than 64 MiB: no gradation is that long");
  demand_text(text);
  if (text.starts_with("\xEF\xBB\xBF"))
    text.remove_prefix(3);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && text[begin] == '{' ? Json(text).read() : Csv().read(text);
}

} // namespace mdm_check
