#include "gradation.hpp"

#include "json_text.hpp"
#include "text.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <set>

namespace mdm::checker {
namespace {

constexpr std::size_t most_rows = std::size_t{1} << 20U; // limit 5

/// A row of a CSV file or an element of the arrays of a JSON file. The value is what the second column says,
/// `most` the third of a band; the place in the file is for messages.
struct Row {
  mpq_class size = 0, value = 0, most = 0, factor = 1, tolerance = 0;
  std::string_view place;
  bool is_pan = false;
  std::string material = {};
};

/// Turns the percentages or fractions P_j passing, ascending by size, into masses. Where they descend a mass
/// becomes negative: with the last P_j full and the first not negative, none is out of bounds otherwise.
void passing_to_masses(std::vector<Row> &rows, const mpq_class &full, bool has_factors) {
  demand_form(rows.back().value <= full, rows.back().place, "more than the whole passes here: correct it");
  demand_form(rows.back().value == full, rows.back().place,
              "the largest sieve retains something: add one that retains nothing");
  const Row finest = rows.front();
  demand_form(finest.value >= 0, finest.place, "less than nothing passes here: correct it");
  if (finest.value > 0) {
    demand_form(finest.size > 0 && !has_factors, finest.place,
                "something passes the finest sieve: add a row of the pan where nothing does");
    rows.insert(rows.begin(), {0, 0, 0, 1, 0, finest.place, true});
  }
  for (std::size_t j = 0; j + 1 < rows.size(); ++j)
    rows[j].value = rows[j + 1].value - rows[j].value;
  rows.back().value = 0;
}

/// The demands of both formats on their rows, ascending by size, whose values are masses.
Gradation complete(std::vector<Row> rows, bool has_tolerances) {
  Gradation gradation;
  bool some = false;
  for (auto &[size, mass, most, factor, tolerance, place, is_pan, material] : rows) {
    demand_form(gradation.openings.empty() ? size >= 0 : size > gradation.openings.back(), place,
                "a size that is negative, there twice or out of order: give each sieve once, sorted");
    demand_form(mass >= 0, place,
                "a negative mass, or more passes than the next sieve lets through: correct it");
    demand_form(factor > 0 && tolerance >= 0, place,
                "a factor or tolerance is too small: give positive factors, tolerances from 0 up");
    some = some || mass > 0;
    gradation.openings.push_back(std::move(size));
    gradation.masses.push_back(std::move(mass));
    gradation.factors.push_back(std::move(factor));
    if (has_tolerances)
      gradation.tolerances.push_back(std::move(tolerance));
  }
  demand_form(gradation.masses.back() == 0, rows.back().place,
              "the largest sieve retains something: add one that retains nothing");
  demand_form(some, rows.front().place, "nothing is retained anywhere: give the masses");
  return gradation;
}

/// The same of rows that are sorted by material: each material's are a gradation of its own.
Gradation complete_materials(const std::vector<Row> &rows) {
  Gradation all;
  for (auto begin = rows.begin(); begin != rows.end();) {
    const auto end =
        std::find_if(begin, rows.end(), [&](const Row &row) { return row.material != begin->material; });
    const Gradation part = complete({begin, end}, false);
    all.openings.insert(all.openings.end(), part.openings.begin(), part.openings.end());
    all.masses.insert(all.masses.end(), part.masses.begin(), part.masses.end());
    all.factors.insert(all.factors.end(), part.factors.begin(), part.factors.end());
    all.materials.insert(all.materials.end(), part.openings.size(), begin->material);
    begin = end;
  }
  return all;
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char &c : out)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

// The tables of section 5: opening in mm, and normal name.
constexpr std::string_view sieves =
    "125 5in | 106 4.24in | 100 4in | 90 3-1/2in | 75 3in | 63 2-1/2in | 53 2.12in | 50 2in | 45 1-3/4in | "
    "37.5 1-1/2in | 31.5 1-1/4in | 26.5 1.06in | 25 1in | 22.4 7/8in | 19 3/4in | 16 5/8in | 13.2 0.530in | "
    "12.5 1/2in | 11.2 7/16in | 9.5 3/8in | 8 5/16in | 6.7 0.265in | 6.3 1/4in | "
    "5.6 #3-1/2 | 4.75 #4 | 4 #5 | 3.35 #6 | 2.8 #7 | 2.36 #8 | 2 #10 | 1.7 #12 | 1.4 #14 | 1.18 #16 | "
    "1 #18 | 0.85 #20 | 0.71 #25 | 0.6 #30 | 0.5 #35 | 0.425 #40 | 0.355 #45 | 0.3 #50 | 0.25 #60 | "
    "0.212 #70 | 0.18 #80 | 0.15 #100 | 0.125 #120 | 0.106 #140 | 0.09 #170 | 0.075 #200 | 0.063 #230 | "
    "0.053 #270 | 0.045 #325 | 0.038 #400 | 0.032 #450 | 0.025 #500 | 0.02 #635 | "
    "8 tyler2-1/2 | 6.7 tyler3 | 5.6 tyler3-1/2 | 4.75 tyler4 | 4 tyler5 | 3.35 tyler6 | 2.8 tyler7 | "
    "2.36 tyler8 | 2 tyler9 | 1.7 tyler10 | 1.4 tyler12 | 1.18 tyler14 | 1 tyler16 | 0.85 tyler20 | "
    "0.71 tyler24 | 0.6 tyler28 | 0.5 tyler32 | 0.425 tyler35 | 0.355 tyler42 | 0.3 tyler48 | "
    "0.25 tyler60 | 0.212 tyler65 | 0.18 tyler80 | 0.15 tyler100 | 0.125 tyler115 | 0.106 tyler150 | "
    "0.09 tyler170 | 0.075 tyler200 | 0.063 tyler250 | 0.053 tyler270 | 0.045 tyler325 | 0.038 tyler400 |";

/// The name of a sieve after the changes of section 4, and with `#` for `No.` and no `mesh`.
std::string normal_name(std::string_view field) {
  std::string out;
  bool gap = false;
  for (const char c : lower_case(field)) {
    const bool blank = c == ' ' || c == '\t';
    if (!blank && gap && !out.empty() && is_digit(out.back()) && is_digit(c))
      out += '-';
    gap = blank;
    if (!blank)
      out += c;
    if (out.ends_with("\xC2\xB5") || out.ends_with("\xCE\xBC"))
      out.replace(out.size() - 2, 2, "u");
  }
  for (const std::string_view number : {"no.", "no"})
    if (out.starts_with(number))
      out.replace(0, number.size(), "#");
  if (out.starts_with("tyler") && out.ends_with("mesh"))
    out.resize(out.size() - 4);
  for (const std::string_view ending : {"\"", "inches", "inch", "in."})
    if (out.ends_with(ending))
      return out.substr(0, out.size() - ending.size()) + "in";
  return out;
}

/// 2^-phi (mm) to the power root, of which phi is a multiple of the inverse.
mpq_class phi_opening(const mpq_class &phi, unsigned long root) {
  const mpz_class exponent(phi * root);
  const mpz_class magnitude = power(2, mpz_class(abs(exponent)).get_ui());
  return exponent < 0 ? mpq_class(magnitude) : mpq_class(1, magnitude);
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

} // namespace

using Fields = std::vector<std::string>;

Fields csv_fields(std::string_view line, char delimiter) {
  Fields fields;
  for (bool more = true; more;) {
    line = trimmed(line);
    std::string field;
    const bool quotes = line.starts_with('"');
    while (line.starts_with('"')) {
      const std::size_t end = line.find('"', 1);
      if (end == std::string_view::npos)
        return {};
      field += line.substr(1, end - 1);
      line.remove_prefix(end + 1);
      field += line.starts_with('"') ? "\"" : "";
    }
    const std::size_t end = std::min(line.find(delimiter), line.size());
    const std::string_view bare = trimmed(line.substr(0, end));
    if (quotes && !bare.empty())
      return {};
    fields.push_back(field + std::string(bare));
    more = end < line.size();
    line.remove_prefix(more ? end + 1 : end);
  }
  return fields;
}

namespace {

class Csv {
public:
  Gradation read(std::string_view text) {
    const std::string_view all = text;
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(line.size() + 1, text.size()));
      if (end != std::string_view::npos && line.ends_with('\r'))
        line.remove_suffix(1);
      read_line(line);
    }
    const bool is_band = !header_.empty() && header_[1] == "passing_min_percent";
    demand_form(rows_.size() >= (is_band ? 1 : 2), all,
                "fewer than two rows below a header (one of a band): give the sieves");
    if (header_[0] == "size_phi")
      make_openings(is_band);
    std::stable_sort(rows_.begin(), rows_.end(), [](const Row &x, const Row &y) {
      return x.material == y.material ? x.size < y.size : x.material < y.material;
    });
    const std::vector<Limit> limits = is_band ? make_middle() : std::vector<Limit>();
    const std::string &kind = header_[1];
    const mpq_class full = kind == "passing_fraction" ? 1 : 100;
    if (kind == "cumulative_retained_percent")
      for (Row &row : rows_)
        row.value = full - row.value;
    const std::size_t written = rows_.size();
    if (kind.starts_with("passing_") || kind.starts_with("cumulative_")) // also cumulative_number_percent
      passing_to_masses(rows_, full, has_column("factor"));
    const bool implied_pan = rows_.size() > written;
    Gradation gradation = has_column("material")
                              ? complete_materials(rows_)
                              : complete(std::move(rows_), has_column("tolerance_percent"));
    gradation.root = root_.get_ui();
    gradation.limits = limits;
    gradation.sizes = header_[0];
    gradation.values = kind;
    gradation.has_factors = has_column("factor");
    gradation.implied_pan = implied_pan;
    return gradation;
  }

private:
  bool has_column(const char *name) const { return std::count(header_.begin(), header_.end(), name) > 0; }

