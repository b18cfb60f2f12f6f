#include "line_reader.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// Legacy VTK in ASCII: three lines of heading, `DATASET`, then keywords with their numbers below them. The
/// sizes are the first array named radius or diameter, as `SCALARS radius double [1]` or in a FIELD as
/// `radius 1 n double`.
class VtkReader : public LineReader {
public:
  explicit VtkReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::diameter, LengthUnit::m);
  }

  void line(std::string_view text) override {
    split_words(text, words_);
    if (source_.line() == 1 && !text.starts_with("# vtk DataFile"))
      source_.refuse("the first line is not '# vtk DataFile Version': is it legacy VTK?");
    if (source_.line() == 3 && (words_.size() != 1 || !is(words_[0], "ascii")))
      source_.refuse("the file is not ASCII: write it as ASCII");
    if (source_.line() <= 3 || words_.empty())
      return;
    if (missing_ > 0)
      read_values(text);
    else
      read_keyword();
  }

  void end() override {
    if (!found_)
      source_.refuse("there is no array radius or diameter up to here, the end: add one to the points");
    if (missing_ > 0)
      source_.refuse(fmt::format("the array ends after {} of {} values: is the file cut off?",
                                 *count_ - missing_, *count_));
    source_.check_some();
  }

private:
  /// The same word; keywords may be in either case.
  static bool is(std::string_view word, std::string_view keyword) {
    return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                      [](char a, char b) { return lower(a) == b; });
  }

  static std::optional<SizeMeaning> meaning(std::string_view array) {
    if (is(array, "radius"))
      return SizeMeaning::radius;
    if (is(array, "diameter"))
      return SizeMeaning::diameter;
    return std::nullopt;
  }

  void read_keyword() {
    const std::string_view keyword = words_.front();
    if (is(keyword, "dataset")) {
      if (words_.size() != 2 || !(is(words_[1], "polydata") || is(words_[1], "unstructured_grid")))
        source_.refuse("the data set is not of points: write POLYDATA or UNSTRUCTURED_GRID");
    } else if (is(keyword, "point_data") || is(keyword, "cell_data")) {
      count_ = words_.size() == 2 ? parse_count(words_[1]) : std::nullopt;
      if (!count_)
        source_.refuse(fmt::format("{} has no number of values: is the file damaged?", in_quotes(keyword)));
    } else if (!found_ && is(keyword, "scalars")) {
      if (words_.size() >= 3 && meaning(words_[1]))
        begin_array(*meaning(words_[1]), words_.size() == 3 || (words_.size() == 4 && words_[3] == "1"));
    } else if (!found_ && words_.size() == 4 && meaning(keyword) && parse_count(words_[2])) {
      count_ = parse_count(words_[2]);
      begin_array(*meaning(keyword), words_[1] == "1");
    }
  }

  void begin_array(SizeMeaning meaning, bool is_single) {
    if (!count_)
      source_.refuse("the array is not below POINT_DATA: is the file damaged?");
    if (!is_single)
      source_.refuse("the array has several values a point: write one");
    source_.set_defaults(meaning, LengthUnit::m);
    found_ = true;
    missing_ = *count_;
  }

  void read_values(std::string_view text) {
    if (is(words_.front(), "lookup_table") && missing_ == *count_)
      return;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) {
      if (missing_ == 0)
        source_.refuse(
            fmt::format("there are more than the {} values of the array: is the file damaged?", *count_));
      source_.particle(word);
      --missing_;
    }
  }

  ParticleSource &source_;
  std::vector<std::string_view> words_;
  std::optional<std::uint64_t> count_; ///< of the values of each array
  bool found_ = false;
  std::uint64_t missing_ = 0; ///< values that the array still lacks
};

} // namespace

std::unique_ptr<LineReader> read_vtk(ParticleSource &source) {
  return std::make_unique<VtkReader>(source);
}

} // namespace mdm
