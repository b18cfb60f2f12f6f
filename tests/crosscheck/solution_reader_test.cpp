// Solutions as solvers write them.

#include "catch.hpp"
#include "crosscheck/solution_reader.hpp"

#include <mdm/gradation/read_gradation.hpp>

using namespace mdm;

namespace {

/// Of classes 1 and 3; the second one is empty.
IntegerProgram program(ProgramForm form = ProgramForm::strict) {
  return integer_program(gradation_of({"1", "2", "3", "4"}, {"4", "0", "3", "0"}), {}, form, "test");
}

std::vector<Integer> counts(const std::string &text) {
  const OtherAnswer answer = solution_answer(text, program());
  INFO(answer.reason);
  CHECK_FALSE(answer.failure);
  return answer.quantities;
}

const std::vector<Integer> eleven_two = {11, 2};

} // namespace

TEST_CASE("solutions of all solvers are read", "[solution]") {
  CHECK(
      counts("Optimal - objective value 13.0\n      0 q1           11           1\n      1 q3     2   1\n") ==
      eleven_two);
  CHECK(counts("   No. Column name  Activity\n     1 q1           *           11             1\n     2 q3  * "
               " 2  1\n") == eleven_two);
  CHECK(counts("# Columns 3\nq1 11\nq3 2.0\ns 0.5\n") == eleven_two);
  CHECK(counts("objective value: 13\nq1      11 \t(obj:1)\nq3    2 \t(obj:1)\n") == eleven_two);
  CHECK(counts("sat\n(objectives\n ((+ q1 q3) 13)\n)\n((q1 11)\n (q3 2))\n") == eleven_two);
  CHECK(counts("sat\n(\n  (define-fun q3 () Int\n    2)\n  (define-fun q1 () Int\n    11)\n)\n") ==
        eleven_two);
  CHECK(counts("{\"q1\": 11, \"q3\": 2}") == eleven_two);
}

TEST_CASE("of several solutions the last counts", "[solution]") {
  CHECK(counts("q1 = 20;\nq3 = 5;\n----------\nq1 = 11;\nq3 = 2;\n----------\n==========\n") == eleven_two);
}

TEST_CASE("a count that is left out is 0", "[solution]") {
  CHECK(counts("q1 11\n") == std::vector<Integer>{11, 0});
}

TEST_CASE("digits of pseudo-Boolean solvers are counts", "[solution]") {
  const IntegerProgram p = program(ProgramForm::integers);
  CHECK(has_binary_values("c\nv x1 -x2\n"));
  const OtherAnswer least = solution_answer("s OPTIMUM FOUND\nv -x1 -x2 -x3\n", p);
  CHECK(least.quantities == std::vector<Integer>{p.variables[0].least, p.variables[1].least});
  const OtherAnswer more = solution_answer("v x1 x2\nv x3\nv x1 -x2\nv -x3\n", p); // two solutions
  CHECK(more.quantities == std::vector<Integer>{p.variables[0].least + 1, p.variables[1].least});
}

TEST_CASE("what is no solution is said", "[solution]") {
  const auto failure = [](const std::string &text) { return solution_answer(text, program()).failure; };
  CHECK(failure("Problem is infeasible") == AnswerVerdict::infeasible);
  CHECK(failure("unsat\n") == AnswerVerdict::infeasible);
  CHECK(failure("") == AnswerVerdict::garbage);
  CHECK(failure("q1 + q3 >= 3\nq1: particles") == AnswerVerdict::garbage);
  CHECK(failure("q1 11.5\nq3 2") == AnswerVerdict::garbage);
  CHECK(failure("q1 -11\nq3 2") == AnswerVerdict::garbage);
  CHECK(solution_answer("q1 11\nq2 1\nq3 2", program()).reason ==
        "q2 is no count of this problem: the solution is of another one");
}
