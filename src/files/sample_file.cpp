#include "files/sample_file.hpp"

#include "answer/answer_sample.hpp"
#include "answer/generated_reader.hpp"
#include "ask/particle_options.hpp"
#include "files/packing_file.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "particles/gsd.hpp"
#include "particles/sample_sieves.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <fmt/core.h>

#include <atomic>

namespace mdm {
namespace {

/// A set with its sizes; they have a line.
constexpr std::size_t max_set_bytes = std::size_t{1} << 30;

/// Whole lines, as long as the file has no more.
std::string first_bytes(const std::string &path) {
  constexpr std::size_t most = std::size_t{1} << 16;
  const std::string begin = beginning_of_file(path, most);
  return begin.size() < most ? begin + "\n" : begin;
}

void hand_on(const StatedSet &set, const ParticleOptions &options, ParticleSink &sink) {
  if (set.sizes.empty())
    throw InputError("the set has its classes and no sizes: write it with mdm generate --sizes");
  const SizeUnit unit = options.unit.value_or(set.unit ? *set.unit : options.target);
  const Rational factor =
      in_mm(unit) / in_mm(options.target) * (options.meaning == SizeMeaning::radius ? 2 : 1);
  for (const SizeRange &size : set.sizes)
    sink.add(SizeRange{size.lo * factor, size.hi * factor, size.is_open}, 1);
}

/// Counts what it hands on.
class Counting : public ParticleSink {
public:
  explicit Counting(ParticleSink &sink) : sink_(sink) {}
  void restart() override { sink_.restart(); }
  void begin_timestep(const Integer &number) override { sink_.begin_timestep(number); }
  void add(const RootSize &diameter, const Integer &quantity) override {
    sink_.add(diameter, quantity);
    ++count;
  }
  void add(const SizeRange &diameter, const Integer &quantity) override {
    sink_.add(diameter, quantity);
    ++count;
  }
  void add_at(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) override {
    sink_.add_at(place, unit, diameter);
    ++count;
  }
  void set_material(const std::string &name) override { sink_.set_material(name); }
  void set_class(std::uint64_t number) override { sink_.set_class(number); }
  bool wants_places() const override { return sink_.wants_places(); }
  void set_box(const ParticleBox &box) override { sink_.set_box(box); }

