#include "gradation/ags4_reader.hpp"

#include "gradation/sample_choice.hpp"
#include "gradation/table.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

namespace mdm {
namespace {

constexpr std::string_view size_heading = "GRAT_SIZE";
constexpr std::string_view passing_heading = "GRAT_PERP";

constexpr const MassColumn &percent_passing = mass_columns[5];
static_assert(percent_passing.name == "passing_percent");

/// A row of a specimen, as it is written.
struct Row {
  std::size_t line;
  std::string size;
  std::string passing;
  std::string type;
};

struct Specimen {
  std::string id; ///< the values of its key, joined
  std::string location, sample_id, sample_reference;
  std::vector<Row> rows;
};

/// All specimens of the group GRAT, in the order of the file.
class Ags4Reader {
public:
  Ags4Reader(std::string_view content, const Source &source) : lines_(content), source_(source) {}

  std::vector<Specimen> read() {
    bool inside = false;
    while (lines_.next()) {
      const std::string_view line = trimmed(lines_.text());
      if (line.starts_with("\"GROUP\"")) {
        split(line);
        inside = fields_.size() > 1 && fields_[1] == "GRAT";
      } else if (inside && !line.empty()) {
        split(line);
        read_line();
      }
    }
    if (specimens_.empty())
      source_.refuse(std::max(lines_.number(), std::size_t{1}),
                     "this AGS4 file has no DATA row in a group GRAT");
    return std::move(specimens_);
  }

private:
  [[noreturn]] void refuse(const std::string &what) const { source_.refuse(lines_.number(), what); }

  void split(std::string_view line) {
    if (!split_fields(line, ',', fields_))
      refuse("a quoted field does not end with a quote before the next comma");
  }

  /// A line of the group GRAT. TYPE says nothing that is needed here.
  void read_line() {
    const std::string &kind = fields_[0];
    if (kind == "HEADING")
      read_headings();
    else if (kind == "UNIT")
      check_units();
    else if (kind == "DATA")
      read_row();
  }

  std::size_t column(std::string_view heading) const {
    const auto found = std::find(fields_.begin(), fields_.end(), heading);
    if (found == fields_.end())
      refuse(fmt::format("group GRAT has no column {}", heading));
    return static_cast<std::size_t>(found - fields_.begin());
  }

  /// The place of a heading that need not be there; beyond all fields if it is not.
  std::size_t optional_column(std::string_view heading) const {
    return static_cast<std::size_t>(std::find(fields_.begin(), fields_.end(), heading) - fields_.begin());
  }

  std::string optional_field(std::size_t i) const { return i < fields_.size() ? fields_[i] : std::string(); }

  void read_headings() {
    width_ = fields_.size();
    has_units_ = false;
    location_ = column("LOCA_ID");
    size_ = column(size_heading);
    passing_ = column(passing_heading);
    type_ = optional_column("GRAT_TYPE");
    sample_id_ = optional_column("SAMP_ID");
    sample_reference_ = optional_column("SAMP_REF");
    key_.clear();
    for (std::size_t i = 0; i < width_; ++i)
      if (i == location_ || fields_[i].starts_with("SAMP_") || fields_[i].starts_with("SPEC_"))
        key_.push_back(i);
  }

  void check_width() const {
    if (width_ == 0)
      refuse("group GRAT has no HEADING row above this one: add it");
    if (fields_.size() != width_)
      refuse(
          fmt::format("the row has {} fields, HEADING has {}: give both the same", fields_.size(), width_));
  }

  void check_units() {
    check_width();
    check_unit(size_heading, size_, "mm");
    check_unit(passing_heading, passing_, "%");
    has_units_ = true;
  }

  void check_unit(std::string_view heading, std::size_t i, std::string_view unit) const {
    if (fields_[i] != unit)
      refuse(fmt::format("{} has the unit {}, only '{}' is read", heading, in_quotes(fields_[i]), unit));
  }

  void read_row() {
    check_width();
    if (!has_units_)
      refuse("group GRAT has no UNIT row above this one: add it");
    specimen().rows.push_back({lines_.number(), fields_[size_], fields_[passing_], optional_field(type_)});
  }

  /// The specimen of the row in fields_.
  Specimen &specimen() {
    std::vector<std::string> key;
    for (const std::size_t i : key_)
      key.push_back(fields_[i]);
    const auto [place, is_new] = index_.emplace(std::move(key), specimens_.size());
    if (is_new)
      specimens_.push_back({joined(place->first),
                            fields_[location_],
                            optional_field(sample_id_),
                            optional_field(sample_reference_),
                            {}});
    return specimens_[place->second];
  }

