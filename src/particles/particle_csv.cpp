#include "line_reader.hpp"

#include <fmt/core.h>

namespace mdm {
namespace {

class ParticleCsvReader : public LineReader {
public:
  explicit ParticleCsvReader(ParticleSource &source) : source_(source) {}

  void line(std::string_view text) override {
    const std::string_view row = trimmed(text);
    if (row.empty() || row.front() == '#')
      return;
    if (has_header_)
      read_row(row);
    else
      read_header(row);
  }

  void end() override {
    if (!has_header_)
      source_.refuse("there is no header: begin with the line 'size_mm,quantity'");
    source_.check_some();
  }

private:
  void split(std::string_view row) {
    if (!split_fields(row, delimiter_, fields_))
      source_.refuse(
          "a quoted field does not end with a quote before the next delimiter: put its quotes right");
  }

  void read_header(std::string_view row) {
    delimiter_ = row.find(';') == std::string_view::npos ? ',' : ';';
    split(row);
    if (fields_[0].starts_with("lower_"))
      source_.refuse("this is the CSV answer of mdm solve, whose sizes are rounded: use its --format json");
    constexpr std::string_view prefix = "size_";
    const std::optional<LengthUnit> unit =
        fields_[0].starts_with(prefix) ? parse_length_unit(std::string_view(fields_[0]).substr(prefix.size()))
                                       : std::nullopt;
    if (!unit)
      source_.refuse(fmt::format("first column {} is unknown: use size_mm, size_um, size_m or size_in",
                                 in_quotes(fields_[0])));
    if (fields_.size() != 2 || fields_[1] != "quantity")
      source_.refuse("the columns are not a size and 'quantity': write, for example, 'size_mm,quantity'");
    if (source_.options().unit)
      source_.refuse("the header names the unit: leave out --size-unit");
    source_.set_defaults(SizeMeaning::diameter, *unit);
    has_header_ = true;
  }

  void read_row(std::string_view row) {
    split(row);
    if (fields_.size() != 2)
      source_.refuse(fmt::format("the row has {} fields, not a size and a quantity{}", fields_.size(),
                                 delimiter_ == ',' ? " (with decimal commas, put ; between fields)" : ""));
    const std::optional<Integer> quantity = parse_natural(fields_[1]);
    if (!quantity)
      source_.refuse(
          fmt::format("quantity {} is not a whole number from 0 on: write it in at most 1000 digits",
                      in_quotes(fields_[1])));
    const bool comma = delimiter_ == ';' && fields_[0].find(',') != std::string::npos;
    if (*quantity != 0)
      source_.particle(fields_[0], *quantity, comma ? ',' : '.');
  }

  ParticleSource &source_;
  bool has_header_ = false;
  char delimiter_ = ',';
  std::vector<std::string> fields_;
};

} // namespace

std::unique_ptr<LineReader> read_particle_csv(ParticleSource &source) {
  return std::make_unique<ParticleCsvReader>(source);
}

} // namespace mdm
