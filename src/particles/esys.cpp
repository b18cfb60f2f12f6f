#include "particles/line_reader.hpp"
#include "particles/particle_writer.hpp"
#include "text/long_text.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// ESyS-Particle. A geometry begins with LSMGeometry; below BeginParticles and Simple are the number of
/// particles and a line `x y z r id tag` for each. A snapshot begins with that number, and its lines go on:
/// `x y z r id tag mass ...`; what is below them, of contacts, is passed over.
class EsysReader : public LineReader {
public:
  explicit EsysReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::radius, SizeUnit::m);
  }

  void line(std::string_view text) override {
    split_words(text, words_);
    if (source_.line() == 1)
      begin();
    else if (words_.empty() || part_ == Part::rest)
      return;
    else if (part_ == Part::head)
      read_head();
    else if (part_ == Part::count)
      read_count();
    else if (read_ < particles_)
      read_particle();
    else
      read_end();
  }

  void end() override {
    if (part_ == Part::head || part_ == Part::count)
      source_.refuse("the file ends above its particles: is it cut off?");
    if (read_ != particles_)
      source_.refuse(
          fmt::format("the file ends after {} of {} particles: is it cut off?", read_, particles_));
    if (is_geometry_ && part_ != Part::rest)
      source_.refuse("the file ends without EndParticles: is it cut off?");
    source_.check_some();
  }

private:
  enum class Part { head, count, particles, rest };
  static constexpr std::size_t columns_of_geometry = 6, least_of_snapshot = 7;

  void begin() {
    is_geometry_ = !words_.empty() && words_.front() == "LSMGeometry";
    if (!is_geometry_)
      read_count();
  }

  void read_head() {
    if (words_.front() == "BoundingBox" && words_.size() == 7) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        bounds_[axis] = {std::string(words_[1 + axis]), std::string(words_[4 + axis])};
    } else if (words_.front() == "PeriodicBoundaries" && words_.size() == 4) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        periodic_[axis] = words_[1 + axis] != "0";
    } else if (words_.front() == "Simple") {
      part_ = Part::count;
      if (!bounds_[0][0].empty())
        source_.set_box(bounds_, periodic_);
    }
  }

  void read_count() {
    const std::optional<std::uint64_t> count =
        words_.size() == 1 ? parse_count(words_.front()) : std::nullopt;
    if (!count)
      source_.refuse(
          "the number of particles is not a whole number: is it a geometry or a snapshot (_1.txt) of "
          "ESyS-Particle?");
    particles_ = *count;
    part_ = Part::particles;
  }

  void read_particle() {
    if (width_ == 0)
      width_ = words_.size();
    const bool is_width = is_geometry_ ? width_ == columns_of_geometry : width_ >= least_of_snapshot;
    if (!is_width || words_.size() != width_)
      source_.refuse(
          fmt::format("the line has {} numbers, and not x y z r id tag{}: is the file cut off, or are "
                      "there fewer than {} particles?",
                      words_.size(), is_geometry_ ? "" : " mass ... as the others", particles_));
    for (const std::string_view word : words_)
      source_.check_number(word);
    source_.take_id(words_[4]);
    source_.take_class(words_[5]);
    source_.particle_at({words_[0], words_[1], words_[2]}, words_[3]);
    ++read_;
  }

  void read_end() {
    if (is_geometry_ && words_.front() != "EndParticles")
      source_.refuse(fmt::format(
          "there are more particles than the {} that the file says: put the number right", particles_));
    if (!is_geometry_ && words_.size() >= least_of_snapshot) // contacts have fewer numbers
      source_.refuse(fmt::format(
          "there are more particles than the {} of the first line: put the number right", particles_));
    part_ = Part::rest;
  }

  ParticleSource &source_;
  std::vector<std::string_view> words_;
  Part part_ = Part::head;
  bool is_geometry_ = false;
  std::array<std::array<std::string, 2>, 3> bounds_;
  std::array<bool, 3> periodic_{};
  std::uint64_t particles_ = 0, read_ = 0;
  std::size_t width_ = 0;
};

} // namespace

std::unique_ptr<LineReader> read_esys(ParticleSource &source) {
  return std::make_unique<EsysReader>(source);
}

void write_esys(const Placement &start, const Sink &out) {
  const ParticleSet &set = start.set();
  const auto &[a, b, height] = start.box();
  const auto [x, y, z] = start.repeated();
  LongText text(out);
  text.add("LSMGeometry 1.2\nBoundingBox 0 0 0 {} {} {}\nPeriodicBoundaries {:d} {:d} {:d}\nDimension 3D\n",
           start.text(a), start.text(b), start.text(height), x, y, z);
  text.add("BeginParticles\nSimple\n{}\n", to_string(set.particles()));
  std::uint64_t id = 0;
  start.each([&](const Placement::Sphere &s) {
    text.add("{} {} {} {} {} {}\n", start.text(s.at[0]), start.text(s.at[1]), start.text(s.at[2]),
             s.size->radius.text, id++, set.classes[s.class_index].number);
  });
  text.add("EndParticles\nBeginConnect\n0\nEndConnect\n");
  text.finish();
}

} // namespace mdm
