#include "particles/line_reader.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// Moves the first word or `key=value` of a comment out of it. Blanks within double quotes, where a backslash
/// guards the next character, do not end it.
std::string_view take_item(std::string_view &rest) {
  rest = trimmed(rest);
  bool is_quoted = false;
  std::size_t end = 0;
  for (; end < rest.size() && (is_quoted || !is_blank(rest[end])); ++end)
    if (rest[end] == '"')
      is_quoted = !is_quoted;
    else if (rest[end] == '\\' && end + 1 < rest.size())
      ++end;
  const std::string_view item = rest.substr(0, end);
  rest.remove_prefix(end);
  return item;
}

/// The value behind a key, in letters of any case, and its `=` in a comment, without quotes around it.
std::optional<std::string_view> value_of(std::string_view key, std::string_view comment) {
  for (std::string_view item = take_item(comment); !item.empty(); item = take_item(comment)) {
    if (!are_alike(item.substr(0, key.size()), key))
      continue;
    item.remove_prefix(key.size());
    const bool has_quotes = item.size() >= 2 && item.front() == '"' && item.back() == '"';
    return has_quotes ? item.substr(1, item.size() - 2) : item;
  }
  return std::nullopt;
}

/// Moves what is above the next colon out of `rest`, and the colon.
std::string_view take_part(std::string_view &rest) {
  const std::string_view part = rest.substr(0, rest.find(':'));
  rest.remove_prefix(std::min(part.size() + 1, rest.size()));
  return part;
}

/// Extended XYZ: the number of particles, a comment with `Properties=name:type:columns:...`, and a line a
/// particle with these columns. The sizes are the column radius; the format has no unit.
class ExtxyzReader : public LineReader {
public:
  explicit ExtxyzReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::radius, source.options().target);
  }

  void line(std::string_view text) override {
    if (source_.line() == 1)
      read_count(trimmed(text));
    else if (source_.line() == 2)
      read_comment(text);
    else
      read_row(text);
  }

  void end() override {
    if (source_.line() < 2)
      source_.refuse("the file ends above the comment with Properties=: is it cut off?");
    if (read_ != particles_)
      source_.refuse(
          fmt::format("the file ends after {} of {} particles: is it cut off?", read_, particles_));
    source_.check_some();
  }

