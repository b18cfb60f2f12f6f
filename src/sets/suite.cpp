#include "sets/suite.hpp"

#include "sets/suite_masses.hpp"
#include "sets/suite_sieves.hpp"

namespace mdm {

Rational NumberRange::drawn(RandomStream &random) const {
  constexpr std::uint32_t steps = 1000;
  return from == to ? from : Rational(from + (to - from) * ratio(random.below(steps + 1), steps));
}

Suite::Suite(std::string_view description, std::string_view file)
    : description_(std::make_shared<const SuiteDescription>(read_suite_description(description, file))) {}

Gradation Suite::line(std::uint64_t n, std::uint64_t seed) const {
  const SuiteDescription &d = *description_;
  RandomStream random(seed, n);
  const SuiteMasses &kind = d.masses[random.below(static_cast<std::uint32_t>(d.masses.size()))];
  const std::uint32_t classes = d.classes.drawn(random);
  Gradation::Data data;
  data.id = d.id + "-" + std::to_string(n);
  data.unit = d.unit;
  data.sizes =
      std::visit([&](const auto &sieves) { return drawn_openings(sieves, classes, random); }, d.sieves);
  data.masses = drawn_masses(kind, data.sizes, d.digits, random);
  data.masses.emplace_back(0);
  return Gradation(std::move(data));
}

} // namespace mdm
