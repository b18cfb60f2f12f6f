#include <mdm/error.hpp>
#include <mdm/grading/matched_set.hpp>
#include <mdm/number/decimal.hpp>

namespace mdm {
namespace {

Rational decimal(const Real &y, unsigned digits) {
  return parse_decimal(rounded(y, digits));
}

} // namespace

Gradation rounded_gradation(const std::vector<SizeClass> &classes, unsigned digits, const std::string &id) {
  Gradation::Data data;
  data.id = id;
  data.sizes.push_back(decimal(classes.front().lower.real, digits));
  for (const SizeClass &c : classes) {
    data.sizes.push_back(decimal(c.upper.real, digits));
    if (*(data.sizes.end() - 2) >= data.sizes.back())
      throw InputError("bounds of classes become the same with " + std::to_string(digits) +
                       " digits: give more with --match-digits");
    data.masses.push_back(c.is_empty() ? Rational(0) : decimal(c.volume_fraction, digits));
  }
  data.masses.emplace_back(0);
  return Gradation(std::move(data));
}

Match matched_set(const Gradation &rounded, const Representativity &wanted, const SolveOptions &options) {
  Question question;
  question.law = MassLaw{wanted.dimension, 1};
  question.min_per_class = wanted.min_per_class;
  question.at_least = wanted.at_least;
  return solve(rounded, question, options);
}

} // namespace mdm
