/// \file
/// The solver and the checker read canonical gradation files with parsers of their own. They must agree on
/// every file: the same gradation, or no gradation. (What the solver reads beyond, it says to be not
/// canonical.)

#include "catch.hpp"
#include "checker/gradation.hpp"
#include "checker/text.hpp"
#include "proof/gradation_files.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/rational.hpp>
#include <mdm/text/error.hpp>

namespace reader_agreement_test {

namespace {

/// Openings to the power of the root, masses, factors and tolerances as one text; nothing if the file is
/// refused.
std::optional<std::string> by_solver(const std::string &content) {
  try {
    const mdm::UnderstoodGradation understood = mdm::understand_gradation(content, "file");
    if (!understood.is_canonical)
      return std::nullopt;
    const mdm::Gradation &g = understood.gradation;
    std::string text = "root " + std::to_string(g.root()) + "\n";
    for (std::size_t j = 0; j < g.powers().size(); ++j)
      text += mdm::to_string(g.powers()[j]) + " " + mdm::to_string(g.masses()[j]) + " " +
              mdm::to_string(g.factor(j)) + " " +
              (g.tolerances().empty() ? "" : mdm::to_string(g.tolerances()[j])) + "\n";
    return text;
  } catch (const mdm::InputError &) {
    return std::nullopt;
  }
}

std::optional<std::string> by_checker(const std::string &content) {
  try {
    const mdm::checker::Gradation g = mdm::checker::read_gradation(content);
    std::string text = "root " + std::to_string(g.root) + "\n";
    for (std::size_t j = 0; j < g.openings.size(); ++j)
      text += g.openings[j].get_str() + " " + g.masses[j].get_str() + " " + g.factors[j].get_str() + " " +
              (g.tolerances.empty() ? "" : g.tolerances[j].get_str()) + "\n";
    return text;
  } catch (const mdm::checker::Malformed &) {
    return std::nullopt;
  }
}

} // namespace

TEST_CASE("solver and checker read the same gradation") {
  for (const std::string &seed : gradation_files::seeds) {
    INFO(seed);
    CHECK(by_solver(seed).has_value());
    CHECK(by_solver(seed) == by_checker(seed));
  }
}

TEST_CASE("solver and checker agree on mutated files") {
  std::mt19937_64 random(18);
  int accepted = 0;
  for (int i = 0; i < 60000; ++i) {
    const std::string text = gradation_files::mutated(
        gradation_files::seeds[static_cast<std::size_t>(i) % gradation_files::seeds.size()], random);
    const std::optional<std::string> solver = by_solver(text);
    accepted += solver ? 1 : 0;
    if (solver != by_checker(text)) {
      INFO(text);
      INFO("solver: " << solver.value_or("refused"));
      INFO("checker: " << by_checker(text).value_or("refused"));
      CHECK(false);
    }
  }
  CHECK(accepted >= 2200);
}

} // namespace reader_agreement_test
