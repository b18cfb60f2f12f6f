#include "report/verification.hpp"

#include "cli/option_values.hpp"
#include "cli/place_flags.hpp"
#include "gradation/likelier_unit.hpp"
#include "particles/description_sink.hpp"
#include "particles/gsd.hpp"
#include "particles/unasked_texture.hpp"
#include "python/module.hpp"
#include "python/numbers.hpp"
#include "python/question.hpp"
#include "report/allowed_error.hpp"

#include <mdm/answer/answer_sample.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <pybind11/stl.h>

#include <cmath>
#include <memory>

namespace py = pybind11;

namespace mdm::python {
namespace {

using Values = std::map<std::string, std::string>;

AllowedError allowed(const Words &words, const Gradation &g, const Rational &size_factor) {
  std::vector<AskedTolerance> asked;
  for (const std::string &text : words.tolerances)
    asked.push_back(cli::named("tolerance", text, parse_tolerance));
  std::optional<Envelope> band;
  if (const std::string *const text = words.find("band"))
    band = read_envelope(*text, words.values.at("band_name"));
  return allowed_error(g, asked, band, size_factor);
}

/// How a file of particles is read.
ParticleOptions particle_options(const Words &words, SizeUnit target) {
  ParticleOptions options;
  options.target = target;
  options.says_otherwise = "radius, diameter and size_unit say";
  if (const std::string *const format = words.find("from_format")) {
    options.format = parse_particle_format(*format);
    if (!options.format)
      throw InputError("from_format: " + in_quotes(*format) + " is no format: use one of " +
                       particle_format_names());
  }
  if (const std::string *const meaning = words.find("meaning"))
    options.meaning = *meaning == "radius" ? SizeMeaning::radius : SizeMeaning::diameter;
  if (const std::string *const unit = words.find("size_unit"))
    options.unit = cli::length_unit_of("size_unit", *unit);
  if (const std::string *const timestep = words.find("timestep"))
    options.timestep = cli::natural("timestep", *timestep, 0);
  return options;
}

/// A sample that is judged while it comes in. One thread at a time.
class Verifier {
public:
  Verifier(const Gradation &g, const Values &values, const std::vector<std::string> &tolerances)
      : words_{values, tolerances}, question_(question_in(question_of_gradation(words_), g.unit())),
        gradation_(asked_gradation(g, question_)), smallest_(smallest_match(gradation_, question_.law)),
        allowed_(allowed(words_, gradation_, question_.size_factor)),
        options_(particle_options(words_, g.unit())), factor_(factor_of_sizes()), places_(place_flags()),
        sink_(description()),
        placed_(gradation_, sink_, places_.packing ? std::nullopt : std::optional(most_unasked_places)),
        digits_(words_.has("digits") ? cli::digits_of("digits", *words_.find("digits")) : 6) {}

  /// Diameters, or radii, as doubles in a contiguous buffer, each exactly the number that it is.
  void add_doubles(const py::buffer &sizes) {
    const py::buffer_info info = sizes.request();
    if (info.format != py::format_descriptor<double>::format() || info.ndim != 1 ||
        (info.size > 1 && info.strides[0] != static_cast<py::ssize_t>(sizeof(double))))
      throw InputError("a sample is one row of doubles: give an array of float64 with one dimension");
    const auto *const first = static_cast<const double *>(info.ptr);
    const auto n = static_cast<std::size_t>(info.size);
    const py::gil_scoped_release unlocked;
    for (std::size_t i = 0; i < n; ++i) {
      if (!std::isfinite(first[i]))
        refuse("it is not finite");
      add(Rational(first[i]));
    }
  }

  /// The same of decimals or fractions.
  void add_texts(const std::vector<std::string> &sizes) {
    const py::gil_scoped_release unlocked;
    for (const std::string &text : sizes)
      add(rational_of(text));
  }

  /// Lines of a file of particles, as they come; `name` is the file's.
  void add_lines(const std::vector<std::string> &lines, const std::string &name) {
    const py::gil_scoped_release unlocked;
    if (!reader_)
      reader_ = std::make_unique<ParticleReader>(name, placed_, options_);
    for (const std::string &line : lines)
      reader_->line(line);
  }

  /// A file of GSD, whole.
  void add_gsd(const py::bytes &content, const std::string &name) {
    const std::string_view bytes(content);
    const py::gil_scoped_release unlocked;
    const ReadParticles read = read_gsd(bytes, name, placed_, options_);
    notes_ = read.notes;
    unit_ = read.unit;
  }

  /// An answer in JSON.
  void add_answer(const std::string &json, const std::string &name) {
    const py::gil_scoped_release unlocked;
    AnswerDescription described = describe_answer(read_answer(json, name), gradation_, question_.law, snap());
    answer_ = std::move(described.description);
    objections_ = std::move(described.objections);
    notes_ = std::move(described.notes);
  }

