#include "answer/answer.hpp"
#include "ask/asked_search.hpp"
#include "proof/vipr.hpp"
#include "python/listener.hpp"
#include "python/module.hpp"
#include "python/numbers.hpp"
#include "python/solved.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/proof/certificate.hpp>
#include <mdm/text/error.hpp>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace mdm::python {
namespace {

/// A match, that of the next finer tolerance where a budget chose one, and the exception that ended the
/// search.
py::tuple answer(std::shared_ptr<Solved> found, std::shared_ptr<Solved> finer, py::object error) {
  return py::make_tuple(std::move(found), std::move(finer), std::move(error));
}

py::tuple solve_words(const std::optional<Gradation> &g, const std::map<std::string, std::string> &values,
                      const std::vector<std::string> &tolerances, bool keep_proof,
                      const py::object &progress) {
  const Words words{values, tolerances};
  Listener listener(progress);
  std::shared_ptr<Solved> found, finer;
  {
    const py::gil_scoped_release unlocked;
    const BudgetTexts budget = budget_texts(words);
    if (!g && budget.particles)
      throw InputError("particles: a budget needs a gradation: give one");
    const AskedSearch search(solve_texts(words), budget, band_of(words), keeps_proof(words, keep_proof));
    const std::optional<Envelope> &band = search.question().rest.band;
    if (!g && !band)
      throw InputError("a gradation is missing: give one, or a band alone");
    const Gradation target = g ? *g : middle_of(*band);
    Question question = search.question().of(target);
    question.band_alone = !g;
    Found both = search.ask(target, question, listener.call());
    if (listener.is_stopped())
      note_stopped(both.match);
    found = std::make_shared<Solved>(std::move(both.match), both.limits);
    if (both.finer)
      finer = std::make_shared<Solved>(std::move(*both.finer), both.limits);
  }
  return answer(std::move(found), std::move(finer), listener.error());
}

/// Intervals of numbers of particles, from where on nothing is missing or known, whether that is all, and the
/// exception that ended the search.
py::tuple spectrum_of(const Solved &solved, const std::map<std::string, std::string> &values,
                      const py::object &progress) {
  if (!solved.match().sample || solved.match().tolerance)
    throw InputError("a spectrum is of an exact match: leave out tolerance and band, and raise the limits");
  Listener listener(progress);
  Spectrum found;
  {
    const py::gil_scoped_release unlocked;
    SolveOptions options = options_of({values, {}}, false);
    found = mdm::spectrum(solved.match(), options.limits, listener.call());
  }
  py::list intervals;
  for (const auto &[from, to] : found.intervals)
    intervals.append(py::make_tuple(int_of(from), int_of(to)));
  return py::make_tuple(intervals, int_of(found.all_from), found.complete, listener.error());
}

/// A text that is made without Python's lock.
template <class Make>
auto unlocked_text(Make make) {
  return [make](const Solved &s) {
    const py::gil_scoped_release unlocked;
    return make(s);
  };
}

std::string proof_of(const Solved &s, bool can_be, std::string (*write)(const Match &)) {
  if (!s.keeps_proof())
    throw InputError("the proof was not kept: give proofs=True to batch, or a max_steps of 67108864 or less");
  if (!can_be)
    throw InputError("there is no proof: a limit came before the end");
  return write(s.match());
}

} // namespace

Solved::Solved(Match match, const Limits &limits)
    : match_(std::move(match)), json_(answer_json(match_)), outcome_(outcome_of(match_, limits)),
      keeps_proof_(limits.keep_proof) {}

void add_match(py::module_ &module) {
  py::class_<Solved, std::shared_ptr<Solved>>(module, "Match")
      .def("json", &Solved::json)
      .def("outcome", [](const Solved &s) { return name(s.outcome()); })
      .def("csv", unlocked_text([](const Solved &s) { return answer_csv(s.match()); }))
      .def("text", unlocked_text([](const Solved &s) { return answer_text(s.match()); }))
      .def("certificate", unlocked_text([](const Solved &s) {
             return proof_of(s, has_certificate(s.match()), certificate);
           }))
      .def("vipr", unlocked_text([](const Solved &s) { return proof_of(s, s.match().complete, vipr); }))
      .def("spectrum", &spectrum_of);
  module.def("solve", &solve_words);
}

} // namespace mdm::python
