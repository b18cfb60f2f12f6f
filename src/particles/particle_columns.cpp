#include "particles/particle_columns.hpp"

#include "gradation/table.hpp"
#include "text/lines.hpp"

#include <mdm/number/integer.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

/// A name without the unit that follows its last `_`.
struct UnitName {
  std::string_view stem;
  std::optional<SizeKind> kind;
};

UnitName unit_name(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, SizeKind>, 5> units = {{{"mm", SizeKind::mm},
                                                                           {"um", SizeKind::um},
                                                                           {"m", SizeKind::m},
                                                                           {"in", SizeKind::inch},
                                                                           {"phi", SizeKind::phi}}};
  const std::size_t cut = name.rfind('_');
  if (cut != std::string_view::npos)
    for (const auto &[unit, kind] : units)
      if (name.substr(cut + 1) == unit)
        return {name.substr(0, cut), kind};
  return {name, std::nullopt};
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The name that a column of PFC's or of ParaView has here; others stay.
std::string known_name(const std::string &name) {
  if (is_of_paraview(name) && name.size() == 8 && name.back() >= '0' && name.back() <= '2')
    return std::string(1, static_cast<char>('x' + (name.back() - '0')));
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> of_others = {
      {{"EVENT_LABEL", "id"},
       {"PFC_BALL_LOCX", "x"},
       {"PFC_BALL_LOCY", "y"},
       {"PFC_BALL_LOCZ", "z"},
       {"PFC_BALL_RADIUS", "radius"},
       {"PFC_BALL_ATTR", "type"},
       {"Radius", "radius"},
       {"Diameter", "diameter"}}};
  for (const auto &[theirs, ours] : of_others)
    if (name == theirs)
      return std::string(ours);
  return name;
}

/// Reads the names of a header one after the other.
class Header {
public:
  Header(const std::vector<std::string> &names, const std::optional<std::string> &size_column)
      : size_column_(size_column),
        passes_over_(size_column || std::any_of(names.begin(), names.end(), is_of_paraview)) {
    for (std::size_t i = 0; i < names.size(); ++i)
      take(i, names[i]);
    if (size_column && !columns_.size)
      throw InputError("there is no column " + in_quotes(*size_column) + ": name one of the header");
  }

  ParticleColumns columns() const {
    const bool has_bounds = columns_.lo && columns_.hi;
    if (columns_.lo.has_value() != columns_.hi.has_value())
      throw InputError("of size_lo and size_hi one is missing: give both");
    if (!has_bounds && !of_class_.empty() && !passes_over_)
      refuse_unknown(of_class_);
    if (has_bounds && unit_of_class_ && (!columns_.has_unit || *unit_of_class_ != columns_.kind))
      throw InputError("the columns lower and upper have another unit than size_lo: write all in one");
    if (columns_.size.has_value() == has_bounds)
      throw InputError(has_bounds ? "there are a size and its bounds: give one of them"
                                  : "there is no column of sizes: name it, for example, size_mm");
    ParticleColumns columns = columns_;
    columns.place = place();
    return columns;
  }

private:
  void take(std::size_t i, const std::string &written) {
    if (size_column_ == written)
      return set_size(i, written, unit_name(written).kind);
    columns_.is_of_pfc |= written == "PFC_BALL_RADIUS";
    const std::string known = known_name(written), name = known.substr(0, known.find('^'));
    if (name.empty())
      throw InputError("a column has no name: give one table alone, and each of its columns a name");
    if (size_column_ && is_of_sizes(name)) {
      columns_.passed_over.push_back(name);
      return;
    }
    if (name != known) {
      take_power(i, known);
      return;
    }
    const auto [stem, kind] = unit_name(name);
    if (name == "sieve")
      set_size(i, name, SizeKind::sieve);
    else if (is_one_of(stem, {"size", "diameter"}) || name == "d")
      set_size(i, name, kind);
    else if (kind != SizeKind::phi && (stem == "radius" || name == "r")) {
      columns_.meaning = SizeMeaning::radius;
      set_size(i, name, kind);
    } else if (kind != SizeKind::phi && is_one_of(stem, {"size_lo", "size_hi"})) {
      set_unit(kind);
      set(stem == "size_lo" ? columns_.lo : columns_.hi, i, name);
    } else if (kind && is_one_of(stem, {"lower", "upper"}))
      set_of_class(stem == "lower" ? columns_.lower : columns_.upper, i, name, *kind);
    else if (name == "quantity" || name == "count")
      set(columns_.quantity, i, name);
    else if (is_one_of(name, {"class", "mass"}))
      of_class_ = name;
    else if (is_one_of(stem, {"x", "y", "z"}))
      set_axis(axes_[static_cast<std::size_t>(stem.front() - 'x')], i, name, kind);
    else if (name == "id")
      set(columns_.id, i, name);
    else if (name == "material")
      set(columns_.material, i, name);
    else if (name == "type")
      set(columns_.type, i, name);
    else if (passes_over_)
      columns_.passed_over.push_back(name);
    else
      refuse_unknown(name);
  }

  /// True of a name by which sizes are known without being named.
  static bool is_of_sizes(std::string_view name) {
    return name == "sieve" || name == "d" || name == "r" ||
           is_one_of(unit_name(name).stem, {"size", "diameter", "radius", "size_lo", "size_hi"});
  }

  /// `size_mm^3`, as canonical samples beside certificates have it.
  void take_power(std::size_t i, const std::string &name) {
    const std::size_t cut = name.find('^');
    const auto [stem, kind] = unit_name(std::string_view(name).substr(0, cut));
    const std::optional<Integer> power = parse_natural(std::string_view(name).substr(cut + 1));
    constexpr unsigned most_power = 1'000'000;
    if (stem != "size" || !kind || kind == SizeKind::phi || !power || *power < 2 || *power > most_power)
      throw InputError(
          "column " + in_quotes(name) +
          " is no power of a size: write, for example, size_mm^3, with a power from 2 to 1000000");
    set_size(i, name, kind);
    columns_.power = static_cast<unsigned>(*power);
  }

  /// A column and its unit.
  using Axis = std::pair<std::size_t, std::optional<SizeKind>>;

  [[noreturn]] static void refuse_unknown(const std::string &name) {
    if (find_mass_column(name) != nullptr)
      throw InputError(
          "column " + in_quotes(name) +
          " is of a gradation, and particles are wanted: mdm solve GRADATION --spread --format csv "
          "writes some that it has");
    throw InputError("column " + in_quotes(name) +
                     " is unknown: a file of particles has size_mm, diameter_mm or radius_mm (mm, um, m or "
                     "in), size_phi or sieve, and beside it quantity or x,y,z if they are wanted");
  }

  [[noreturn]] static void refuse_second(const std::string &name) {
    throw InputError("column " + in_quotes(name) + ": there is one of this meaning before: leave one out");
  }

  static void set(std::optional<std::size_t> &column, std::size_t i, const std::string &name) {
    if (column)
      refuse_second(name);
    column = i;
  }

  static void set_axis(std::optional<Axis> &axis, std::size_t i, const std::string &name,
                       std::optional<SizeKind> kind) {
    if (axis)
      refuse_second(name);
    axis = {i, kind};
  }

  /// A bound of a row's class.
  void set_of_class(std::optional<std::size_t> &column, std::size_t i, const std::string &name,
                    SizeKind kind) {
    if (unit_of_class_ && *unit_of_class_ != kind)
      throw InputError("column " + in_quotes(name) + ": the other bound has another unit: write both in one");
    unit_of_class_ = kind;
    if (&column == &columns_.upper)
      of_class_ = name;
    set(column, i, name);
  }

  void set_unit(std::optional<SizeKind> kind) {
    const bool is_second = columns_.size || columns_.lo || columns_.hi;
    if (is_second && (kind.has_value() != columns_.has_unit || kind.value_or(SizeKind::mm) != columns_.kind))
      throw InputError("the columns of sizes have different units: write them in one");
    columns_.has_unit = kind.has_value();
    columns_.kind = kind.value_or(SizeKind::mm);
  }

  void set_size(std::size_t i, const std::string &name, std::optional<SizeKind> kind) {
    set_unit(kind);
    set(columns_.size, i, name);
  }

  /// The columns x, y and z where all have the unit of sizes: their own, or none.
  std::optional<std::array<std::size_t, 3>> place() const {
    std::array<std::size_t, 3> place{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!axes_[axis])
        return std::nullopt;
      const auto &[column, kind] = *axes_[axis];
      const bool has_unit_of_sizes = columns_.has_unit ? kind == columns_.kind : !kind;
      if (!has_unit_of_sizes && kind)
        return std::nullopt;
      place[axis] = column;
    }
    return place;
  }

  std::optional<std::string> size_column_;
  bool passes_over_; ///< names that are not known
  ParticleColumns columns_;
  std::array<std::optional<Axis>, 3> axes_; ///< x, y and z
  std::optional<SizeKind> unit_of_class_;   ///< of lower and upper
  std::string of_class_;                    ///< a column of what solve and generate say of classes
};

} // namespace