  std::atomic<std::uint64_t> count = 0;

private:
  ParticleSink &sink_;
};

} // namespace

bool is_sample(const std::string &content) {
  return is_gsd(content) || is_generated(content) || told_format(content).has_value();
}

bool is_sample_file(const std::string &path) {
  return is_sample(first_bytes(path));
}

bool is_gsd_file(const std::string &path) {
  return is_gsd(beginning_of_file(path, sizeof(std::uint64_t)));
}

bool is_generated_file(const std::string &path) {
  return is_generated(first_bytes(path));
}

bool is_answer_file(const std::string &path) {
  const std::string begin = first_bytes(path);
  return path == "-" || (trimmed(without_byte_order_mark(begin)).starts_with('{') && !is_generated(begin));
}

void refuse_long(const std::string &where, const char *what) {
  throw file_error(
      where, FileLines::too_long(what) +
                 ", which is not read: of a spread so large (1.5 million particles) "
                 "verify what mdm export --spread --to csv writes, with the options and --seed of solve");
}

ReadParticles read_lines(std::vector<FileLines::Line> first, FileLines &rest, const std::string &path,
                         const ParticleOptions &options, ParticleSink &sink, bool quiet) {
  Counting counting(sink);
  const ProgressLine progress([&counting] { return fmt::format("{} sizes read", counting.count.load()); },
                              quiet);
  ParticleReader reader(shown_name(path), counting, options);
  std::uint64_t number = 0;
  for (; !first.empty(); first = rest.next(lines_at_once))
    for (const FileLines::Line &line : first) {
      ++number;
      if (!line)
        refuse_long(line_name(path, number), "the line");
      reader.line(*line);
    }
  reader.end();
  return {reader.notes(), reader.unit()};
}

ReadParticles read_gsd_file(const std::string &path, const ParticleOptions &options, ParticleSink &sink) {
  return read_gsd(read_file(path, max_set_bytes), shown_name(path), sink, options);
}

std::vector<std::string> read_sample_file(const std::string &path, const ParticleOptions &options,
                                          ParticleSink &sink, bool quiet) {
  if (is_packing_file(path))
    throw file_error(
        path,
        "it is a packing: mdm export " + shell_word(path) +
            " --to csv -o DISCS.csv writes its discs, which are judged by mdm verify GRADATION DISCS.csv " +
            option("size-column") + " radius " + option("radius") + " " + option("law") +
            " power:2; where they have a unit, the column is radius_m or the like");
  if (!options.format && is_generated_file(path)) {
    const StatedSet set = read_generated(read_file(path, max_set_bytes), shown_name(path));
    in_file(path, [&] { hand_on(set, options, sink); });
    return {};
  }
  if (options.format ? options.format == ParticleFormat::gsd : is_gsd_file(path))
    return read_gsd_file(path, options, sink).notes;
  FileLines lines(path);
  return read_lines(lines.next(lines_at_once), lines, path, options, sink, quiet).notes;
}

void refuse_sample(const std::string &path) {
  if (is_sample_file(path))
    throw file_error(path, "it holds particles, no gradation: mdm convert " + shell_word(path) +
                               " -o GRADATION.csv writes the one that they have");
}

namespace {

/// That of its particles.
Gradation curve_of_set(const StatedSet &set) {
  SampleSieves sieves;
  for (const SizeRange &size : set.sizes)
    sieves.add(size, 1);
  std::vector<std::string> notes;
  if (!set.unit)
    notes.emplace_back("the set names no unit: its sizes were taken as mm");
  return sieves.gradation(set.id, set.unit.value_or(SizeUnit::mm), notes, SampleClasses::at_sizes);
}

UnderstoodGradation read_any(const std::string &path, const ReadingTexts &reading, bool quiet, PhiReading phi,
                             SampleClasses classes) {
  const std::string begin = first_bytes(path);
  if (is_generated(begin)) {
    const StatedSet set = read_generated(read_file(path, max_set_bytes), shown_name(path));
    const bool has_spheres = !set.sizes.empty() && set.dimension == 3;
    return {classes == SampleClasses::at_sizes && has_spheres
                ? curve_of_set(set)
                : in_file(path, [&set] { return set_gradation(set); }),
            "set of mdm generate",
            "bounds of classes",
            "volume fractions",
            {},
            false};
  }
  if (is_answer(begin) && !reading.is_given()) {
    const std::string content = read_file(path, max_set_bytes);
    return {classes == SampleClasses::at_sizes ? answer_curve(content, shown_name(path))
                                               : answer_gradation(content, shown_name(path), phi),
            "answer of mdm solve",
            "bounds of classes",
            "masses of the particles",
            {},
            false};
  }
  if (reading.is_unit_at_most() && (is_gsd(begin) || told_format(begin))) {
    SampleSieves sieves;
    const std::vector<std::string> notes =
        read_sample_file(path, read_as_gradation(reading.unit), sieves, quiet);
    return {sieves.gradation(stem(path), SizeUnit::mm, notes, classes),
            "file of particles",
            "those of the particles",
            "x^3 times their number",
            {},
            false};
  }
  return understand_gradation(read_file(path, max_gradation_bytes), shown_name(path), reading.reading(phi));
}

} // namespace

UnderstoodGradation any_gradation(const std::string &path, const ReadingTexts &reading, bool quiet,
                                  PhiReading phi) {
  return read_any(path, reading, quiet, phi, SampleClasses::between_sizes);
}

UnderstoodGradation any_curve(const std::string &path, const ReadingTexts &reading, bool quiet) {
  return read_any(path, reading, quiet, PhiReading::exact, SampleClasses::at_sizes);
}

} // namespace mdm
