#include "ask/option_values.hpp"
#include "ask/verifier.hpp"
#include "particles/gsd.hpp"
#include "python/module.hpp"
#include "python/numbers.hpp"
#include "python/question.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <pybind11/stl.h>

#include <cmath>
#include <memory>

namespace py = pybind11;

namespace mdm::python {
namespace {

using Values = std::map<std::string, std::string>;

VerifyTexts verify_texts(const Words &words) {
  VerifyTexts texts;
  take_words(words, GradationTexts::options, texts.gradation);
  take_words(words, PlaceTexts::options, texts.places);
  take_words(words, ParticleTexts::options, texts.particles);
  take_words(words, VerifyTexts::options, texts);
  take_words(words, VerifyTexts::answer_options, texts);
  return texts;
}

/// A sample that is judged while it comes in. One thread at a time.
class Sample {
public:
  Sample(const Gradation &g, const Values &values, const std::vector<std::string> &tolerances)
      : Sample(g, Words{values, tolerances}) {}

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

  /// Adds sizes that are texts: decimals or fractions.
  void add_texts(const std::vector<std::string> &sizes) {
    const py::gil_scoped_release unlocked;
    for (const std::string &text : sizes)
      add(rational_of(text));
  }

  /// Lines of a file of particles, as they come; `name` is the file's.
  void add_lines(const std::vector<std::string> &lines, const std::string &name) {
    const py::gil_scoped_release unlocked;
    if (!reader_)
      reader_ = std::make_unique<ParticleReader>(name, verifier_.particles(), verifier_.reading());
    for (const std::string &line : lines)
      reader_->line(line);
  }

  /// A file of GSD, whole.
  void add_gsd(const py::bytes &content, const std::string &name) {
    const std::string_view bytes(content);
    const py::gil_scoped_release unlocked;
    verifier_.end(read_gsd(bytes, name, verifier_.particles(), verifier_.reading()));
  }

  /// An answer in JSON.
  void add_answer(const std::string &json, const std::string &name) {
    const py::gil_scoped_release unlocked;
    verifier_.take_answer(json, name);
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
  Sample(const Gradation &g, const Words &words)
      : verifier_(g, "", verify_texts(words).question(g, envelope_of(words))), factor_(factor_of_sizes()) {}

  Verification verification(const std::string &sample) {
    if (reader_) {
      reader_->end();
      verifier_.end({reader_->notes(), reader_->unit()});
    } else if (count_ > 0) {
      verifier_.end({{}, unit()});
    }
    return verifier_.verification(sample);
  }

  /// Of sizes that are no file.
  SizeUnit unit() const { return verifier_.reading().unit.value_or(verifier_.unit()); }

  /// From a size as it is given to a diameter in the gradation's unit.
  Rational factor_of_sizes() const {
    const Rational factor = in_mm(unit()) / in_mm(verifier_.unit());
    return verifier_.reading().meaning == SizeMeaning::radius ? Rational(factor * 2) : factor;
  }

  void add(const Rational &size) {
    if (size <= 0)
      refuse("it is not above 0");
    ++count_;
    verifier_.particles().add(RootSize{factor_ == 1 ? size : Rational(size * factor_)}, 1);
  }

  [[noreturn]] void refuse(const char *what) const {
    throw InputError("particle " + std::to_string(count_ + 1) + " of the sample: its size is wrong: " + what);
  }

  Verifier verifier_;
  Rational factor_;
  std::uint64_t count_ = 0;
  std::unique_ptr<ParticleReader> reader_; ///< null: no file of lines
};

} // namespace

void add_verification(py::module_ &module) {
  py::class_<Sample>(module, "Verifier")
      .def(py::init<const Gradation &, const Values &, const std::vector<std::string> &>(),
           py::call_guard<py::gil_scoped_release>())
      .def("add_doubles", &Sample::add_doubles)
      .def("add_texts", &Sample::add_texts)
      .def("add_lines", &Sample::add_lines)
      .def("add_gsd", &Sample::add_gsd)
      .def("add_answer", &Sample::add_answer)
      .def("result", &Sample::result);
}

} // namespace mdm::python