  static std::string joined(const std::vector<std::string> &key) {
    std::string id;
    for (const std::string &part : key)
      if (!part.empty())
        id += (id.empty() ? "" : "/") + part;
    return id;
  }

  Lines lines_;
  const Source &source_;
  std::vector<std::string> fields_;
  std::size_t width_ = 0;
  bool has_units_ = false;
  std::size_t location_ = 0, size_ = 0, passing_ = 0;           ///< columns
  std::size_t type_ = 0, sample_id_ = 0, sample_reference_ = 0; ///< columns that need not be there
  std::vector<std::size_t> key_;                                ///< columns that tell specimens apart
  std::map<std::vector<std::string>, std::size_t> index_;
  std::vector<Specimen> specimens_;
};

std::vector<SampleNames> names_of(const std::vector<Specimen> &specimens) {
  std::vector<SampleNames> all;
  for (const Specimen &s : specimens)
    all.push_back({{s.id, s.location, s.sample_id, s.sample_reference}, s.rows.front().line});
  return all;
}

/// What GRAT_TYPE says of the rows: WS and DS are wet and dry sieving, HY and PP hydrometer and pipette.
std::string types_of(const Specimen &specimen) {
  std::vector<std::string> types;
  for (const Row &row : specimen.rows)
    if (!row.type.empty() && std::find(types.begin(), types.end(), row.type) == types.end())
      types.push_back(row.type);
  return fmt::format("{}", fmt::join(types, ", "));
}

Rational decimal(const std::string &text, std::string_view heading, std::size_t line, const Source &source) {
  try {
    return parse_decimal(text);
  } catch (const InputError &error) {
    source.refuse(line, fmt::format("{} {}", heading, error.what()));
  }
}

/// \param of the number of specimens in the file
Table table_of(const Specimen &specimen, std::size_t of, const Source &source,
               const std::string &fallback_id) {
  if (specimen.rows.size() > max_gradation_rows)
    source.refuse(specimen.rows.back().line, fmt::format("specimen {} has more than {} rows",
                                                         in_quotes(specimen.id), max_gradation_rows));
  Table table;
  table.column = &percent_passing;
  table.id = specimen.id.empty() ? fallback_id : specimen.id;
  table.header_line = specimen.rows.front().line;
  for (const Row &row : specimen.rows) {
    table.lines.push_back(row.line);
    table.sizes.push_back(decimal(row.size, size_heading, row.line, source));
    table.values.push_back(decimal(row.passing, passing_heading, row.line, source));
    table.roundings.push_back(last_digit_unit(row.passing) / 2);
  }
  table.notes.push_back(fmt::format("Specimen {} of {}.", in_quotes(specimen.id), of));
  if (const std::string types = types_of(specimen); !types.empty())
    table.notes.push_back("GRAT_TYPE: " + printable(types) + ".");
  table.format = "AGS4";
  table.sizes_from = fmt::format("column {}, in mm", size_heading);
  table.masses_from = fmt::format("column {}: percent passing", passing_heading);
  table.is_canonical = false;
  return table;
}

} // namespace

Table read_ags4(std::string_view content, const Source &source, const std::string &fallback_id,
                const std::optional<std::string> &specimen) {
  const std::vector<Specimen> specimens = Ags4Reader(content, source).read();
  const std::vector<SampleNames> names = names_of(specimens);
  Table table =
      table_of(specimens[chosen_sample(names, specimen, source)], specimens.size(), source, fallback_id);
  for (const SampleNames &sample : names)
    table.samples.push_back(sample.names.front());
  return table;
}

std::vector<UnreadGradation> ags4_specimens(std::string_view content, const std::string &file,
                                            const std::string &fallback_id) {
  const auto specimens =
      std::make_shared<const std::vector<Specimen>>(Ags4Reader(content, Source(file)).read());
  std::vector<UnreadGradation> all;
  for (const Specimen &specimen : *specimens)
    all.push_back(
        {specimen.id.empty() ? fallback_id : specimen.id, [specimens, &specimen, file, fallback_id] {
           const Source source(file);
           return to_gradation(table_of(specimen, specimens->size(), source, fallback_id), source);
         }});
  return all;
}

} // namespace mdm
