#include "particles/line_reader.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// Legacy VTK in ASCII: three lines of heading, `DATASET`, then keywords with their numbers below them. The
/// sizes are an array named radius or diameter, as `SCALARS radius double [1]` or in a FIELD as `radius 1 n
/// double`; where there are both, they agree. An array id of whole numbers has each once; an array class or
/// type of them has the classes.
class VtkReader : public LineReader {
public:
  explicit VtkReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::diameter, SizeUnit::m);
  }

  void line(std::string_view text) override {
    split_words(text, words_);
    if (source_.line() == 1 && !text.starts_with("# vtk DataFile"))
      source_.refuse("the first line is not '# vtk DataFile Version': is it legacy VTK?");
    if (source_.line() == 3 && (words_.size() != 1 || !are_alike(words_[0], "ascii")))
      source_.refuse("the file is not ASCII: write it as ASCII");
    if (source_.line() <= 3 || words_.empty())
      return;
    if (missing_ > 0) {
      read_values(text);
      return;
    }
    if (block_ != Block::none && is_number(words_.front()))
      refuse_more();
    block_ = Block::none;
    read_keyword();
  }

  void end() override {
    if (missing_ > 0)
      refuse_fewer();
    if (!found_ && cell_array_line_ > 0) {
      source_.set_line(cell_array_line_);
      source_.refuse("the sizes are below CELL_DATA: write one a point, below POINT_DATA");
    }
    if (!found_ && source_.options().size_column)
      source_.refuse("there is no array " + in_quotes(*source_.options().size_column) +
                     " up to here, the end: name one of the points");
    if (!found_)
      source_.refuse("there is no array radius or diameter up to here, the end: add one to the points");
    hand_on();
    source_.check_some();
  }