  void read_line(std::string_view line) {
    const std::string_view text = trimmed(line);
    if (text.empty())
      return;
    if (text.starts_with('#')) {
      check_comment(text.substr(1), line);
      return;
    }
    if (header_.empty() && line.find(';') != std::string_view::npos)
      delimiter_ = ';';
    const Fields fields = csv_fields(line, delimiter_);
    demand_form(!fields.empty(), line, "a quoted field does not end before the delimiter: close its quotes");
    if (header_.empty())
      read_header(fields, line);
    else
      read_row(fields, line);
  }

  /// A number behind the # may be that of a sieve.
  void check_comment(std::string_view behind, std::string_view line) const {
    const bool below_sieves = !header_.empty() && header_[0] == "sieve";
    const std::string_view first = below_sieves ? trimmed(behind) : behind;
    demand_form(first.empty() || !is_digit(first[0]), line,
                below_sieves
                    ? "may be a sieve or a comment: write No. 4 for a sieve, begin a comment with a word"
                    : "may be a sieve or a comment: write '# ' before a comment, No. 4 for a sieve",
                trimmed(line));
  }

  /// Turns phi into openings to the power root.
  void make_openings(bool is_band) {
    mpz_class longest = 0;
    for (const Row &row : rows_) {
      demand_form(!is_band || root_ == 1, row.place, "a band needs whole phi: give its openings in mm");
      longest = std::max<mpz_class>(longest, mpz_class(abs(row.size) * root_));
    }
    demand_form(longest * static_cast<unsigned long>(rows_.size()) <= power(2, 28), rows_.front().place,
                "phi of so many digits take too much memory: mdm convert writes the openings in mm");
    for (Row &row : rows_)
      row.size = row.is_pan ? mpq_class(0) : phi_opening(row.size, root_.get_ui());
  }

