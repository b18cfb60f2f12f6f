#include "particles/lammps_units.hpp"
#include "particles/line_reader.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

/// Text dumps of LAMMPS and LIGGGHTS: for each timestep items with their values below them, at last ITEM:
/// ATOMS with the names of its columns. The last timestep counts, or the one that was asked for, or each.
class DumpReader : public LineReader {
public:
  explicit DumpReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::diameter, SizeUnit::m);
  }

  void line(std::string_view text) override {
    constexpr std::string_view mark = "ITEM:";
    if (text.starts_with(mark)) {
      begin_item(trimmed(text.substr(mark.size())));
      return;
    }
    split_words(text, words_);
    if (words_.empty())
      return;
    if (item_ == Item::none)
      source_.refuse("the line is not below an ITEM: begin with ITEM: TIMESTEP");
    if (item_ == Item::units) {
      take_units(words_.front(), source_);
      item_ = Item::other;
    } else if (item_ == Item::timestep)
      begin_timestep();
    else if (item_ == Item::count)
      read_count();
    else if (item_ == Item::box)
      read_bounds();
    else if (item_ == Item::atoms)
      read_atom();
  }

  void end() override {
    check_complete();
    const std::optional<Integer> &asked = source_.options().timestep;
    if (timesteps_ == 0)
      source_.refuse("there is no ITEM: TIMESTEP up to here, the end: is it a dump?");
    if (asked && found_ == 0)
      source_.refuse(fmt::format("there is no timestep {}: there are {}, from {} to {}", to_string(*asked),
                                 timesteps_, to_string(first_), to_string(timestep_)));
    if (found_ > 1)
      source_.note(
          fmt::format("Timestep {} is there {} times; the last was taken.", to_string(*asked), found_));
    if (!asked && timesteps_ > 1 && !source_.options().every_timestep)
      source_.note(fmt::format(
          "The file has {} timesteps; the last, {}, was taken.{}", timesteps_, to_string(timestep_),
          source_.options().can_choose_timestep ? " Use " + option("timestep") + " for another." : ""));
    check_some();
    source_.check_some();
  }

