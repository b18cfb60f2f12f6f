#include "gradation/csv_reader.hpp"

#include "gradation/csv_rows.hpp"
#include "gradation/phi.hpp"
#include "gradation/shown.hpp"
#include "gradation/table.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr std::string_view tolerance_column = "tolerance_percent";
constexpr std::string_view factor_column = "factor";
constexpr std::string_view material_column = "material";

/// The kinds of gradations that canonical CSV has, of which a reader takes one.
enum class CsvKind { masses, numbers, materials };

/// The most bits of all openings of a file of phi: it bounds the memory.
constexpr std::uint64_t max_phi_bits = std::uint64_t{1} << 31;

std::string mass_column_names() {
  std::string text;
  for (const MassColumn &column : mass_columns)
    text += (text.empty() ? "" : ", ") + std::string(column.name);
  return text;
}

/// The column of that name; null if there is none.
const MassColumn *find_number_column(std::string_view name) {
  const auto *const found = std::find_if(number_columns.begin(), number_columns.end(),
                                         [name](const MassColumn &c) { return c.name == name; });
  return found == number_columns.end() ? nullptr : found;
}

/// The fields of the first line that is no comment; none if there is no such line.
std::vector<std::string> header_fields(std::string_view content) {
  std::vector<std::string> fields;
  for (Lines lines(content); lines.next();) {
    const std::string_view line = trimmed(lines.text());
    if (line.empty() || line.front() == '#')
      continue;
    split_fields(line, line.find(';') == std::string_view::npos ? ',' : ';', fields);
    break;
  }
  return fields;
}

class CsvReader {
public:
  CsvReader(std::string_view content, const Source &source, const std::string &id, PhiReading phi,
            CsvKind kind = CsvKind::masses)
      : rows_(content, source), source_(source), phi_reading_(phi), kind_(kind) {
    table_.id = id;
  }

  Table read() {
    rows_.read_header("size_mm,passing_percent");
    read_header();
    while (rows_.next())
      read_row();
    if (!phi_.empty())
      set_phi_sizes();
    table_.unit = rows_.unit();
    table_.file_unit = rows_.file_unit();
    table_.notes = rows_.notes();
    table_.format = "CSV";
    table_.sizes_from = "column " + std::string(rows_.size_name());
    table_.masses_from = "column " + std::string(table_.column->name);
    return std::move(table_);
  }

private:
  void read_header() {
    const std::vector<std::string> &names = rows_.fields();
    table_.header_line = rows_.line();
    if (names.size() == 3 && names[1] == "passing_min_percent" && names[2] == "passing_max_percent")
      rows_.refuse(fmt::format("this is a band of allowed gradations, where a gradation is asked for, which "
                               "has one of the columns {}; "
                               "a band is for {} or {}",
                               mass_column_names(), option("band"), option("spec")));
    if (names.size() < 2)
      rows_.refuse("a second column is missing: use one of " + mass_column_names());
    const MassColumn *const of_numbers = find_number_column(names[1]);
    if (of_numbers != nullptr && kind_ != CsvKind::numbers)
      rows_.refuse(
          fmt::format("{} is a share of the number of particles, not of their mass: mdm solve "
                      "finds the smallest set with such shares, and mdm describe FILE tells those of the "
                      "mass; here give one of the columns {}",
                      names[1], mass_column_names()));
    if (kind_ == CsvKind::numbers && names.size() > 2)
      rows_.refuse(
          fmt::format("column {} has no use beside {}: leave it out", in_quotes(names[2]), names[1]));
    table_.column = kind_ == CsvKind::numbers ? of_numbers : find_mass_column(names[1]);
    if (table_.column == nullptr)
      rows_.refuse(fmt::format("second column {} is unknown: use one of {}", in_quotes(names[1]),
                               mass_column_names()));
    for (std::size_t i = 2; i < names.size(); ++i)
      read_optional_column(i);
    if (kind_ == CsvKind::materials && table_.column->full != 0)
      rows_.refuse(fmt::format("{} is a part of a whole, and beside {} nothing says of which: give mass or "
                               "retained_g, in one unit for all materials",
                               names[1], material_column));
    if (kind_ == CsvKind::materials && tolerance_ != 0)
      rows_.refuse(
          fmt::format("column {} has no use beside {}: leave it out", tolerance_column, material_column));
  }

  void read_optional_column(std::size_t i) {
    const std::string &name = rows_.fields()[i];
    std::size_t *place = name == tolerance_column  ? &tolerance_
                         : name == factor_column   ? &factor_
                         : name == material_column ? &material_
                                                   : nullptr;
    if (place == &material_ && kind_ != CsvKind::materials)
      rows_.refuse(fmt::format("column {} is of a gradation of several materials: mdm solve, batch, verify "
                               "and export take it; here give the rows of one material, without this column",
                               material_column));
    if (place == nullptr)
      rows_.refuse(fmt::format("column {} is unknown: after the first two there may be {} and {}",
                               in_quotes(name), tolerance_column, factor_column));
    if (*place != 0)
      rows_.refuse(fmt::format("column {} is there twice: leave one out", name));
    *place = i;
  }