bool is_of_paraview(std::string_view name) {
  return name.starts_with("Points:") || name.starts_with("Points_");
}

SizeUnit ParticleColumns::unit() const {
  switch (kind) {
  case SizeKind::um:
    return SizeUnit::um;
  case SizeKind::m:
    return SizeUnit::m;
  case SizeKind::inch:
    return SizeUnit::in;
  default:
    return SizeUnit::mm;
  }
}

ParticleColumns particle_columns(const std::vector<std::string> &names,
                                 const std::optional<std::string> &size_column) {
  return Header(names, size_column).columns();
}

char csv_delimiter(std::string_view header) {
  for (const char delimiter : {';', ',', '\t'})
    if (header.find(delimiter) != std::string_view::npos)
      return delimiter;
  return ',';
}

bool has_particle_column(const std::vector<std::string> &names) {
  const bool is_alone = names.size() == 1; // a title, it may be
  return std::any_of(names.begin(), names.end(), [is_alone](std::string name) {
    std::transform(name.begin(), name.end(), name.begin(), lower);
    const auto begins = [&name](const char *word) { return name.starts_with(word); };
    return begins("size_") || begins("lower_") || name == "sieve" ||
           (is_alone ? begins("diameter_") || begins("radius_")
                     : begins("diameter") || begins("radius") || begins("pfc_ball_radius") ||
                           begins("quantity") || name == "size" || name == "r" || name == "d");
  });
}

} // namespace mdm