private:
  enum class Item { none, units, timestep, count, box, atoms, other };

  void begin_item(std::string_view item) {
    split_words(item, words_);
    check_item();
    if (item == "TIMESTEP") {
      check_complete();
      check_some();
      item_ = Item::timestep;
      taken_ = !source_.options().timestep;
      complete_ = false;
      atoms_.reset();
      read_ = 0;
    } else if (item == "NUMBER OF ATOMS") {
      item_ = Item::count;
    } else if (words_.size() >= 2 && words_[0] == "BOX" && words_[1] == "BOUNDS") {
      begin_box();
    } else if (!words_.empty() && words_.front() == "ATOMS") {
      begin_atoms();
    } else {
      check_complete_atoms();
      item_ = item == "UNITS" ? Item::units : Item::other;
    }
  }

  /// The item above has its lines; one of a timestep that was not asked for may be cut off.
  void check_item() const {
    if (item_ == Item::units)
      source_.refuse("there is no unit below ITEM: UNITS: write it, or leave the item out");
    if (item_ == Item::box && axis_ < 3 && taken_)
      source_.refuse("the bounds of the box have fewer than three lines: is the file damaged?");
  }

  void check_complete_atoms() const {
    if (item_ == Item::atoms)
      check_complete();
  }

  /// Each timestep that is handed on has particles.
  void check_some() const {
    if (source_.options().every_timestep && timesteps_ > 0 && read_ == 0)
      source_.refuse(fmt::format("timestep {} has no particles: take it out, or leave out {}",
                                 to_string(timestep_), option("over-time")));
  }

  void begin_timestep() {
    const std::optional<Integer> number = parse_natural(words_.front());
    if (words_.size() != 1 || !number)
      source_.refuse("the timestep is not a whole number: is the file damaged?");
    timestep_ = *number;
    if (++timesteps_ == 1)
      first_ = timestep_;
    const std::optional<Integer> &asked = source_.options().timestep;
    taken_ = !asked || *asked == timestep_;
    if (asked && taken_)
      ++found_;
    if (taken_)
      source_.begin_timestep(timestep_);
    item_ = Item::other;
  }

  void read_count() {
    atoms_ = words_.size() == 1 ? parse_count(words_.front()) : std::nullopt;
    if (!atoms_)
      source_.refuse("the number of atoms is not a whole number: is the file damaged?");
    item_ = Item::other;
  }

  /// `BOX BOUNDS pp pp ff` with a line `lo hi` for each axis: pp is periodic. That of a tilted box has `xy xz
  /// yz` ahead of them, and a tilt behind each line; a general one is `BOX BOUNDS abc origin`.
  void begin_box() {
    check_complete_atoms();
    const bool is_general = words_.size() > 2 && words_[2] == "abc";
    const std::size_t ahead = words_.size() > 2 && words_[2] == "xy" ? 3 : 0;
    if (is_general && taken_)
      source_.leave_out_places();
    item_ = is_general ? Item::other : Item::box;
    axis_ = 0;
    numbers_of_axis_ = ahead == 0 ? 2 : 3;
    is_tilted_ = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
      periodic_[axis] = words_.size() == 5 + ahead && words_[2 + ahead + axis] == "pp";
  }

  void read_bounds() {
    if (words_.size() != numbers_of_axis_ || axis_ == 3)
      source_.refuse("the bounds of the box are not three lines with a lower and an upper one: is the file "
                     "damaged?");
    is_tilted_ = is_tilted_ || (numbers_of_axis_ == 3 && !is_zero_number(words_[2]));
    bounds_[axis_++] = {std::string(words_[0]), std::string(words_[1])};
    if (axis_ < 3 || !taken_)
      return;
    if (is_tilted_)
      source_.leave_out_places();
    else
      source_.set_box(bounds_, periodic_);
  }

  /// The column of that name; the width where there is none.
  std::size_t column(std::string_view name) const {
    const auto found = std::find(words_.begin() + 1, words_.end(), name);
    if (found != words_.end() && std::count(found, words_.end(), name) > 1)
      source_.refuse(fmt::format("there are several columns {}: write one", name));
    return static_cast<std::size_t>(found - words_.begin() - 1);
  }

  /// The columns x y z of centres, or those of unwrapped ones; nothing where they are not there.
  void find_places() {
    has_places_ = false;
    constexpr std::array<std::array<std::string_view, 3>, 2> sets = {{{"x", "y", "z"}, {"xu", "yu", "zu"}}};
    for (const auto &names : sets) {
      const std::array<std::size_t, 3> at = {column(names[0]), column(names[1]), column(names[2])};
      if (!has_places_ && *std::max_element(at.begin(), at.end()) < width_) {
        places_ = at;
        has_places_ = true;
      }
    }
  }

  void begin_atoms() {
    if (!atoms_ || complete_)
      source_.refuse("ITEM: ATOMS has no ITEM: TIMESTEP and ITEM: NUMBER OF ATOMS of its own: is the file "
                     "damaged?");
    width_ = words_.size() - 1;
    id_ = column("id");
    type_ = column("type");
    const std::optional<SizeMeaning> &asked = source_.options().meaning;
    const std::optional<std::string> &named = source_.options().size_column;
    radius_ = named ? width_ : column("radius");
    diameter_ = column(named ? *named : "diameter");
    if (named && diameter_ == width_)
      source_.refuse("there is no column " + in_quotes(*named) + ": write one of ITEM: ATOMS for " +
                     option("size-column"));
    if (radius_ == width_ && diameter_ == width_)
      source_.refuse(
          "there is no column radius or diameter: add one of them to the dump command, or name the column "
          "with " +
          option("size-column"));
    has_both_ = !asked && radius_ < width_ && diameter_ < width_;
    const bool by_radius = radius_ < width_ && !(asked == SizeMeaning::diameter && diameter_ < width_);
    column_ = by_radius ? radius_ : diameter_;
    source_.set_defaults(by_radius ? SizeMeaning::radius : SizeMeaning::diameter, SizeUnit::m);
    find_places();
    item_ = Item::atoms;
    complete_ = *atoms_ == 0;
  }

  void read_atom() {
    if (read_ == *atoms_)
      source_.refuse(
          fmt::format("there are more atoms than the {} of this timestep: is the file damaged?", *atoms_));
    if (words_.size() != width_ && taken_)
      source_.refuse(fmt::format("the line has {} values, there are {} columns: is the file cut off?",
                                 words_.size(), width_));
    if (taken_)
      take_atom();
    complete_ = ++read_ == *atoms_;
  }

  void take_atom() {
    if (id_ < width_)
      source_.take_id(words_[id_]);
    if (type_ < width_)
      source_.take_class(words_[type_]);
    if (has_both_)
      source_.check_agree(words_[radius_], words_[diameter_]);
    if (has_places_)
      source_.particle_at({words_[places_[0]], words_[places_[1]], words_[places_[2]]}, words_[column_]);
    else
      source_.particle(words_[column_]);
  }

  /// A timestep that was not asked for may be cut off.
  void check_complete() const {
    if (!complete_ && taken_)
      source_.refuse(fmt::format("the timestep ends after {} of {} atoms: is the file cut off? {} "
                                 "takes another",
                                 read_, atoms_ ? std::to_string(*atoms_) : "its", option("timestep")));
  }

  ParticleSource &source_;
  std::vector<std::string_view> words_;
  Item item_ = Item::none;
  Integer timestep_, first_;
  std::uint64_t timesteps_ = 0;
  bool taken_ = false;      ///< the timestep counts
  std::uint64_t found_ = 0; ///< timesteps of the number that was asked for
  std::optional<std::uint64_t> atoms_;
  std::uint64_t read_ = 0;
  bool complete_ = true; ///< all atoms of the timestep were read
  std::size_t width_ = 0;
  /// Columns, of which one that is not there is width_; column_ is that of the sizes.
  std::size_t id_ = 0, type_ = 0, radius_ = 0, diameter_ = 0, column_ = 0;
  bool has_both_ = false; ///< radius and diameter count, and agree
  std::size_t axis_ = 0;  ///< of the bounds that come next
  std::size_t numbers_of_axis_ = 2;
  bool is_tilted_ = false; ///< the box of this timestep
  std::array<std::array<std::string, 2>, 3> bounds_;
  std::array<bool, 3> periodic_{};
  bool has_places_ = false;
  std::array<std::size_t, 3> places_{}; ///< their columns
};

} // namespace

std::unique_ptr<LineReader> read_dump(ParticleSource &source) {
  return std::make_unique<DumpReader>(source);
}

} // namespace mdm