  /// The limits of a band. What passes becomes their middle: each limit is first narrowed by those of the
  /// other sieves, because a curve does not fall; where they contradict each other, the lower ones count.
  std::vector<Limit> make_middle() {
    std::vector<Limit> limits;
    for (const auto &[size, least, most, factor, tolerance, place, is_pan, material] : rows_) {
      demand_form(0 <= least && least <= 100 && 0 <= most && most <= 100, place,
                  "a limit of what passes is not from 0 to 100 percent: correct it");
      demand_form(size != 0 || least == 0, place, "nothing passes the pan: write 0");
      limits.push_back({size, least, most});
    }
    demand_form(rows_.back().most == 100, rows_.back().place,
                "not all may pass the largest sieve: add one that lets 100 percent pass");
    bool contradict = false;
    for (std::size_t j = 1; j < rows_.size(); ++j)
      rows_[j].value = std::max(rows_[j].value, rows_[j - 1].value);
    for (std::size_t j = rows_.size(); j-- > 0;) {
      if (j + 1 < rows_.size())
        rows_[j].most = std::min(rows_[j].most, rows_[j + 1].most);
      contradict = contradict || rows_[j].value > rows_[j].most;
    }
    for (Row &row : rows_)
      row.value = contradict ? row.value : mpq_class((row.value + row.most) / 2);
    rows_.back().value = 100;
    if (rows_.front().size == 0)
      rows_.front().value = 0;
    return limits;
  }

