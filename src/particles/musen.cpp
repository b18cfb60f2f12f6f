#include "particles/line_reader.hpp"
#include "particles/particle_writer.hpp"
#include "text/long_text.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// A number of MUSEN's text, and how many words follow it.
struct MusenKey {
  std::uint64_t number;
  std::size_t words;
};

constexpr std::uint64_t musen_time = 2, musen_place = 12, musen_material = 23, musen_activity = 24;

/// The material of a class is called so, with its number behind.
constexpr std::string_view musen_class = "class_";

/// The others that a sphere has behind its geometry.
constexpr std::array<MusenKey, 10> musen_passed_over = {{{10, 3},   // acceleration
                                                         {11, 3},   // angular acceleration
                                                         {15, 3},   // velocity
                                                         {16, 3},   // angular velocity
                                                         {17, 3},   // angles
                                                         {18, 1},   // magnitude of the force
                                                         {20, 3},   // force
                                                         {31, 4},   // quaternion
                                                         {36, 9},   // stress tensor
                                                         {37, 1}}}; // temperature

/// A scene of MUSEN as text. A line that begins with 0 is an object: `0 ID 1 TYPE 5 GEOMETRY ...`, behind it
/// numbers that each say what follows, for all its times. Spheres have type 1 and the geometry `radius
/// contact_radius`; of their times the last counts, if they are active then. A material `class_3`, as mdm
/// export writes it, says the class. Other objects and lines are passed over.
class MusenReader : public LineReader {
public:
  explicit MusenReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::radius, SizeUnit::m);
  }

  void line(std::string_view text) override {
    rest_ = text;
    if (take_word(rest_) != "0")
      return;
    const std::string_view id = take_number();
    expect("1");
    const bool is_sphere = take_count("the type of an object") == 1;
    expect("5");
    if (!is_sphere)
      return;
    source_.take_id(id);
    read_sphere();
  }

  void end() override { source_.check_some(); }

private:
  std::string_view take() {
    const std::string_view word = take_word(rest_);
    if (word.empty())
      source_.refuse("the line ends inside an object: is the file cut off?");
    return word;
  }

  std::string_view take_number() {
    const std::string_view word = take();
    source_.check_number(word);
    return word;
  }

  std::uint64_t take_count(const char *what) {
    const std::string_view word = take();
    const std::optional<std::uint64_t> count = parse_count(word);
    if (!count)
      source_.refuse(fmt::format("{} {} is not a whole number: is the file damaged?", what, in_quotes(word)));
    return *count;
  }

  void expect(std::string_view key) {
    if (const std::string_view word = take(); word != key)
      source_.refuse(fmt::format("there is {} and not {}: an object begins with 0 ID 1 TYPE 5 GEOMETRY; "
                                 "export them from MUSEN with the text",
                                 in_quotes(word), key));
  }

  void pass_over(std::uint64_t key) {
    const auto found = std::find_if(musen_passed_over.begin(), musen_passed_over.end(),
                                    [key](const MusenKey &known) { return known.number == key; });
    if (found == musen_passed_over.end())
      source_.refuse(
          fmt::format("{} is no property of a sphere that is known: leave it out of the export", key));
    for (std::size_t i = 0; i < found->words; ++i)
      take();
  }

  void read_sphere() {
    const std::string_view radius = take_number();
    take_number(); // of contacts
    SphereSample::Place place;
    std::string_view material, time, from, to;
    while (rest_.find_first_not_of(" \t") != std::string_view::npos) {
      const std::uint64_t key = take_count("the number of a property");
      if (key == musen_time)
        time = take_number();
      else if (key == musen_place)
        place = {take_number(), take_number(), take_number()};
      else if (key == musen_material)
        material = take();
      else if (key == musen_activity) {
        from = take_number();
        to = take_number();
      } else
        pass_over(key);
    }
    const bool has_both = !time.empty() && !from.empty();
    if (has_both && (number(time) < number(from) || number(time) > number(to)))
      return;
    if (material.starts_with(musen_class))
      source_.take_class(material.substr(musen_class.size()));
    if (place[0].empty())
      source_.particle(radius);
    else
      source_.particle_at(place, radius);
  }

  Rational number(std::string_view text) const {
    try {
      return parse_decimal(text);
    } catch (const InputError &error) {
      source_.refuse(std::string("time ") + error.what());
    }
  }

  ParticleSource &source_;
  std::string_view rest_;
};

} // namespace

std::unique_ptr<LineReader> read_musen(ParticleSource &source) {
  return std::make_unique<MusenReader>(source);
}

void write_musen(const Placement &start, const Sink &out) {
  const ParticleSet &set = start.set();
  const auto &[a, b, height] = start.box();
  LongText text(out);
  std::uint64_t id = 0;
  start.each([&](const Placement::Sphere &s) {
    const std::string &radius = s.size->radius.text;
    text.add("0 {} 1 1 5 {} {} 23 class_{} 24 0 1e+300 2 0 12 {} {} {}\n", id++, radius, radius,
             set.classes[s.class_index].number, start.text(s.at[0]), start.text(s.at[1]),
             start.text(s.at[2]));
  });
  const std::string box = fmt::format("0 0 0 {} {} {}", start.text(a), start.text(b), start.text(height));
  const int periodic = start.sides() == Sides::periodic ? 1 : 0;
  text.add("22 {}\n28 {} {} {} 0 {}\n", box, periodic, periodic, periodic, box);
  for (const ParticleClass &c : set.classes)
    text.add("32 class_{} class_{} 0 {}\n", c.number, c.number, short_decimal(c.density));
  text.finish();
}

} // namespace mdm
