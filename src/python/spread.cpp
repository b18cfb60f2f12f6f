#include "python/module.hpp"
#include "python/solved.hpp"

#include <mdm/text/error.hpp>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace mdm::python {
namespace {

/// Gives the sizes of a spread out, some at a time: memory does not grow with their number.
class SpreadSizes {
public:
  SpreadSizes(std::shared_ptr<Solved> solved, std::uint64_t seed)
      : solved_(std::move(solved)), spread_(spread(checked(solved_->match()), seed)) {}

  /// The class, counted from 0, and the bounds of the size of each of the next particles; none at the end.
  std::vector<std::tuple<std::size_t, std::string, std::string>> next(std::size_t most) {
    std::vector<std::tuple<std::size_t, std::string, std::string>> sizes;
    while (sizes.size() < most && class_ < spread_.classes.size())
      add_next(sizes);
    return sizes;
  }

private:
  static const Match &checked(const Match &m) {
    if (!m.has_answer())
      throw InputError("there is no match to spread: ask for less, or raise the limits");
    return m;
  }

  void add_next(std::vector<std::tuple<std::size_t, std::string, std::string>> &sizes) {
    const ClassSpread &c = spread_.classes[class_];
    if (!masses_)
      masses_.emplace(c.masses());
    const Enclosure size = c.size(masses_->next(), solved_->match().digits);
    sizes.emplace_back(c.index(), size.lower_text(), size.upper_text());
    if (++given_ == c.quantity()) {
      ++class_;
      given_ = 0;
      masses_.reset();
    }
  }

  std::shared_ptr<Solved> solved_;
  Spread spread_;
  std::size_t class_ = 0;   ///< that is given out, of those of the spread
  std::uint64_t given_ = 0; ///< of its particles
  std::optional<ClassSpread::Masses> masses_;
};

} // namespace

void add_spread(py::module_ &module) {
  py::class_<SpreadSizes>(module, "SpreadSizes")
      .def(py::init<std::shared_ptr<Solved>, std::uint64_t>(), py::call_guard<py::gil_scoped_release>())
      .def("next", &SpreadSizes::next);
}

} // namespace mdm::python