  /// The verdict, mdm-verify-1, and the report for people.
  py::tuple result(const std::string &sample) {
    std::string json, text;
    Verdict verdict{};
    {
      const py::gil_scoped_release unlocked;
      const Verification v = verification(sample);
      verdict = v.verdict();
      json = verification_json(v);
      text = verification_text(v);
    }
    const char *const word = verdict == Verdict::match      ? "match"
                             : verdict == Verdict::no_match ? "no match"
                                                            : "undecided";
    return py::make_tuple(word, json, text);
  }

private:
  Rational snap() const {
    const std::string *const text = words_.find("snap");
    return text == nullptr ? Rational(0) : cli::not_negative("snap", *text);
  }

  Description description() const { return Description(gradation_, {question_.law, snap(), 1, 1}); }

  cli::PlaceFlags place_flags() const {
    cli::PlaceFlags flags;
    flags.packing = words_.has("packing");
    for (const auto &[name, value] : {std::pair{"box", &flags.box},
                                      {"specimen", &flags.specimen},
                                      {"periodic", &flags.periodic},
                                      {"contact_gap", &flags.gap},
                                      {"margin", &flags.margin}})
      if (const std::string *const text = words_.find(name))
        *value = *text;
    flags.check();
    return flags;
  }

  /// What the places in a file say; nothing where there are none, or too many to be judged unasked.
  std::optional<SphereTexture> texture(std::vector<std::string> &notes) const {
    if (!reader_ && !unit_)
      return std::nullopt;
    const SphereTextureOptions options = places_.options(placed_.box(), gradation_.unit());
    return places_.packing ? sphere_texture(placed_.sample(), gradation_.classes(), options)
                           : unasked_texture(placed_, gradation_.classes(), options, "packing=True", notes);
  }

  /// From a size as it is given to a diameter in the gradation's unit.
  Rational factor_of_sizes() const {
    const Rational unit = options_.unit ? in_mm(*options_.unit) / in_mm(gradation_.unit()) : Rational(1);
    return options_.meaning == SizeMeaning::radius ? Rational(unit * 2) : unit;
  }

  void add(const Rational &size) {
    if (size <= 0)
      refuse("it is not above 0");
    ++count_;
    sink_.add(RootSize{factor_ == 1 ? size : Rational(size * factor_)}, 1);
  }

  [[noreturn]] void refuse(const char *what) const {
    throw InputError("particle " + std::to_string(count_ + 1) + " of the sample: its size is wrong: " + what);
  }

  Verification verification(const std::string &sample) {
    if (reader_)
      reader_->end();
    Verification v(answer_ ? *answer_ : sink_.description(), question_, allowed_.most);
    v.bounds = allowed_.bounds;
    v.within = allowed_.within;
    v.smallest = smallest_;
    v.sample = sample;
    v.digits = digits_;
    v.objections = objections_;
    v.notes = gradation_.notes();
    v.notes.insert(v.notes.end(), notes_.begin(), notes_.end());
    v.packing = texture(v.notes);
    add_unit_note(v);
    if (v.description.hair_above() > 0)
      v.notes.push_back(
          "Particles larger than a sieve by less than 1e-12 of it: " + to_string(v.description.hair_above()) +
          "; snap=\"1e-12\" takes sizes as near as that as the sieve.");
    if (reader_)
      for (const std::string &note : reader_->notes())
        v.notes.push_back(note);
    return v;
  }

  /// Says where the sizes may have another unit.
  void add_unit_note(Verification &v) const {
    if (answer_)
      return;
    const LengthUnit unit = reader_ ? reader_->unit()
                            : unit_ ? *unit_
                                    : options_.unit.value_or(length_unit(gradation_.unit()));
    if (const std::optional<LengthUnit> other = likelier_unit(v.description, unit))
      v.notes.push_back("The sizes were read in " + std::string(name(unit)) +
                        ", and no particle lies in a class (the pan's aside); with size_unit=\"" +
                        std::string(name(*other)) + "\" the first would.");
  }

  Words words_;
  Question question_;
  Gradation gradation_;
  SmallestMatch smallest_;
  AllowedError allowed_;
  ParticleOptions options_;
  Rational factor_;
  cli::PlaceFlags places_;
  DescriptionSink sink_;
  PlacedSink placed_;
  unsigned digits_;
  std::uint64_t count_ = 0;
  std::unique_ptr<ParticleReader> reader_; ///< null: no file of lines
  std::optional<LengthUnit> unit_;         ///< of a file of GSD
  std::optional<Description> answer_;
  std::vector<std::string> objections_, notes_;
};

} // namespace

void add_verification(py::module_ &module) {
  py::class_<Verifier>(module, "Verifier")
      .def(py::init<const Gradation &, const Values &, const std::vector<std::string> &>(),
           py::call_guard<py::gil_scoped_release>())
      .def("add_doubles", &Verifier::add_doubles)
      .def("add_texts", &Verifier::add_texts)
      .def("add_lines", &Verifier::add_lines)
      .def("add_gsd", &Verifier::add_gsd)
      .def("add_answer", &Verifier::add_answer)
      .def("result", &Verifier::result);
}

} // namespace mdm::python
