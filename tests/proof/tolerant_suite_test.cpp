// The proofs of the study's gradations within tolerances: what claims more than is true is refused.

#include "catch.hpp"

#include <mdm/checker.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/proof/certificate.hpp>

#include <fstream>
#include <sstream>

namespace tolerant_suite_test {

using namespace mdm;

namespace {

bool is_accepted(const std::string &line, const std::string &text) {
  return mdm::checker::check({"gradation", line}, {"certificate", text}).code ==
         mdm::checker::Verdict::accepted;
}

/// The certificate with another claim of no fewer than `bound` particles, without a witness.
std::string claiming(const std::string &text, const Integer &bound) {
  std::istringstream lines(text);
  std::string changed;
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("mdm-certificate", 0) == 0)
      changed += "mdm-certificate 2\n";
    else if (line.rfind("particles ", 0) == 0)
      changed += "particles " + to_string(bound) + "..\n";
    else if (line.rfind("class ", 0) != 0)
      changed += line + "\n";
  return changed;
}

} // namespace

TEST_CASE("the suite's proofs within tolerances are accepted, and refused if they claim one particle more") {
  std::ifstream file(MDM_SUITE);
  REQUIRE(file.good());
  int optimal = 0, between = 0;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line); ++number)
    for (const char *tolerance : {"retained:1%", "passing:0.5%", "laboratory"}) {
      Question question;
      question.tolerances = {parse_tolerance(tolerance)};
      const Match m = solve(read_json_gradation(line, "suite", ""), question);
      INFO(line << tolerance);
      REQUIRE(m.status == Status::optimal);
      const std::string text = certificate(m);
      REQUIRE(is_accepted(line, text));
      const Integer n = *m.particles();
      REQUIRE(is_accepted(line, claiming(text, n)));
      REQUIRE_FALSE(is_accepted(line, claiming(text, Integer(n + 1))));
      ++optimal;
      if (number % 8 != 0)
        continue;
      // A search that ends at once leaves bounds; closed by one particle they are refused, if not true.
      SolveOptions options;
      options.limits.node_limit = 1;
      const Match part = solve(m.gradation, question, options);
      if (part.complete)
        continue;
      const std::string bounds = certificate(part);
      REQUIRE(*part.proof.bound <= n);
      REQUIRE(is_accepted(line, bounds));
      REQUIRE_FALSE(is_accepted(line, claiming(bounds, Integer(*part.proof.bound + 1))));
      REQUIRE_FALSE(is_accepted(line, claiming(bounds, Integer(n + 1))));
      ++between;
    }
  CHECK(optimal == 3 * 2750);
  CHECK(between >= 5);
}

} // namespace tolerant_suite_test
