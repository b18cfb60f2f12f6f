#include "particles/line_reader.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

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
      comment();
    else
      row();
  }

  void end() override { source_.check_some(); }

protected:
  virtual void row() = 0;
  virtual void comment() {}

  ParticleSource &source_;
  std::vector<std::string_view> words_;
};

class DiametersReader : public ListReader {
public:
  using ListReader::ListReader;

private:
  void row() override {
    if (words_.size() != 1)
      source_.refuse("the line is not one number: write a size alone, or give " + option("from"));
    if (!is_number(words_.front()))
      source_.refuse(
          fmt::format("{} is not a number: write a diameter in each line, below a header diameter_mm "
                      "(or um, m, in; radius_mm for radii) if there is to be one",
                      in_quotes(words_.front())));
    source_.particle(words_.front());
  }
};

class XyzrReader : public ListReader {
public:
  explicit XyzrReader(ParticleSource &source) : ListReader(source) {
    source.set_defaults(SizeMeaning::radius, source.options().target);
  }

private:
  static constexpr std::size_t radius = 3;

  /// YADE's export.textExt says so what its columns are, and models of mdm: `# x y z r in m; box 1 2 3`, or
  /// `...; box 1 2 3, repeated in x y z`.
  void comment() override {
    constexpr std::string_view ours[] = {"#", "x", "y", "z", "r", "in"};
    constexpr std::size_t unit = std::size(ours), box = unit + 2;
    if (words_.size() > unit && std::equal(std::begin(ours), std::end(ours), words_.begin()) &&
        words_[unit].starts_with('m')) {
      source_.take_unit({"m", 1000}, "m in its first line");
      if (words_.size() >= box + 3 && words_[unit + 1] == "box")
        set_box(words_.size() > box + 3 && words_[box + 3] == "repeated");
    }
    if (words_.size() >= 2 && words_[0] == "#format" && !words_[1].starts_with("x_y_z_r"))
      source_.refuse(fmt::format("the columns are {}: write x y z r first", in_quotes(words_[1])));
  }

  void row() override {
    if (width_ == 0)
      width_ = words_.size();
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

  /// A box from 0 on, whose sides are the words behind `box`; repeated on all sides, or on none.
  void set_box(bool is_repeated) {
    constexpr std::size_t first = 8;
    std::array<std::array<std::string, 2>, 3> bounds;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::string_view side = words_[first + axis];
      side.remove_suffix(side.ends_with(',') || side.ends_with(';') ? 1 : 0);
      bounds[axis] = {"0", std::string(side)};
    }
    source_.set_box(bounds, {is_repeated, is_repeated, is_repeated});
  }

  std::size_t width_ = 0;
};

} // namespace

std::unique_ptr<LineReader> read_diameters(ParticleSource &source) {
  return std::make_unique<DiametersReader>(source);
}

std::unique_ptr<LineReader> read_xyzr(ParticleSource &source) {
  return std::make_unique<XyzrReader>(source);
}

} // namespace mdm
