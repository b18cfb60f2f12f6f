#include "particles/line_reader.hpp"
#include "particles/particle_writer.hpp"
#include "text/lines.hpp"
#include "text/long_text.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

constexpr std::string_view diameter_heading = "// diameter ", count_word = "maxNumberOfParticles";

/// The particlesDict that mdm export writes: a selector for each size, from `// diameter D` to `begin B; end
/// E;`.
class PhasicFlowReader : public LineReader {
public:
  explicit PhasicFlowReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::diameter, SizeUnit::m);
  }

  void line(std::string_view text) override {
    const std::string_view row = trimmed(text);
    if (row.starts_with(diameter_heading))
      begin(row.substr(diameter_heading.size()));
    else if (row.starts_with("stridedRangeInfo"))
      read_range(row);
    else if (row.starts_with(count_word))
      most_ = number(trimmed(row.substr(count_word.size())));
  }

  void end() override {
    if (!size_.empty())
      refuse_without_range();
    source_.check_some();
    if (most_ != none && most_ != next_)
      source_.refuse(
          fmt::format("{} is {}, and the ranges have {}: is the file cut off? else make the two the same",
                      count_word, most_, next_));
  }

private:
  void begin(std::string_view size) {
    if (!size_.empty())
      refuse_without_range();
    size_ = size;
  }

  [[noreturn]] void refuse_without_range() const {
    source_.refuse(
        fmt::format("the range of diameter {} is missing: is the file cut off?", in_quotes(size_)));
  }

  void read_range(std::string_view row) {
    split_words(row, words_);
    // stridedRangeInfo { begin B; end E; stride 1; }
    const bool is_range =
        words_.size() == 9 && words_[2] == "begin" && words_[4] == "end" && words_[7] == "1;";
    const std::uint64_t from = is_range ? number(words_[3]) : none;
    const std::uint64_t to = is_range ? number(words_[5]) : none;
    if (size_.empty() || from != next_ || to <= from || to == none)
      source_.refuse(
          fmt::format("the range is not one from {} on, of a diameter above it: is the file one that "
                      "mdm export wrote?",
                      next_));
    source_.particle(size_, Integer(to - from));
    next_ = to;
    size_.clear();
  }

  static constexpr std::uint64_t none = UINT64_MAX;

  /// Of a word `N;`, or none.
  static std::uint64_t number(std::string_view word) {
    return word.ends_with(';') ? parse_count(word.substr(0, word.size() - 1)).value_or(none) : none;
  }

  ParticleSource &source_;
  std::vector<std::string_view> words_;
  std::string size_;                     ///< whose range is to come
  std::uint64_t next_ = 0, most_ = none; ///< particles so far, and in all
};

std::string head(const std::string &name, const ParticleSet &set) {
  return fmt::format("// {}\n// {}\nobjectName {};\nobjectType dictionary;\nfileFormat ASCII;\n\n",
                     title(set), mass_statement(set), name);
}

/// Runs of particles of one size, in the order of the start.
template <class Take>
void each_size(const Placement &start, Take take) {
  const ParticleSize *last = nullptr;
  std::uint64_t from = 0, at = 0;
  start.each([&](const Placement::Sphere &s) {
    if (last != nullptr && s.size != last) {
      take(*last, from, at);
      from = at;
    }
    last = s.size;
    ++at;
  });
  take(*last, from, at);
}

} // namespace

std::unique_ptr<LineReader> read_phasicflow(ParticleSource &source) {
  return std::make_unique<PhasicFlowReader>(source);
}

void write_phasicflow(const Placement &start, const Sink &out) {
  LongText text(out);
  text.add("{}", head("particlesDict", start.set()));
  // Sorted, ranges would not be those of sizes.
  text.add(
      "positionParticles\n{{\n  method file;\n  mortonSorting No;\n  maxNumberOfParticles {};\n"
      "  regionType domain;\n  fileInfo\n  {{\n    name positions;\n    commaSeparated No;\n  }}\n}}\n\n",
      to_string(start.set().particles()));
  text.add(
      "setFields\n{{\n  defaultValue\n  {{\n    velocity realx3 (0 0 0);\n    acceleration realx3 (0 0 0);\n"
      "    rVelocity realx3 (0 0 0);\n    shapeName word size1;\n  }}\n  selectors\n  {{\n");
  std::size_t number = 0;
  each_size(start, [&](const ParticleSize &size, std::uint64_t from, std::uint64_t to) {
    ++number;
    text.add("    {}{}\n    selector{}\n    {{\n      selector stridedRange;\n"
             "      stridedRangeInfo {{ begin {}; end {}; stride 1; }}\n"
             "      fieldValue {{ shapeName word size{}; }}\n    }}\n",
             diameter_heading, size.diameter.text, number, from, to, number);
  });
  text.add("  }}\n}}\n");
  text.finish();
}

void write_phasicflow_shapes(const Placement &start, const Sink &out) {
  LongText text(out);
  text.add("{}names (", head("shapes", start.set()));
  std::size_t number = 0;
  each_size(start,
            [&](const ParticleSize &, std::uint64_t, std::uint64_t) { text.add(" size{}", ++number); });
  text.add(" );\ndiameters (");
  each_size(start, [&](const ParticleSize &size, std::uint64_t, std::uint64_t) {
    text.add(" {}", size.diameter.text);
  });
  text.add(" );\nmaterials (");
  each_size(start, [&](const ParticleSize &, std::uint64_t, std::uint64_t) { text.add(" grains"); });
  text.add(" );\n");
  text.finish();
}

void write_phasicflow_positions(const Placement &start, const Sink &out) {
  LongText text(out);
  start.each([&](const Placement::Sphere &s) {
    text.add("{} {} {}\n", start.text(s.at[0]), start.text(s.at[1]), start.text(s.at[2]));
  });
  text.finish();
}

} // namespace mdm
