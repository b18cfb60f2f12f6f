#include "particles/material_table.hpp"

#include "text/lines.hpp"
#include "text/source.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

/// A column of values, and what it sets.
struct MaterialColumn {
  const char *name;
  Rational least, most;
  const char *range;
  void (*set)(GrainMaterial &, const Rational &);
};

const std::array<MaterialColumn, 5> &material_columns() {
  static const std::array<MaterialColumn, 5> columns = {
      {{"young_modulus", 1, power_of_ten(15), "from 1 to 1e15 Pa",
        [](GrainMaterial &m, const Rational &x) { m.elasticity.young = x; }},
       {"poisson", 0, ratio(1, 2), "from 0 to 0.5",
        [](GrainMaterial &m, const Rational &x) { m.elasticity.poisson = x; }},
       {"friction", 0, 10, "from 0 to 10",
        [](GrainMaterial &m, const Rational &x) { m.friction = x.convert_to<double>(); }},
       {"restitution", ratio(1, 20), 1, "from 0.05 to 1",
        [](GrainMaterial &m, const Rational &x) { m.restitution = x.convert_to<double>(); }},
       {"rolling_friction", 0, 10, "from 0 to 10",
        [](GrainMaterial &m, const Rational &x) { m.rolling_friction = x.convert_to<double>(); }}}};
  return columns;
}

class MaterialTable {
public:
  MaterialTable(std::string_view content, const std::string &source, const ParticleSet &set,
                const GrainMaterial &others)
      : source_(source), set_(set), lines_(content), materials_(set.classes.size(), others),
        lines_of_classes_(set.classes.size(), 0) {
    source_.check_text(content, content.size());
  }

  std::vector<GrainMaterial> read() {
    if (!next())
      source_.refuse(1, "there is no header: begin with the line 'class,young_modulus,friction'");
    read_header();
    while (next())
      read_row();
    for (std::size_t i = 0; i < materials_.size(); ++i)
      if (lines_of_classes_[i] == 0)
        source_.refuse(lines_.number(), fmt::format("class {} ({} mm, {} mm] has grains, but no row: add one",
                                                    set_.classes[i].number,
                                                    short_decimal(in_mm(set_.unit) * set_.classes[i].lower),
                                                    short_decimal(in_mm(set_.unit) * set_.classes[i].upper)));
    return std::move(materials_);
  }

private:
  /// Moves on to the next line with fields.
  bool next() {
    while (lines_.next()) {
      const std::string_view text = trimmed(lines_.text());
      if (text.empty() || text.front() == '#')
        continue;
      if (!split_fields(text, ',', fields_))
        source_.refuse(lines_.number(), "a quoted field does not end with a quote: put its quotes right");
      return true;
    }
    return false;
  }

  void read_header() {
    names_ = fields_;
    by_lower_ = names_[0] == "lower_mm";
    if (!by_lower_ && names_[0] != "class")
      source_.refuse(lines_.number(), in_quotes(names_[0]) + " is no first column: it is class, or lower_mm");
    for (std::size_t i = 1; i < names_.size(); ++i) {
      const auto &columns = material_columns();
      const auto *const column = std::find_if(columns.begin(), columns.end(),
                                              [&](const MaterialColumn &c) { return names_[i] == c.name; });
      if (column == columns.end() || std::count(names_.begin(), names_.end(), names_[i]) > 1)
        source_.refuse(lines_.number(), in_quotes(names_[i]) +
                                            " is no column, or there twice: use young_modulus, poisson, "
                                            "friction, restitution and rolling_friction, each once");
      columns_.push_back(column);
    }
    if (columns_.empty())
      source_.refuse(lines_.number(),
                     "there are no values: add young_modulus, poisson, friction, restitution or "
                     "rolling_friction");
  }

  Rational number(std::size_t field) const {
    try {
      return parse_decimal(fields_[field]);
    } catch (const InputError &e) {
      source_.refuse(lines_.number(), names_[field] + ": " + e.what());
    }
  }

  std::size_t class_index() const {
    const Rational key = number(0);
    const auto found = std::find_if(set_.classes.begin(), set_.classes.end(), [&](const ParticleClass &c) {
      return key == (by_lower_ ? Rational(in_mm(set_.unit) * c.lower) : Rational(Integer(c.number)));
    });
    if (found == set_.classes.end())
      source_.refuse(lines_.number(), fmt::format("{} {} is no class with grains: leave the row out",
                                                  names_[0], in_quotes(fields_[0])));
    return static_cast<std::size_t>(found - set_.classes.begin());
  }

  void read_row() {
    if (fields_.size() != names_.size())
      source_.refuse(lines_.number(),
                     fmt::format("the row has {} fields, the header {}: put one of them right",
                                 fields_.size(), names_.size()));
    const std::size_t i = class_index();
    if (lines_of_classes_[i] != 0)
      source_.refuse(lines_.number(), fmt::format("class {} has a row already, line {}: leave one out",
                                                  set_.classes[i].number, lines_of_classes_[i]));
    lines_of_classes_[i] = lines_.number();
    for (std::size_t field = 1; field < fields_.size(); ++field) {
      const MaterialColumn &column = *columns_[field - 1];
      const Rational value = number(field);
      if (value < column.least || value > column.most)
        source_.refuse(lines_.number(),
                       fmt::format("{}: {} is not {}", column.name, in_quotes(fields_[field]), column.range));
      column.set(materials_[i], value);
    }
  }

  Source source_;
  const ParticleSet &set_;
  Lines lines_;
  std::vector<std::string> fields_, names_;
  std::vector<const MaterialColumn *> columns_;
  bool by_lower_ = false;
  std::vector<GrainMaterial> materials_;
  std::vector<std::size_t> lines_of_classes_; ///< 0: none yet
};

} // namespace

std::vector<GrainMaterial> read_materials(std::string_view content, const std::string &source,
                                          const ParticleSet &set, const GrainMaterial &others) {
  return MaterialTable(without_byte_order_mark(content), source, set, others).read();
}

} // namespace mdm
