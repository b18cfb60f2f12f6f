#include "ask/asked_search.hpp"
#include "files/in_parallel.hpp"
#include "python/listener.hpp"
#include "python/module.hpp"
#include "python/solved.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <pybind11/stl.h>

#include <future>
#include <new>

namespace py = pybind11;

namespace mdm::python {
namespace {

constexpr std::chrono::milliseconds between_looks{50};

/// A gradation of a batch: one at hand, or a line of JSON that is still to be read.
struct BatchGradation {
  const Gradation *gradation = nullptr;
  std::string_view line;
  std::uint64_t number = 0; ///< of the line

  Gradation read(const std::string &file) const {
    const std::string id = std::to_string(number);
    return gradation != nullptr ? *gradation : read_json_gradation(line, file + ":" + id, id);
  }
};

/// Its answer, or what is wrong. The match itself, and the finer one of a budget, where it cannot be found
/// again, or its proof is to be kept.
struct BatchResult {
  std::string json, error;
  Outcome outcome = Outcome::done;
  std::shared_ptr<Solved> match, finer;
};

/// What a batch asks of each gradation.
struct AskedBatch {
  AskedBatch(const Words &words, std::string file_name, bool keep)
      : file(std::move(file_name)), keep_proof(keep),
        search(solve_texts(words), budget_texts(words), band_of(words), keeps_proof(words, keep)) {}

  std::string file; ///< of the lines
  bool keep_proof;
  AskedSearch search;
};

BatchResult result_of(const BatchGradation &item, const AskedBatch &batch, Listener &listener) {
  BatchResult result;
  if (listener.is_stopped())
    return result;
  try {
    Gradation g = item.read(batch.file);
    Found found =
        batch.search.ask(std::move(g), [&listener](const Progress &) { return !listener.is_stopped(); });
    auto match = std::make_shared<Solved>(std::move(found.match), found.limits);
    result.json = match->json();
    result.outcome = match->outcome();
    if (batch.keep_proof || match->outcome() == Outcome::limited)
      result.match = std::move(match);
    if (batch.keep_proof && found.finer)
      result.finer = std::make_shared<Solved>(std::move(*found.finer), found.limits);
  } catch (const InputError &e) {
    result.error = e.what();
    const std::string where = batch.file + ":" + std::to_string(item.number);
    if (item.gradation == nullptr && !result.error.starts_with(where))
      result.error = where + ": " + result.error;
  } catch (const std::bad_alloc &) { // the others are none the worse for it
    result.error = "out of memory: give it more, or max_steps";
  }
  return result;
}

/// Gradations, or (line, number); nothing is copied.
std::vector<BatchGradation> items_of(const py::list &list) {
  std::vector<BatchGradation> items;
  items.reserve(list.size());
  for (const py::handle &entry : list) {
    if (!py::isinstance<py::tuple>(entry)) {
      items.push_back({&entry.cast<const Gradation &>(), {}, 0});
      continue;
    }
    const auto pair = py::reinterpret_borrow<py::tuple>(entry);
    items.push_back({nullptr, pair[0].cast<std::string_view>(), pair[1].cast<std::uint64_t>()});
  }
  return items;
}

/// Solves gradations while Python does something else: one list after the other.
class BatchRun {
public:
  BatchRun(const std::string &file, const std::map<std::string, std::string> &values,
           const std::vector<std::string> &tolerances, bool keep_proof, unsigned threads)
      : batch_({values, tolerances}, file, keep_proof), threads_(threads), listener_(py::none{}) {}

  ~BatchRun() {
    listener_.stop();
    const py::gil_scoped_release unlocked;
    if (done_.valid())
      done_.wait();
  }
  BatchRun(const BatchRun &) = delete;
  BatchRun &operator=(const BatchRun &) = delete;

  /// Waits for the answers to the gradations before, and begins with these, if there are any.
  /// \return (answer in JSON, outcome, match or None, finer match or None, error) of each of those before, in
  /// order
  /// \throws what ended the search
  py::list next(py::list gradations) {
    std::vector<BatchGradation> items = items_of(gradations);
    wait();
    std::vector<BatchResult> results = std::move(results_);
    held_ = std::move(gradations);
    items_ = std::move(items);
    results_ = std::vector<BatchResult>(items_.size());
    if (!items_.empty())
      done_ = std::async(std::launch::async, [this] { solve_all(); });
    return answers(results);
  }

private:
  void wait() {
    if (done_.valid()) {
      const py::gil_scoped_release unlocked;
      while (done_.wait_for(between_looks) != std::future_status::ready)
        listener_.goes_on(); // the threads that solve do not hear of signals
      done_.get();
    }
    listener_.rethrow();
  }

  void solve_all() {
    in_parallel(items_.size(), threads_,
                [this](std::size_t i) { results_[i] = result_of(items_[i], batch_, listener_); });
  }

  static py::list answers(std::vector<BatchResult> &results) {
    py::list all(results.size());
    for (std::size_t i = 0; i < results.size(); ++i)
      all[i] = py::make_tuple(results[i].json, name(results[i].outcome), std::move(results[i].match),
                              std::move(results[i].finer), results[i].error);
    return all;
  }

  AskedBatch batch_;
  unsigned threads_;
  Listener listener_;
  py::list held_; ///< the owner of the items
  std::vector<BatchGradation> items_;
  std::vector<BatchResult> results_;
  std::future<void> done_;
};

} // namespace

void add_batch(py::module_ &module) {
  py::class_<BatchRun>(module, "BatchRun")
      .def(py::init<const std::string &, const std::map<std::string, std::string> &,
                    const std::vector<std::string> &, bool, unsigned>())
      .def("next", &BatchRun::next);
}

} // namespace mdm::python