  void read_row() {
    if (table_.lines.size() == max_gradation_rows)
      rows_.refuse(fmt::format("there are more than {} rows: give fewer sieves", max_gradation_rows));
    table_.lines.push_back(rows_.line());
    read_size();
    table_.values.push_back(rows_.number(table_.column->name, 1));
    if (table_.column->form != MassForm::retained)
      table_.roundings.push_back(rows_.last_digit(1) * 50 / table_.column->full);
    else if (table_.column->full != 0)
      table_.mass_roundings.push_back(rows_.last_digit(1) / 2);
    if (tolerance_ != 0)
      table_.tolerances.push_back(rows_.number(tolerance_column, tolerance_));
    if (factor_ != 0)
      table_.factors.push_back(rows_.number(factor_column, factor_));
    if (material_ != 0)
      table_.materials.push_back(material_name());
  }

  const std::string &material_name() const {
    constexpr std::size_t most_bytes = 100;
    const std::string &name = rows_.fields()[material_];
    if (name.empty() || name.size() > most_bytes || trimmed(name).size() != name.size() ||
        printable(name) != name)
      rows_.refuse(
          fmt::format("material {} is no name: give 1 to {} bytes that can be printed, without spaces "
                      "around them",
                      in_quotes(name), most_bytes));
    return name;
  }

  void read_size() {
    if (!rows_.is_phi() || phi_reading_ == PhiReading::rounded) {
      table_.sizes.push_back(rows_.size());
      return;
    }
    phi_.push_back(rows_.phi());
    if (!phi_.back())
      return;
    const Integer root = lcm(Integer(table_.root), Integer(denominator(*phi_.back())));
    if (root > max_root)
      rows_.refuse(
          fmt::format("size_phi {}: the openings 2^-phi mm are exact only up to roots of degree {}, and "
                      "here that is {}: {}",
                      in_quotes(rows_.fields()[0]), max_root, shown(Rational(root)), convert_remedy));
    table_.root = static_cast<unsigned>(root);
  }

  /// The sizes, to the power of the root, which only the last row settles.
  void set_phi_sizes() {
    Rational bits = 0;
    for (const std::optional<Rational> &phi : phi_)
      bits += phi ? Rational(abs(*phi) * table_.root) : Rational(0);
    if (bits > max_phi_bits)
      source_.refuse(table_.header_line,
                     fmt::format("the openings 2^-phi mm take {} bits as roots of fractions, "
                                 "more than {}: {}",
                                 shown(bits), max_phi_bits, convert_remedy));
    for (const std::optional<Rational> &phi : phi_)
      table_.sizes.push_back(phi ? phi_power(*phi, table_.root) : Rational(0));
  }

  CsvRows rows_;
  const Source &source_;
  PhiReading phi_reading_;
  CsvKind kind_;
  std::vector<std::optional<Rational>> phi_; ///< of exact phi sizes; nothing for the pan
  Table table_;
  std::size_t tolerance_ = 0; ///< index of the column, 0 if there is none
  std::size_t factor_ = 0;    ///< index of the column, 0 if there is none
  std::size_t material_ = 0;  ///< index of the column, 0 if there is none
};

} // namespace

bool is_canonical_csv(std::string_view content) {
  const std::vector<std::string> fields = header_fields(content);
  // Where there is no header, the canonical reader says so.
  return fields.empty() || find_size_column(fields[0]) != nullptr;
}

bool is_number_csv(std::string_view content) {
  const std::vector<std::string> fields = header_fields(content);
  return fields.size() > 1 && find_size_column(fields[0]) != nullptr &&
         find_number_column(fields[1]) != nullptr;
}

Table read_number_csv(std::string_view content, const Source &source, const std::string &id) {
  return CsvReader(content, source, id, PhiReading::exact, CsvKind::numbers).read();
}

bool is_material_csv(std::string_view content) {
  const std::vector<std::string> fields = header_fields(content);
  return std::any_of(fields.begin(), fields.end(),
                     [](const std::string &name) { return find_size_column(name) != nullptr; }) &&
         std::find(fields.begin(), fields.end(), material_column) != fields.end();
}

Table read_material_csv(std::string_view content, const Source &source, const std::string &id) {
  return CsvReader(content, source, id, PhiReading::exact, CsvKind::materials).read();
}

Table read_csv(std::string_view content, const Source &source, const std::string &id, PhiReading phi) {
  return CsvReader(content, source, id, phi).read();
}

} // namespace mdm
