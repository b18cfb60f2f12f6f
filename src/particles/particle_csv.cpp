#include "gradation/csv_rows.hpp"
#include "gradation/phi.hpp"
#include "gradation/sieve_name.hpp"
#include "particles/line_reader.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

/// 2^-phi mm, exactly.
RootSize read_phi(std::string_view text, char point) {
  const Rational phi = parse_decimal(text, point);
  check_phi(phi);
  const Integer root = denominator(phi);
  if (root > max_root)
    throw InputError(fmt::format("phi {} is no fraction with a denominator up to {}: give the size in mm",
                                 in_quotes(text), max_root));
  const auto degree = static_cast<unsigned>(root);
  return {phi_power(phi, degree), degree};
}

class ParticleCsvReader : public LineReader {
public:
  explicit ParticleCsvReader(ParticleSource &source) : source_(source) {}

  void line(std::string_view text) override {
    const std::string_view row = trimmed(text);
    if (row.empty() || (row.front() == '#' && !is_sieve_row(row)))
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
    const SizeColumn *const column = find_size_column(fields_[0]);
    if (column == nullptr)
      source_.refuse(unknown_size_column(fields_[0], "size_mm,quantity"));
    if (fields_.size() != 2 || fields_[1] != "quantity")
      source_.refuse("the columns are not a size and 'quantity', in this order: write, for example, "
                     "'size_mm,quantity'");
    if (source_.options().unit)
      source_.refuse("the header names the unit: leave out --size-unit");
    kind_ = column->kind;
    source_.set_defaults(SizeMeaning::diameter, unit());
    has_header_ = true;
  }

  LengthUnit unit() const {
    switch (kind_) {
    case SizeKind::um:
      return LengthUnit::um;
    case SizeKind::m:
      return LengthUnit::m;
    case SizeKind::inch:
      return LengthUnit::in;
    default: // phi and sieves are turned into mm
      return LengthUnit::mm;
    }
  }

  ParticleSource::ReadSize reader() const {
    switch (kind_) {
    case SizeKind::phi:
      return read_phi;
    case SizeKind::sieve:
      return [](std::string_view text, char point) { return RootSize{sieve_opening(text, point)}; };
    default:
      return ParticleSource::read_decimal;
    }
  }

  /// The one exception to comments: a row of a sieve such as `#200`.
  bool is_sieve_row(std::string_view row) {
    return has_header_ && kind_ == SizeKind::sieve && split_fields(row, delimiter_, fields_) &&
           fields_.size() == 2 && is_sieve_number(fields_[0]);
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
    if (*quantity == 0)
      return;
    const bool comma = delimiter_ == ';' && fields_[0].find(',') != std::string::npos;
    const char point = comma ? ',' : '.';
    source_.particle(fields_[0], *quantity, point, reader());
  }

  ParticleSource &source_;
  bool has_header_ = false;
  SizeKind kind_ = SizeKind::mm;
  char delimiter_ = ',';
  std::vector<std::string> fields_;
};

} // namespace

std::unique_ptr<LineReader> read_particle_csv(ParticleSource &source) {
  return std::make_unique<ParticleCsvReader>(source);
}

} // namespace mdm
