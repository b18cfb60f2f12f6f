#include "ask/particle_options.hpp"
#include "ask/reading_options.hpp"
#include "particles/gsd.hpp"
#include "particles/sample_sieves.hpp"
#include "python/module.hpp"
#include "python/numbers.hpp"
#include "python/question.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/number/enclosure.hpp>
#include <mdm/text/error.hpp>

#include <pybind11/stl.h>

#include <algorithm>
#include <map>

namespace py = pybind11;

namespace mdm::python {
namespace {

using Texts = std::vector<std::string>;

SizeUnit unit_of(const std::string &text) {
  for (const SizeUnit unit : {SizeUnit::mm, SizeUnit::um, SizeUnit::m})
    if (name(unit) == text)
      return unit;
  throw InputError("unit: " + in_quotes(text) + " is unknown: use mm, um or m");
}

/// What is left of a denominator without its factors 2 and 5: 1 for a decimal.
Integer undecimal_part(Integer denominator) {
  for (const unsigned prime : {2U, 5U})
    while (denominator % prime == 0)
      denominator /= prime;
  return denominator;
}

/// Masses that are no decimals are multiplied by the least integer that makes them decimals: only their
/// ratios count.
void make_masses_decimal(Gradation::Data &data) {
  Integer factor = 1;
  for (const Rational &mass : data.masses)
    factor = lcm(factor, undecimal_part(denominator(mass)));
  if (factor == 1)
    return;
  for (Rational &mass : data.masses)
    mass *= factor;
  data.notes.push_back("the masses were multiplied by " + to_string(factor) +
                       ", which makes decimals of them");
}

void require_decimals(const std::string &name, const std::vector<Rational> &numbers) {
  for (const Rational &number : numbers)
    if (undecimal_part(denominator(number)) != 1)
      throw InputError(name + " " + to_string(number) +
                       " is no decimal: write one, as files and proofs have them");
}

/// Sizes may descend too.
void make_ascending(Gradation::Data &data) {
  if (data.sizes.size() < 2 || data.sizes.front() <= data.sizes.back())
    return;
  for (std::vector<Rational> *const column :
       {&data.sizes, &data.masses, &data.factors, &data.tolerances, &data.roundings})
    std::reverse(column->begin(), column->end());
}

Gradation gradation_from(const Texts &sizes, const Texts &masses, const std::string &unit,
                         const std::string &id, const Texts &factors, const Texts &tolerances,
                         const Texts &roundings, const Texts &notes, unsigned root) {
  Gradation::Data data;
  data.id = id;
  data.unit = unit_of(unit);
  data.sizes = rationals_of("sizes", sizes);
  data.masses = rationals_of("masses", masses);
  data.factors = rationals_of("factors", factors);
  data.tolerances = rationals_of("tolerances", tolerances);
  data.roundings = rationals_of("roundings", roundings);
  data.notes = notes;
  data.root = root;
  make_ascending(data);
  make_masses_decimal(data);
  require_decimals("size", data.sizes);
  require_decimals("factors:", data.factors);
  require_decimals("tolerances:", data.tolerances);
  return Gradation(std::move(data));
}

/// The arguments that make the same gradation again.
py::tuple parts(const Gradation &g) {
  return py::make_tuple(texts_of(g.powers()), texts_of(g.masses()), std::string(name(g.unit())), g.id(),
                        texts_of(g.factors()), texts_of(g.tolerances()), texts_of(g.roundings()), g.notes(),
                        g.root());
}

/// Decimals around each opening.
std::vector<std::pair<std::string, std::string>> openings(const Gradation &g) {
  constexpr unsigned digits = 15;
  std::vector<std::pair<std::string, std::string>> all;
  for (std::size_t j = 0; j <= g.classes(); ++j) {
    const RootSize x = g.opening(j);
    if (const std::optional<Rational> exact = x.fraction()) {
      all.emplace_back(to_decimal(*exact), to_decimal(*exact));
    } else {
      const Enclosure e = enclose_root(numerator(x.power), denominator(x.power), x.degree, digits);
      all.emplace_back(e.lower_text(), e.upper_text());
    }
  }
  return all;
}

using ReadingWords = std::map<std::string, std::string>;

Reading reading_of(const ReadingWords &words) {
  ReadingTexts texts;
  take_words({words, {}}, ReadingTexts::options, texts);
  return texts.reading();
}

/// True for the beginning of a file of particles.
bool is_sample(const py::bytes &beginning) {
  const std::string_view text(beginning);
  return is_gsd(text) || told_format(text).has_value();
}

py::tuple read(const py::bytes &content, const std::string &file, const ReadingWords &words) {
  const std::string_view text(content);
  const Reading reading = reading_of(words);
  const auto understood = [&] {
    const py::gil_scoped_release unlocked;
    return understand_gradation(text, file, reading);
  };
  UnderstoodGradation u = understood();
  return py::make_tuple(std::move(u.gradation), u.format, u.sizes, u.masses, u.samples, u.is_canonical);
}

/// All specimens of a file.
std::vector<Gradation> read_all(const py::bytes &content, const std::string &file,
                                const ReadingWords &words) {
  const Reading reading = reading_of(words);
  std::string text(content);
  const py::gil_scoped_release unlocked;
  std::vector<Gradation> all;
  for (const UnreadGradation &one : gradations_in(std::move(text), file, reading))
    all.push_back(one.read());
  return all;
}

/// A line of a suite.
Gradation read_line(const py::bytes &line, const std::string &where, const std::string &fallback_id) {
  return read_json_gradation(std::string_view(line), where, fallback_id);
}

/// The gradation of the particles in a file.
Gradation read_sample(const py::bytes &content, const std::string &file,
                      const std::optional<std::string> &unit) {
  const ParticleOptions options = read_as_gradation(unit);
  const std::string_view text(content);
  const py::gil_scoped_release unlocked;
  SampleSieves sieves;
  if (is_gsd(text))
    return sieves.gradation(stem(file), SizeUnit::mm, read_gsd(text, file, sieves, options).notes,
                            SampleClasses::between_sizes);
  ParticleReader reader(file, sieves, options);
  for (Lines lines(text); lines.next();)
    reader.line(lines.text());
  reader.end();
  return sieves.gradation(stem(file), SizeUnit::mm, reader.notes(), SampleClasses::between_sizes);
}

} // namespace

void add_gradation(py::module_ &module) {
  py::class_<Gradation>(module, "Gradation")
      .def(py::init(&gradation_from))
      .def("parts", &parts)
      .def("openings", &openings)
      .def("masses", [](const Gradation &g) { return texts_of(g.masses()); })
      .def("factors", [](const Gradation &g) { return texts_of(g.factors()); })
      .def("tolerances", [](const Gradation &g) { return texts_of(g.tolerances()); })
      .def("notes", &Gradation::notes)
      .def("id", &Gradation::id)
      .def("unit", [](const Gradation &g) { return std::string(name(g.unit())); })
      .def("root", &Gradation::root)
      .def("csv", &gradation_csv)
      .def("json", &gradation_json);
  module.def("is_sample", &is_sample);
  module.def("read", &read);
  module.def("read_all", &read_all);
  module.def("read_line", &read_line);
  module.def("read_sample", &read_sample);
}

} // namespace mdm::python
