// The SMT solver z3 as a second opinion on gradations that are too large for enumeration.

#include "all_cases.hpp"
#include "catch.hpp"
#include "tools.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace z3_test {

using namespace mdm;

namespace {

using Kind = AskedTolerance::Kind;

/// What z3 prints for a script, at most four seconds of it; its older arithmetic is the faster one here.
std::string z3(const std::string &script) {
  std::string name = (std::filesystem::temp_directory_path() / "mdm-z3-XXXXXX").string();
  const int file = mkstemp(name.data());
  REQUIRE(file >= 0);
  close(file);
  std::ofstream(name) << script;
  FILE *pipe = popen(("z3 -in -T:4 smt.arith.solver=2 < " + name).c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string out;
  for (int c; (c = std::fgetc(pipe)) != EOF;)
    out += static_cast<char>(c);
  pclose(pipe);
  std::filesystem::remove(name);
  return out;
}

std::string smt(const Rational &r) {
  const std::string size =
      "(/ " + to_string(Integer(abs(numerator(r)))) + ".0 " + to_string(denominator(r)) + ".0)";
  return r < 0 ? "(- " + size + ")" : size;
}

/// The problem from its definition, in shares of spheres' masses.
class Script {
public:
  Script(const Gradation &g, const Question &question) : k_(g.classes()), target_(shares(g)) {
    std::string mass, count;
    for (std::size_t j = 0; j < k_; ++j) {
      const std::string q = "(to_real q" + std::to_string(j) + ")", t = "t" + std::to_string(j);
      text_ += "(declare-const q" + std::to_string(j) + " Int)(declare-const " + t + " Real)\n";
      state("(>= q" + std::to_string(j) + " " +
            to_string(g.mass(j) > 0 && question.min_per_class > 1 ? question.min_per_class : Integer(0)) +
            ")");
      state("(ite (= " + q + " 0.0) (= " + t + " 0.0) (and (> " + t + " (* " +
            smt(Rational(g.factor(j) * power(g.lower(j), 3))) + " " + q + ")) (<= " + t + " (* " +
            smt(Rational(g.factor(j) * power(g.upper(j), 3))) + " " + q + "))))");
      mass += " " + t;
      count += " q" + std::to_string(j);
    }
    text_ += "(define-fun M () Real (+ 0.0" + mass + "))(define-fun N () Int (+ 0" + count + "))\n";
    state("(>= N " + to_string(question.at_least) + ")");
    for (const AskedTolerance &tolerance : question.tolerances)
      add(tolerance);
  }

  /// The answers to: N particles or fewer, and exactly N.
  std::string answers(const Integer &n) const {
    return z3(text_ + "(push)(assert (<= N " + to_string(Integer(n - 1)) + "))(check-sat)(pop)(assert (= N " +
              to_string(n) + "))(check-sat)\n");
  }

private:
  void state(const std::string &what) { text_ += "(assert " + what + ")\n"; }

  void within(const std::string &mass, const Rational &share, const Rational &width) {
    state("(<= " + mass + " (* " + smt(Rational(share + width)) + " M))");
    state("(>= " + mass + " (* " + smt(Rational(share - width)) + " M))");
  }

  void add(const AskedTolerance &tolerance) {
    const Rational width = tolerance.percent / 100;
    std::string passing = "(+ 0.0", deviations = "(+ 0.0";
    Rational share = 0;
    for (std::size_t j = 0; j < k_; ++j) {
      const std::string t = "t" + std::to_string(j);
      share += target_[j];
      passing += " " + t;
      const std::string deviation = "(- " + t + " (* " + smt(target_[j]) + " M))";
      deviations += " (ite (>= " + deviation + " 0.0) " + deviation + " (- " + deviation + "))";
      if (tolerance.kind == Kind::retained)
        within(t, target_[j], width);
      if (tolerance.kind == Kind::passing && j + 1 < k_)
        within(passing + ")", share, width);
    }
    if (tolerance.kind == Kind::total)
      state("(<= " + deviations + ") (* " + smt(width) + " M))");
  }

  std::size_t k_;
  std::vector<Rational> target_;
  std::string text_;
};

} // namespace

TEST_CASE("z3 finds as many particles within a tolerance, and no fewer") {
  if (!mdm_test::has_tool("z3", "z3"))
    return;
  std::ifstream suite(MDM_SUITE);
  std::size_t line_number = 0, asked_for = 0, compared = 0;
  const std::size_t questions = takes_all_cases() ? 32 : 18;
  for (std::string line; asked_for < questions && std::getline(suite, line); ++line_number) {
    if (line_number % 11 != 0)
      continue;
    const Gradation g = read_json_gradation(line, "suite", "");
    if (g.classes() < 7 || g.classes() > 12)
      continue;
    const std::vector<AskedTolerance> asked[] = {
        {{Kind::retained, 1}},
        {{Kind::passing, ratio(1, 2)}},
        {{Kind::total, 1}},
        // a bound that is 0 exactly: the class of least share may be empty
        {{Kind::retained, 100 * shares(g).front()}},
        {{Kind::retained, 2}, {Kind::passing, 1}, {Kind::total, 4}},
        {{Kind::passing, 0}}};
    Question question;
    question.tolerances = asked[line_number / 11 % 6];
    if (line_number / 11 % 5 == 0)
      question.min_per_class = 2;
    const Match m = solve(g, question);
    REQUIRE(m.status == Status::optimal);
    const Integer particles = m.particles().value();
    if (particles > 100000) // z3 takes long
      continue;
    ++asked_for;
    const std::string answers = Script(g, question).answers(particles);
    INFO(g.id() << ": " << particles << " particles, " << g.classes() << " classes");
    if (answers.find("unknown") != std::string::npos || answers.find("timeout") != std::string::npos)
      continue;
    CHECK(answers == "unsat\nsat\n");
    ++compared;
  }
  CHECK(compared >= 10);
  WARN(compared << " of " << asked_for << " problems compared with z3");
}

} // namespace z3_test