private:
  struct Property {
    std::string_view name, type;
    std::uint64_t columns;
  };

  void read_count(std::string_view text) {
    const std::optional<std::uint64_t> count = parse_count(text);
    if (!count)
      source_.refuse(fmt::format("{} is no number of particles: write a whole number", in_quotes(text)));
    particles_ = *count;
  }

  void read_comment(std::string_view text) {
    const std::optional<std::string_view> properties = value_of("Properties=", text);
    if (!properties)
      source_.refuse("there is no Properties= in the comment: write for example "
                     "Properties=species:S:1:pos:R:3:radius:R:1");
    for (std::string_view rest = *properties; !rest.empty();)
      add(take_property(rest));
    read_unit(text);
    read_box(text);
    if (!radius_)
      source_.refuse(
          fmt::format("there is no radius among the Properties {}: add radius:R:1", in_quotes(*properties)));
  }

  /// The format has no key for the unit; one that is there is not passed over.
  void read_unit(std::string_view comment) {
    for (const std::string_view key :
         {"unit=", "units=", "length_unit=", "length_units=", "lengthunit=", "size_unit=", "radius_unit="})
      if (const std::optional<std::string_view> stated = value_of(key, comment)) {
        const std::optional<SizeUnit> unit = parse_size_unit(*stated);
        if (!unit)
          source_.refuse(fmt::format("{}{} is no unit of lengths that is known: write {}mm, um, m or in", key,
                                     in_quotes(*stated), key));
        source_.take_unit({name(*unit), in_mm(*unit)}, fmt::format("{}{}", key, *stated));
      }
  }

  /// `Lattice="a 0 0 0 b 0 0 0 c"` is a box from `Origin="x y z"`, or from 0; `pbc="T T F"` says which sides
  /// are periodic: all, if it is not there. With a tilted one the places are left out.
  void read_box(std::string_view comment) {
    std::vector<std::string_view> sides, origin, periodic;
    split_words(value_of("Lattice=", comment).value_or(""), sides);
    split_words(value_of("Origin=", comment).value_or("0 0 0"), origin);
    split_words(value_of("pbc=", comment).value_or("T T T"), periodic);
    if (!source_.wants_places() || sides.empty())
      return;
    const auto all_numbers = [](const std::vector<std::string_view> &words) {
      return std::all_of(words.begin(), words.end(), is_number);
    };
    if (sides.size() != 9 || origin.size() != 3 || periodic.size() != 3 || !all_numbers(sides) ||
        !all_numbers(origin))
      source_.refuse(
          "the Lattice, Origin or pbc is not nine numbers, three numbers, and three of T and F: put "
          "them right");
    std::array<std::array<std::string, 2>, 3> bounds;
    std::array<bool, 3> repeats{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t other = 0; other < 3; ++other)
        if (other != axis && !is_zero_number(sides[3 * axis + other]))
          return source_.leave_out_places();
      repeats[axis] = lower(periodic[axis].front()) == 't';
      bounds[axis] = {std::string(origin[axis]),
                      exact_decimal(parse_decimal(origin[axis]) + parse_decimal(sides[4 * axis])).value()};
    }
    source_.set_box(bounds, repeats);
  }

  Property take_property(std::string_view &rest) const {
    const std::string_view name = take_part(rest);
    const std::string_view type = take_part(rest);
    const std::optional<std::uint64_t> columns = parse_count(take_part(rest));
    const bool is_type = type == "S" || type == "I" || type == "R" || type == "L";
    if (name.empty() || !is_type || !columns || *columns == 0)
      source_.refuse(fmt::format("property {} is not name:type:columns with type S, I, R or L: write for "
                                 "example pos:R:3",
                                 in_quotes(name)));
    return {name, type, *columns};
  }

  /// Gives the property the next columns.
  void add(const Property &property) {
    const bool is_one_number = property.columns == 1 && (property.type == "R" || property.type == "I");
    if ((property.name == "radius" || property.name == "diameter") && !is_one_number)
      source_.refuse(
          fmt::format("property '{0}' is not one number a particle: write {0}:R:1", property.name));
    if (property.name == "radius")
      set(radius_, property);
    else if (property.name == "diameter")
      set(diameter_, property);
    else if (property.name == "id" && is_one_number)
      set(id_, property);
    else if (property.name == "type" && is_one_number)
      set(type_, property);
    else if (property.name == "pos" && property.columns == 3 && property.type != "S")
      set(place_, property);
    width_ += property.columns;
    if (width_ > max_fields)
      source_.refuse(fmt::format("the Properties have more than {} columns, which is not read: write fewer",
                                 max_fields));
  }

  void set(std::optional<std::uint64_t> &column, const Property &property) const {
    if (column)
      source_.refuse(fmt::format("property '{}' is there twice: leave one", property.name));
    column = width_;
  }

  void read_row(std::string_view text) {
    split_words(text, words_);
    if (words_.empty())
      return;
    if (read_ == particles_)
      source_.refuse(fmt::format("there are more particles than the {} of the first line: write one frame "
                                 "alone, or put the number right",
                                 particles_));
    if (words_.size() != width_)
      source_.refuse(fmt::format("the line has {} values, the Properties have {} columns: is the file "
                                 "damaged?",
                                 words_.size(), width_));
    if (id_)
      source_.take_id(words_[*id_]);
    if (type_)
      source_.take_class(words_[*type_]);
    const std::optional<SizeMeaning> &asked = source_.options().meaning;
    if (diameter_ && !asked)
      source_.check_agree(words_[*radius_], words_[*diameter_]);
    const std::string_view size = words_[diameter_ && asked == SizeMeaning::diameter ? *diameter_ : *radius_];
    if (place_)
      source_.particle_at({words_[*place_], words_[*place_ + 1], words_[*place_ + 2]}, size);
    else
      source_.particle(size);
    ++read_;
  }

  ParticleSource &source_;
  std::vector<std::string_view> words_;
  std::uint64_t particles_ = 0; ///< that the first line gives
  std::uint64_t read_ = 0;
  std::uint64_t width_ = 0;             ///< columns of a line
  std::optional<std::uint64_t> radius_; ///< its column, from 0
  std::optional<std::uint64_t> diameter_, id_, type_;
  std::optional<std::uint64_t> place_; ///< the first column of pos
};

} // namespace

std::unique_ptr<LineReader> read_extxyz(ParticleSource &source) {
  return std::make_unique<ExtxyzReader>(source);
}

} // namespace mdm
