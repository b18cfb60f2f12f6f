#include "particles/lammps_units.hpp"
#include "particles/line_reader.hpp"
#include "text/lines.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

/// A data file: a title, a header with `N atoms`, then sections. In section Atoms, atom_style sphere, a line
/// is `id type diameter density x y z`, and three image flags where there are some.
class LammpsDataReader : public LineReader {
public:
  explicit LammpsDataReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::diameter, SizeUnit::m);
  }

  void line(std::string_view text) override {
    if (source_.line() == 1) {
      read_title(text);
      return;
    }
    const std::size_t hash = std::min(text.find('#'), text.size());
    split_words(text.substr(0, hash), words_);
    if (words_.empty())
      return;
    if (section_ == Section::header)
      read_bounds();
    const char first = lower(words_.front().front());
    if (section_ == Section::header && words_.size() == 2 && words_[1] == "atoms")
      read_count();
    else if (first >= 'a' && first <= 'z')
      begin_section(trimmed(text.substr(std::min(hash + 1, text.size()))));
    else if (section_ == Section::atoms)
      read_atom();
  }

  void end() override {
    if (!has_atoms_)
      source_.refuse("the section Atoms is missing: is the file cut off?");
    check_count();
    if (!named_style_)
      source_.note("The section Atoms names no style; atom_style sphere was assumed.");
    source_.check_some();
  }

private:
  static constexpr std::size_t diameter = 2; ///< its place in a line

  enum class Section { header, atoms, other };

  /// write_data ends its title with `units = STYLE`.
  void read_title(std::string_view title) {
    constexpr std::string_view word = "units";
    for (std::size_t at = title.find(word); at != std::string_view::npos; at = title.find(word, at + 1)) {
      const std::string_view rest = trimmed(title.substr(at + word.size()));
      if (!rest.starts_with('='))
        continue;
      const std::string_view style = trimmed(rest.substr(1));
      take_units(style.substr(0, style.find_first_of(", \t")), source_);
    }
  }

  void read_count() {
    if (atoms_)
      source_.refuse("the number of atoms is there twice: leave one");
    atoms_ = parse_count(words_[0]);
    if (!atoms_)
      source_.refuse(fmt::format("{} is no number of atoms: write a whole number", in_quotes(words_[0])));
  }

  /// `lo hi xlo xhi`, and the same of y and z; `xy xz yz` are the tilts.
  void read_bounds() {
    constexpr std::array<std::string_view, 3> names = {"xlo", "ylo", "zlo"};
    if (words_.size() == 6 && words_[3] == "xy")
      is_tilted_ = !std::all_of(words_.begin(), words_.begin() + 3, is_zero_number);
    if (words_.size() != 4)
      return;
    const auto found = std::find(names.begin(), names.end(), words_[2]);
    if (found == names.end())
      return;
    const auto axis = static_cast<std::size_t>(found - names.begin());
    bounds_[axis] = {std::string(words_[0]), std::string(words_[1])};
  }

  /// The file does not say which sides are periodic.
  void hand_on_box() const {
    if (is_tilted_)
      return source_.leave_out_places();
    for (const std::array<std::string, 2> &of_axis : bounds_)
      if (of_axis[0].empty())
        return;
    source_.set_box(bounds_, {});
  }

  void begin_section(std::string_view comment) {
    if (section_ == Section::atoms)
      check_count();
    section_ = words_.size() == 1 && words_.front() == "Atoms" ? Section::atoms : Section::other;
    if (section_ == Section::other)
      return;
    if (has_atoms_)
      source_.refuse("the section Atoms is there twice: leave one");
    if (!atoms_)
      source_.refuse("the header has no number of atoms: add the line 'N atoms'");
    has_atoms_ = true;
    hand_on_box();
    named_style_ = !comment.empty();
    if (named_style_ && comment != "sphere")
      source_.refuse(fmt::format("atom_style {} has no diameters here: write the file with atom_style sphere",
                                 in_quotes(comment)));
  }

  void read_atom() {
    if (words_.size() != 7 && words_.size() != 10)
      source_.refuse(fmt::format("the line has {} numbers, atom_style sphere has id type diameter density x "
                                 "y z and perhaps 3 image flags: is the file cut off, or of another style?",
                                 words_.size()));
    for (std::size_t i = 0; i < words_.size(); ++i)
      if (i != diameter && !is_number(words_[i]))
        source_.refuse(fmt::format("{} is not a number: write id type diameter density x y z in numbers",
                                   in_quotes(words_[i])));
    if (read_ == *atoms_)
      source_.refuse(
          fmt::format("there are more atoms than the {} of the header: put one of them right", *atoms_));
    source_.take_id(words_.front());
    source_.take_class(words_[1]);
    source_.particle_at({words_[4], words_[5], words_[6]}, words_[diameter]);
    ++read_;
  }

  void check_count() const {
    if (read_ != *atoms_)
      source_.refuse(
          fmt::format("the section Atoms ends after {} of {} atoms: is the file cut off?", read_, *atoms_));
  }

  ParticleSource &source_;
  std::vector<std::string_view> words_;
  Section section_ = Section::header;
  std::optional<std::uint64_t> atoms_;
  std::array<std::array<std::string, 2>, 3> bounds_; ///< of the box; empty where there are none
  std::uint64_t read_ = 0;
  bool has_atoms_ = false;
  bool named_style_ = false;
  bool is_tilted_ = false;
};

} // namespace

std::unique_ptr<LineReader> read_lammps_data(ParticleSource &source) {
  return std::make_unique<LammpsDataReader>(source);
}

} // namespace mdm
