#include "python/numbers.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm::python {

Rational rational_of(const std::string &text) {
  const std::size_t bar = text.find('/');
  if (bar == std::string::npos)
    return parse_decimal(text);
  const Rational numerator = parse_decimal(text.substr(0, bar));
  const Rational denominator = parse_decimal(text.substr(bar + 1));
  if (denominator <= 0)
    throw InputError(in_quotes(text) + " is no number: write a denominator above 0");
  return numerator / denominator;
}

std::vector<Rational> rationals_of(const std::string &name, const std::vector<std::string> &texts) {
  std::vector<Rational> numbers;
  numbers.reserve(texts.size());
  for (const std::string &text : texts)
    try {
      numbers.push_back(rational_of(text));
    } catch (const InputError &e) {
      throw InputError(name + "[" + std::to_string(numbers.size()) + "]: " + e.what());
    }
  return numbers;
}

std::vector<std::string> texts_of(const std::vector<Rational> &numbers) {
  std::vector<std::string> texts(numbers.size());
  std::transform(numbers.begin(), numbers.end(), texts.begin(),
                 [](const Rational &r) { return to_string(r); });
  return texts;
}

pybind11::object int_of(const Integer &n) {
  // Hexadecimal digits have no limit of length in Python.
  const std::string digits = Integer(abs(n)).str(0, std::ios_base::hex);
  PyObject *const value = PyLong_FromString(((n < 0 ? "-" : "") + digits).c_str(), nullptr, 16);
  if (value == nullptr)
    throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::object>(value);
}

} // namespace mdm::python