private:
  std::optional<SizeMeaning> meaning(std::string_view array) const {
    if (const std::optional<std::string> &named = source_.options().size_column)
      return array == *named ? source_.options().meaning : std::nullopt;
    if (are_alike(array, "radius"))
      return SizeMeaning::radius;
    if (are_alike(array, "diameter"))
      return SizeMeaning::diameter;
    return std::nullopt;
  }

  void read_keyword() {
    const std::string_view keyword = words_.front();
    if (are_alike(keyword, "dataset")) {
      if (words_.size() != 2 ||
          !(are_alike(words_[1], "polydata") || are_alike(words_[1], "unstructured_grid")))
        source_.refuse("the data set is not of points: write POLYDATA or UNSTRUCTURED_GRID");
    } else if (are_alike(keyword, "points")) {
      begin_points();
    } else if (are_alike(keyword, "point_data")) {
      begin_point_data();
    } else if (are_alike(keyword, "cell_data")) {
      data_ = Data::of_cells;
    } else if (are_alike(keyword, "scalars")) {
      if (words_.size() >= 3)
        begin_array(words_[1], words_[2], words_.size() == 3 || (words_.size() == 4 && words_[3] == "1"));
    } else if (words_.size() == 4 && parse_count(words_[2])) {
      begin_array(keyword, words_[3], words_[1] == "1", parse_count(words_[2]));
    }
  }

  void begin_points() {
    if (points_)
      source_.refuse("POINTS is there twice: leave one");
    points_ = words_.size() == 3 ? parse_count(words_[1]) : std::nullopt;
    if (!points_)
      source_.refuse("POINTS has no number of points: write 'POINTS n float'");
    block_ = Block::points;
    missing_ = coordinates * *points_;
  }

  void begin_point_data() {
    const std::optional<std::uint64_t> count = words_.size() == 2 ? parse_count(words_[1]) : std::nullopt;
    if (!count)
      source_.refuse("POINT_DATA has no number of values: is the file damaged?");
    if (!points_)
      source_.refuse("there are no POINTS above POINT_DATA: is the file damaged?");
    if (count != points_)
      source_.refuse(fmt::format("POINT_DATA has {} values, there are {} points: put one of them right",
                                 *count, *points_));
    data_ = Data::of_points;
  }

  /// \param values  that the array is said to have
  void begin_array(std::string_view array, std::string_view type, bool is_single,
                   std::optional<std::uint64_t> values = std::nullopt) {
    const std::optional<SizeMeaning> of_sizes = meaning(array);
    // Printed floats may be too short to tell ids apart.
    const bool has_whole_numbers =
        !are_alike(type, "float") && !are_alike(type, "double") && data_ == Data::of_points && is_single;
    const bool is_id = are_alike(array, "id") && has_whole_numbers;
    // A class is what mdm export calls it; a type may be another number.
    const bool is_class =
        (are_alike(array, "class") || (are_alike(array, "type") && !has_named_classes_)) && has_whole_numbers;
    if (!of_sizes && !is_id && !is_class)
      return;
    if (data_ == Data::of_cells) {
      cell_array_line_ = source_.line();
      return;
    }
    if (data_ == Data::none)
      source_.refuse("the array is not below POINT_DATA: is the file damaged?");
    if (!is_single)
      source_.refuse("the array has several values a point: write one");
    if (values && values != points_)
      source_.refuse(fmt::format("the array has {} values, there are {} points: is the file damaged?",
                                 *values, *points_));
    missing_ = *points_;
    if (of_sizes)
      begin_sizes(*of_sizes);
    else if (is_id)
      begin_ids();
    else
      begin_classes(are_alike(array, "class"));
  }

  void begin_sizes(SizeMeaning meaning) {
    if (found_ == meaning)
      source_.refuse("there are several arrays of that name: leave one");
    if (found_ && source_.options().meaning)
      source_.refuse(fmt::format("there are arrays radius and diameter, of which {} and {} choose none: "
                                 "leave one out",
                                 option("radius"), option("diameter")));
    block_ = found_ ? Block::other_sizes : Block::sizes;
    if (found_)
      return;
    source_.set_defaults(meaning, SizeUnit::m);
    found_ = meaning;
  }

  void begin_ids() {
    if (has_ids_)
      source_.refuse("there are several arrays of that name: leave one");
    has_ids_ = true;
    block_ = Block::ids;
  }

  void begin_classes(bool are_named) {
    if (!classes_.empty() && are_named == has_named_classes_)
      source_.refuse("there are several arrays of that name: leave one");
    classes_.clear();
    has_named_classes_ = are_named;
    block_ = Block::classes;
  }

  void read_values(std::string_view text) {
    if (block_ != Block::points && are_alike(words_.front(), "lookup_table") && missing_ == *points_)
      return;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) {
      if (missing_ == 0)
        refuse_more();
      if (block_ == Block::sizes)
        sizes_.push_back({std::string(word), source_.line()});
      else if (block_ == Block::other_sizes)
        compare_size(word);
      else if (block_ == Block::ids)
        source_.take_id(word);
      else if (block_ == Block::classes)
        classes_.emplace_back(word);
      else if (!is_number(word))
        source_.refuse(fmt::format("{} is not a number, but there are {} of {} coordinates: is the file cut "
                                   "off?",
                                   in_quotes(word), coordinates * *points_ - missing_,
                                   coordinates * *points_));
      else if (source_.wants_places())
        places_.emplace_back(word);
      --missing_;
    }
  }

  void compare_size(std::string_view word) const {
    const std::string &before = sizes_[static_cast<std::size_t>(*points_ - missing_)].text;
    if (found_ == SizeMeaning::radius)
      source_.check_agree(before, word);
    else
      source_.check_agree(word, before);
  }

  /// At the end, because any array may be the last.
  void hand_on() {
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
      source_.set_line(sizes_[i].line);
      if (!classes_.empty())
        source_.take_class(classes_[i]);
      if (places_.empty())
        source_.particle(sizes_[i].text);
      else
        source_.particle_at({places_[3 * i], places_[3 * i + 1], places_[3 * i + 2]}, sizes_[i].text);
    }
  }

  [[noreturn]] void refuse_more() const {
    source_.refuse(
        block_ != Block::points
            ? fmt::format("there are more than the {} values of the array: is the file damaged?", *points_)
            : fmt::format("there are more than the {} coordinates of {} points: is the file "
                          "damaged?",
                          coordinates * *points_, *points_));
  }

  [[noreturn]] void refuse_fewer() const {
    const std::uint64_t all = block_ != Block::points ? *points_ : coordinates * *points_;
    source_.refuse(fmt::format("the {} end after {} of {}: is the file cut off?",
                               block_ != Block::points ? "values of the array" : "coordinates",
                               all - missing_, all));
  }

  static constexpr std::uint64_t coordinates = 3; ///< of a point
  enum class Block { none, points, sizes, other_sizes, ids, classes };
  /// A size as the array has it, and the line.
  struct Size {
    std::string text;
    std::uint64_t line;
  };
  enum class Data { none, of_points, of_cells };

  ParticleSource &source_;
  std::vector<std::string_view> words_;
  std::optional<std::uint64_t> points_;
  Block block_ = Block::none; ///< the numbers that are read, or end above this line
  std::uint64_t missing_ = 0; ///< numbers that the block still lacks
  Data data_ = Data::none;
  std::vector<std::string> places_; ///< coordinates, where they are wanted
  std::vector<Size> sizes_;
  std::vector<std::string> classes_; ///< where there is an array of them
  std::optional<SizeMeaning> found_; ///< of the array of sizes
  bool has_ids_ = false, has_named_classes_ = false;
  std::uint64_t cell_array_line_ = 0; ///< of sizes that are not of points; 0 if there are none
};

} // namespace

std::unique_ptr<LineReader> read_vtk(ParticleSource &source) {
  return std::make_unique<VtkReader>(source);
}

} // namespace mdm