  void read_header(const Fields &fields, std::string_view line) {
    static const Fields names[] = {{"size_mm", "size_um", "size_m", "size_in", "size_phi", "sieve"},
                                   {"mass", "retained_g", "retained_percent", "retained_fraction",
                                    "cumulative_retained_percent", "passing_percent", "passing_fraction",
                                    "number_percent", "cumulative_number_percent"},
                                   {"tolerance_percent", "factor", "material"}};
    static const Fields band = {"passing_min_percent", "passing_max_percent"};
    demand_form(fields.size() >= 2, line, "a single column: begin with a header such as size_mm,mass");
    const bool is_band = std::equal(fields.begin() + 1, fields.end(), band.begin(), band.end());
    for (std::size_t i = 0; i < (is_band ? 1 : fields.size()); ++i) {
      const Fields &allowed = names[std::min<std::size_t>(i, 2)];
      demand_form(std::count(allowed.begin(), allowed.end(), fields[i]) == 1 &&
                      std::count(fields.begin(), fields.end(), fields[i]) == 1,
                  line,
                  "is no column here: begin with a header such as size_mm,mass (AGS4: give the CSV that "
                  "mdm solve --proof writes)",
                  fields[i]);
    }
    demand_form(!is_number_column(fields[1]) || fields.size() == 2, line,
                "no column may follow one of shares by number: drop it");
    demand_form(std::count(fields.begin(), fields.end(), "material") == 0 ||
                    ((fields[1] == "mass" || fields[1] == "retained_g") &&
                     std::count(fields.begin(), fields.end(), "tolerance_percent") == 0),
                line, "beside a material there is mass or retained_g, and no tolerance: give these");
    header_ = fields;
  }

  void read_row(const Fields &fields, std::string_view line) {
    demand_form(fields.size() == header_.size(), line,
                "more or fewer fields than the header has: complete the row or quote the delimiter");
    demand_form(rows_.size() < most_rows, line, "more than 1048576 rows: give fewer sieves");
    Row row;
    row.place = line;
    row.is_pan = lower_case(fields[0]) == "pan";
    row.size = row.is_pan ? mpq_class(0) : size(fields[0], line);
    row.value = number(fields[1], line);
    for (std::size_t i = 2; i < fields.size(); ++i)
      if (header_[i] == "material")
        row.material = material(fields[i], line);
      else
        (header_[i] == "factor"              ? row.factor
         : header_[i] == "tolerance_percent" ? row.tolerance
                                             : row.most) = number(fields[i], line);
    rows_.push_back(std::move(row));
  }

  static std::string material(const std::string &field, std::string_view line) {
    demand_form(!field.empty() && field.size() <= 100 && trimmed(field).size() == field.size(), line,
                "is no name of a material: give 1 to 100 bytes without spaces around them", field);
    return field;
  }

  /// The opening in the file's unit (mm for inches and names of sieves), or phi.
  mpq_class size(const std::string &field, std::string_view line) {
    const std::string &kind = header_[0];
    if (kind == "sieve")
      return sieve_opening(normal_name(field), line);
    const mpq_class value = number(field, line);
    if (kind == "size_phi") {
      demand_form(abs(value) <= 1000, line, "a phi beyond 1000: no grain has this size");
      root_ = lcm(root_, value.get_den());
      demand_form(
          root_ <= 1000, line,
          "makes the openings roots of a degree above 1000: mdm convert writes them in mm, rounded to "
          "15 digits",
          field);
    }
    return kind == "size_in" ? mpq_class(value * mpq_class(127, 5)) : value;
  }

  /// The opening in mm: a length, or that of the tables.
  mpq_class sieve_opening(const std::string &name, std::string_view line) {
    static const std::pair<std::string_view, mpq_class> units[] = {{"mm", 1}, {"um", {1, 1000}}, {"m", 1000}};
    for (const auto &[unit, mm] : units)
      if (name.ends_with(unit))
        return number(name.substr(0, name.size() - unit.size()), line) * mm;
    const std::size_t end = sieves.find(" " + name + " |");
    demand_form(end != std::string_view::npos, line, "is no known sieve: write its opening, such as 0.075 mm",
                name);
    const std::size_t begin = sieves.rfind(' ', end - 1) + 1;
    return read_decimal(sieves.substr(begin, end - begin), line);
  }

