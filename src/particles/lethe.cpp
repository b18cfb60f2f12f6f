#include "particles/line_reader.hpp"
#include "particles/particle_writer.hpp"
#include "text/lines.hpp"
#include "text/long_text.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// A file of Lethe's insertion method `file`: names of columns, `p_x; p_y; p_z; ...; diameters; ...`, and a
/// line of numbers a particle, each with a semicolon behind it.
class LetheReader : public LineReader {
public:
  explicit LetheReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::diameter, SizeUnit::m);
  }

  void line(std::string_view text) override {
    if (trimmed(text).empty())
      return;
    split(trimmed(text));
    if (width_ == 0) {
      read_names();
      return;
    }
    const bool is_ended = trimmed(text).ends_with(';');
    if (is_ended != are_ended_.value_or(is_ended))
      source_.refuse(
          "the line does not end as the first one, with a semicolon or without: is the file cut off?");
    are_ended_ = is_ended;
    read_particle();
  }

  void end() override { source_.check_some(); }

private:
  static constexpr std::array<std::string_view, 4> names = {"p_x", "p_y", "p_z", "diameters"};

  void split(std::string_view text) {
    fields_.clear();
    while (!text.empty() && fields_.size() <= max_fields) {
      const std::size_t end = std::min(text.find(';'), text.size());
      fields_.push_back(trimmed(text.substr(0, end)));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

  void read_names() {
    const std::vector<std::string> all(fields_.begin(), fields_.end());
    for (std::size_t i = 0; i < names.size(); ++i)
      columns_[i] = source_.column(all, names[i], "p_x; p_y; p_z; ... diameters;");
    width_ = fields_.size();
  }

  void read_particle() {
    if (fields_.size() != width_)
      source_.refuse(fmt::format("the line has {} values, there are {} columns: is the file cut off?",
                                 fields_.size(), width_));
    for (const std::string_view field : fields_)
      source_.check_number(field);
    source_.particle_at({fields_[columns_[0]], fields_[columns_[1]], fields_[columns_[2]]},
                        fields_[columns_[3]]);
  }

  ParticleSource &source_;
  std::vector<std::string_view> fields_;
  std::array<std::size_t, 4> columns_{};
  std::size_t width_ = 0;         ///< 0 above the names
  std::optional<bool> are_ended_; ///< the last number of a line has a semicolon behind it too
};

} // namespace

std::unique_ptr<LineReader> read_lethe(ParticleSource &source) {
  return std::make_unique<LetheReader>(source);
}

void write_lethe(const Placement &start, const Sink &out) {
  LongText text(out);
  text.add("p_x; p_y; p_z; v_x; v_y; v_z; w_x; w_y; w_z; diameters;\n");
  start.each([&](const Placement::Sphere &s) {
    text.add("{}; {}; {}; 0; 0; 0; 0; 0; 0; {};\n", start.text(s.at[0]), start.text(s.at[1]),
             start.text(s.at[2]), s.size->diameter.text);
  });
  text.finish();
}

} // namespace mdm
