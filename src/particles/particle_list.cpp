#include "particles/comment_words.hpp"
#include "particles/line_reader.hpp"
#include "particles/particle_columns.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

/// Lines of words, # comments between them.
class ListReader : public LineReader {
public:
  explicit ListReader(ParticleSource &source) : source_(source) {}

  void line(std::string_view text) override {
    split_words(text, words_);
    if (words_.empty())
      return;
    if (words_.front().front() == '#')
      comment(words_behind_hash(trimmed(text)));
    else
      row();
  }

  void end() override { source_.check_some(); }

protected:
  virtual void row() = 0;
  /// \param words  behind the #, those of words_
  virtual void comment(const std::vector<std::string> &words) = 0;

  /// A comment that names another unit than that of the sizes is not passed over, unless the user gave it.
  void check_unit() const {
    if (!source_.unit() || source_.options().unit)
      return;
    for (const SizeUnit unit : units_in_comment(words_))
      if (unit != *source_.unit())
        source_.refuse(fmt::format("the comment names {}, and sizes are taken in {}: say which it is with {}",
                                   name(unit), name(*source_.unit()), option(source_.options().unit_option)));
  }

  ParticleSource &source_;
  std::vector<std::string_view> words_;
};

class DiametersReader : public ListReader {
public:
  using ListReader::ListReader;

  void end() override {
    if (is_count_of_others())
      source_.refuse(
          fmt::format("{} is the number of the lines below it, and may be no size: leave it out, or "
                      "write it as {}.0",
                      first_, first_));
    ListReader::end();
  }

private:
  void comment(const std::vector<std::string> &words) override {
    if (words.size() == 1 && has_particle_column(words))
      source_.refuse(
          fmt::format("the comment names a column, {}: write the name without #", in_quotes(words.front())));
    check_unit();
  }

  bool is_count_of_others() const {
    const std::optional<std::uint64_t> count = parse_count(first_);
    return count && rows_ > 2 && *count + 1 == rows_;
  }

  void row() override {
    if (rows_++ == 0)
      first_ = words_.front();
    if (words_.size() != 1)
      source_.refuse("the line is not one number: write a size alone, or give " + option("from"));
    if (!is_number(words_.front()))
      source_.refuse(
          fmt::format("{} is not a number: write a diameter in each line, below a header diameter_mm "
                      "(or um, m, in; radius_mm for radii) if there is to be one",
                      in_quotes(words_.front())));
    source_.particle(words_.front());
  }

  std::string first_;
  std::uint64_t rows_ = 0;
};

class XyzrReader : public ListReader {
public:
  explicit XyzrReader(ParticleSource &source) : ListReader(source) {
    source.set_defaults(SizeMeaning::radius, source.options().target);
  }

private:
  static constexpr std::size_t radius = 3;

  /// Models of mdm say so what their numbers are: `# x y z r in m; box 1 2 3`, or `...; box 1 2 3, repeated
  /// in x y z`.
  void comment(const std::vector<std::string> &words) override {
    const std::vector<std::string> ours = {"x", "y", "z", "r", "in"};
    if (words.size() > ours.size() && std::equal(ours.begin(), ours.end(), words.begin()))
      take_heading(words);
    else
      check_unit();
    check_columns(words);
  }

  void take_heading(const std::vector<std::string> &words) {
    constexpr std::size_t unit = 5, box = 7; // behind `x y z r in`
    const std::optional<SizeUnit> stated = unit_in_word(words[unit]);
    if (!stated)
      source_.refuse(fmt::format("{} is no unit of lengths that is known: write mm, um, m or in",
                                 in_quotes(words[unit])));
    source_.take_unit({name(*stated), in_mm(*stated)}, fmt::format("{} in its heading", name(*stated)));
    if (words.size() >= box + 3 && words[unit + 1] == "box")
      set_box({words[box], words[box + 1], words[box + 2]},
              words.size() > box + 3 && words[box + 3] == "repeated");
  }

  /// The columns that a heading names are x y z r at first. YADE's export.textExt has one, `#format
  /// x_y_z_r_matId`.
  void check_columns(const std::vector<std::string> &words) {
    const auto has = [&words](std::string_view word) {
      return std::find(words.begin(), words.end(), word) != words.end();
    };
    const bool is_of_yade = words_[0] == "#format" && words_.size() >= 2;
    const bool begins_with_place = words.size() > 1 && words[0] == "x" && words[1] == "y";
    const bool are_columns = has("x") && has("y") && has("z") && has_particle_column(words);
    if (!is_of_yade && !begins_with_place && !are_columns)
      return;
    const bool is_right =
        is_of_yade ? words_[1].starts_with("x_y_z_r")
                   : begins_with_place && words.size() > radius && words[2] == "z" && is_size(words[radius]);
    if (!is_right)
      source_.refuse(
          fmt::format("the columns are {}: write x y z r first, or commas between the names and the "
                      "numbers, without #",
                      in_quotes(is_of_yade ? words_[1] : fmt::format("{}", fmt::join(words, " ")))));
    has_heading_ = true;
  }

  bool is_size(std::string_view name) const {
    const bool are_diameters = source_.options().meaning == SizeMeaning::diameter;
    return name == "r" || name == "rad" || name.starts_with("radius") ||
           (are_diameters && (name == "d" || name.starts_with("diameter")));
  }

  void row() override {
    if (width_ == 0)
      begin();
    if (width_ <= radius)
      source_.refuse("the line has fewer than four numbers: write x y z r");
    if (words_.size() != width_)
      source_.refuse(fmt::format("the line has {} numbers, the first has {}: is the file cut off?",
                                 words_.size(), width_));
    for (std::size_t i = 0; i < radius; ++i)
      if (!is_number(words_[i]))
        source_.refuse(
            fmt::format("{} is not a number: write x y z r in each line, and # before lines of words",
                        in_quotes(words_[i])));
    source_.particle_at({words_[0], words_[1], words_[2]}, words_[radius]);
  }

  void begin() {
    width_ = words_.size();
    if (width_ > radius + 1 && !has_heading_)
      source_.note(
          fmt::format("The lines have {} numbers; the first four were taken as x y z r, and the others "
                      "passed over.",
                      width_));
  }

  /// A box from 0 on with these sides; repeated on all sides, or on none.
  void set_box(const std::array<std::string_view, 3> &sides, bool is_repeated) {
    std::array<std::array<std::string, 2>, 3> bounds;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::string_view side = sides[axis];
      side.remove_suffix(side.ends_with(',') || side.ends_with(';') ? 1 : 0);
      bounds[axis] = {"0", std::string(side)};
    }
    source_.set_box(bounds, {is_repeated, is_repeated, is_repeated});
  }

  std::size_t width_ = 0;
  bool has_heading_ = false; ///< that names the columns
};

} // namespace

std::unique_ptr<LineReader> read_diameters(ParticleSource &source) {
  return std::make_unique<DiametersReader>(source);
}

std::unique_ptr<LineReader> read_xyzr(ParticleSource &source) {
  return std::make_unique<XyzrReader>(source);
}

} // namespace mdm