  /// With the delimiter `;` a number may be written with a decimal comma.
  mpq_class number(std::string field, std::string_view line) {
    for (char &c : field)
      if (delimiter_ == ';' && (c == ',' || c == '.')) {
        demand_form(point_ == '\0' || point_ == c, line,
                    "decimal commas and decimal points in one file: write all numbers with the same");
        point_ = c;
        c = '.';
      }
    return read_decimal(field, line);
  }

  Fields header_;
  std::vector<Row> rows_;
  mpz_class root_ = 1; ///< the common denominator of all phi so far
  char delimiter_ = ',';
  char point_ = '\0'; ///< of the numbers so far
};

/// Reads a gradation in JSON.
class Json : JsonText {
public:
  using JsonText::JsonText;

  Gradation read() {
    const std::map<std::string, mpq_class Row::*> columns = {{"sizes", &Row::size},
                                                             {"masses", &Row::value},
                                                             {"factors", &Row::factor},
                                                             {"tolerances_percent", &Row::tolerance}};
    std::vector<Row> rows;
    std::map<std::string, std::size_t> lengths = {{"sizes", 0}, {"masses", 0}};
    std::string unit = "mm";
    object([&](const std::string &key) {
      if (columns.count(key) > 0) {
        std::size_t &length = lengths[key];
        sequence('[', ']', [&] {
          demand_form(length < most_rows, rest_, "more than 1048576 numbers: give fewer sieves");
          if (length == rows.size())
            rows.emplace_back();
          Row &row = rows[length++];
          row.*columns.at(key) = decimal();
          row.place = key == "sizes" ? rest_ : row.place;
        });
      } else if (key == "unit") {
        unit = string();
        demand_form(unit == "mm" || unit == "um" || unit == "m" || unit == "in", rest_,
                    "is an unknown unit: write mm, um, m or in", unit);
      } else {
        demand_form(key == "id", rest_,
                    "is no key here: write id, unit, sizes, masses, factors or tolerances_percent", key);
        if (peek() == '"')
          string();
        else
          decimal();
      }
    });
    demand_form(peek() == '\0', rest_, "follows the JSON object: give one object", rest_);
    for (const auto &[key, length] : lengths)
      demand_form(length == rows.size() && length >= 2, rest_,
                  "has not one number for each of at least two sizes: give them", key);
    if (rows.front().size > rows.back().size)
      std::reverse(rows.begin(), rows.end());
    if (unit == "in")
      for (Row &row : rows)
        row.size *= mpq_class(127, 5);
    Gradation gradation = complete(std::move(rows), lengths.count("tolerances_percent") > 0);
    gradation.sizes = "size_" + unit;
    gradation.has_factors = lengths.count("factors") > 0;
    return gradation;
  }
};

} // namespace

bool is_number_column(std::string_view name) {
  return name == "number_percent" || name == "cumulative_number_percent";
}

std::string Gradation::unit() const {
  return sizes == "size_um" ? "um" : sizes == "size_m" ? "m" : "mm";
}

namespace {

Gradation read_any_gradation(std::string_view text) {
  demand_text(text);
  if (text.starts_with("\xEF\xBB\xBF"))
    text.remove_prefix(3);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && text[begin] == '{' ? Json(text).read() : Csv().read(text);
}

} // namespace

Gradation read_gradation(std::string_view text) {
  Gradation gradation = read_gradation_or_materials(text);
  demand_form(gradation.materials.empty(), text,
              "several materials, which only certificates of matches are of: give a gradation of one");
  return gradation;
}

Gradation read_gradation_or_materials(std::string_view text) {
  Gradation gradation = read_any_gradation(text);
  demand_form(!is_number_column(gradation.values), text,
              "has shares of the number of particles, not of their mass: give one by mass", gradation.values);
  return gradation;
}

Gradation read_number_gradation(std::string_view text) {
  Gradation gradation = read_any_gradation(text);
  demand_form(is_number_column(gradation.values), text,
              "has masses, and the certificate is of shares by number: give the gradation that it is of",
              gradation.values);
  return gradation;
}

} // namespace mdm::checker
