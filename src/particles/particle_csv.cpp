#include "gradation/csv_rows.hpp"
#include "gradation/phi.hpp"
#include "gradation/sieve_name.hpp"
#include "particles/line_reader.hpp"
#include "particles/particle_columns.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <utility>

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

/// A power of a size, a fraction.
RootSize read_powered(std::string_view text, unsigned power) {
  const std::size_t slash = text.find('/');
  const std::optional<Integer> n = parse_natural(text.substr(0, slash)),
                               d = slash == std::string_view::npos ? std::optional<Integer>(1)
                                                                   : parse_natural(text.substr(slash + 1));
  if (!n || !d || *d == 0)
    throw InputError(in_quotes(text) + " is no fraction: write it like 65/9");
  return {ratio(*n, *d), power};
}

class ParticleCsvReader : public LineReader {
public:
  explicit ParticleCsvReader(ParticleSource &source) : source_(source) {}

  void line(std::string_view text) override {
    const std::string_view row = trimmed(text);
    if (row.empty())
      return;
    if (row.front() == '#')
      read_comment(row);
    else if (has_header_)
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
    delimiter_ = csv_delimiter(row);
    split(row);
    try {
      columns_ = particle_columns(fields_, source_.options().size_column);
    } catch (const InputError &e) {
      source_.refuse(e.what());
    }
    if (source_.options().unit && columns_.has_unit)
      source_.refuse("the header names the unit: leave out " + option(source_.options().unit_option));
    note_passed_over();
    width_ = fields_.size();
    source_.set_defaults(columns_.meaning, columns_.has_unit    ? columns_.unit()
                                           : columns_.is_of_pfc ? SizeUnit::m
                                                                : source_.options().target);
    if (!columns_.has_unit && columns_.kind != SizeKind::sieve && !source_.options().unit)
      source_.note(source_.size_note());
    has_header_ = true;
  }

  void note_passed_over() const {
    std::vector<std::string> names;
    for (const std::string &name : columns_.passed_over)
      names.push_back(in_quotes(name));
    if (!names.empty())
      source_.note(fmt::format("Columns that were passed over: {}.", fmt::join(names, ", ")));
  }

  ParticleSource::ReadSize reader() const {
    if (columns_.power > 1)
      return [power = columns_.power](std::string_view text, char) { return read_powered(text, power); };
    switch (columns_.kind) {
    case SizeKind::phi:
      return read_phi;
    case SizeKind::sieve:
      return [](std::string_view text, char point) { return RootSize{sieve_opening(text, point)}; };
    default:
      return ParticleSource::read_decimal;
    }
  }

  void read_comment(std::string_view row) const {
    try {
      check_comment(row, has_header_ && columns_.kind == SizeKind::sieve);
    } catch (const InputError &e) {
      source_.refuse(e.what());
    }
  }

  Integer quantity() const {
    if (!columns_.quantity)
      return 1;
    const std::string &field = fields_[*columns_.quantity];
    const std::optional<Integer> n = parse_natural(field);
    if (!n)
      source_.refuse(fmt::format(
          "quantity {} is not a whole number from 0 on: write it in at most 1000 digits", in_quotes(field)));
    return *n;
  }

  /// The decimal sign of a number: a comma where fields are not separated by it and it is there.
  char sign_of(const std::string &number) const {
    return delimiter_ != ',' && number.find(',') != std::string::npos ? ',' : '.';
  }

  SphereSample::Place place() const {
    const auto &[x, y, z] = *columns_.place;
    return {fields_[x], fields_[y], fields_[z]};
  }

  /// Ids of particles have a row each; of rows of several an id is that of a class or a sample.
  void check_id() {
    if (!columns_.id || columns_.quantity || !columns_.size)
      return;
    const std::string &id = fields_[*columns_.id];
    if (parse_count(id))
      source_.take_id(id);
    else if (!std::exchange(has_words_as_ids_, true))
      source_.note(
          fmt::format("The column id has words, such as {}: whether one is there twice was not looked "
                      "at.",
                      in_quotes(id)));
  }

  void read_row(std::string_view row) {
    split(row);
    if (fields_.size() != width_)
      source_.refuse(fmt::format("the row has {} fields, and the header {}{}", fields_.size(), width_,
                                 delimiter_ == ',' ? " (with decimal commas, put ; between fields)" : ""));
    check_id();
    note_samples();
    const Integer n = quantity();
    if (n == 0)
      return check_unused();
    if (columns_.material)
      source_.take_material(fields_[*columns_.material]);
    if (columns_.type)
      source_.take_class(fields_[*columns_.type]);
    if (columns_.size) {
      const std::string &field = fields_[*columns_.size];
      if (columns_.place && n == 1) {
        source_.particle_at(place(), field, sign_of(field), reader());
      } else {
        if (columns_.place)
          source_.check_place(place());
        source_.particle(field, n, sign_of(field), reader());
      }
      return;
    }
    check_class();
    const std::string &hi = fields_[*columns_.hi], least = least_size();
    const std::string lower = is_open() ? least : columns_.lower ? fields_[*columns_.lower] : "";
    source_.particle_between(least, hi, lower, n, sign_of(hi));
  }

  /// True where sizes are above the least one: a > stands before it, as in canonical samples.
  bool is_open() const { return fields_[*columns_.lo].starts_with('>'); }
  std::string least_size() const { return fields_[*columns_.lo].substr(is_open() ? 1 : 0); }

  /// In a row of no particles the size may be empty.
  void check_unused() const {
    if (columns_.size && !fields_[*columns_.size].empty())
      source_.check_size(fields_[*columns_.size], sign_of(fields_[*columns_.size]), reader());
    if (!columns_.size && !(fields_[*columns_.lo].empty() && fields_[*columns_.hi].empty()))
      check_class();
  }

  /// The bounds of a size are within those of the row's class, as far as it has them.
  void check_class() const {
    const std::string &hi = fields_[*columns_.hi], lo = least_size();
    const auto length = [this](const std::string &text) {
      return source_.number("size", text, sign_of(text));
    };
    const auto bound = [this](const std::optional<std::size_t> &column) {
      return column ? fields_[*column] : std::string();
    };
    const std::string lower = bound(columns_.lower), upper = bound(columns_.upper);
    if ((!lower.empty() && length(hi) <= length(lower)) || (!upper.empty() && length(lo) > length(upper)))
      source_.refuse(
          fmt::format("a size between {} and {} is in no class of that lower and upper: put one of "
                      "them right",
                      in_quotes(lo), in_quotes(hi)));
  }

  /// Ids beside quantities may name samples, which are read as one.
  void note_samples() {
    if (!columns_.id || !columns_.quantity || has_ids_noted_)
      return;
    const std::string &id = fields_[*columns_.id];
    if (first_id_.empty())
      first_id_ = id;
    has_ids_noted_ = id != first_id_;
    if (has_ids_noted_)
      source_.note(fmt::format("The column id names {} and {}: all rows were taken as one sample.",
                               in_quotes(first_id_), in_quotes(id)));
  }

  ParticleSource &source_;
  bool has_header_ = false;
  ParticleColumns columns_;
  std::size_t width_ = 0;
  char delimiter_ = ',';
  std::vector<std::string> fields_;
  bool has_words_as_ids_ = false;
  std::string first_id_; ///< beside quantities
  bool has_ids_noted_ = false;
};

} // namespace

std::unique_ptr<LineReader> read_particle_csv(ParticleSource &source) {
  return std::make_unique<ParticleCsvReader>(source);
}

} // namespace mdm
