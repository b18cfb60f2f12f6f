// Solutions as solvers write them.

#include "catch.hpp"
#include "crosscheck/program_text.hpp"
#include "crosscheck/solution_reader.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <algorithm>

namespace solution_reader_test {

using namespace mdm;

namespace {

/// Of classes 1 and 3; the second one is empty.
IntegerProgram program(ProgramForm form = ProgramForm::strict) {
  return integer_program(gradation_of({"1", "2", "3", "4"}, {"4", "0", "3", "0"}), {}, form, "test");
}

std::vector<Integer> counts(const std::string &text) {
  const OtherAnswer answer = read_solution(text, program()).answer;
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

TEST_CASE("a count that is left out is 0, and that is said", "[solution]") {
  const Solution solution = read_solution("q1 11\n", program());
  CHECK(solution.answer.quantities == std::vector<Integer>{11, 0});
  CHECK(solution.notes == std::vector<std::string>{"q3 is not in the solution: it is taken as 0"});
  CHECK(read_solution("q1 11\nq3 2\n", program()).notes.empty());
}

TEST_CASE("digits of pseudo-Boolean solvers are counts", "[solution]") {
  const IntegerProgram p = program(ProgramForm::integers);
  const BinaryDigits last = binary_digits(p)[1];
  const std::size_t all = last.first + last.count - 1;
  const auto line = [&](const std::vector<std::size_t> &is_true, std::size_t digits) {
    std::string text = "v";
    for (std::size_t x = 1; x <= digits; ++x)
      text += std::string(std::count(is_true.begin(), is_true.end(), x) > 0 ? " " : " -") + "x" +
              std::to_string(x);
    return text + "\n";
  };
  const std::vector<Integer> least = {p.variables[0].least, p.variables[1].least};
  CHECK(has_binary_values("c\nv x1 -x2\n"));
  CHECK(read_solution("s OPTIMUM FOUND\n" + line({}, all), p).answer.quantities == least);
  const Solution two = read_solution(line({1, 2}, all) + line({1}, all), p); // the last counts
  CHECK(two.answer.quantities == std::vector<Integer>{least[0] + 1, least[1]});
  CHECK(read_solution(line({}, all - 1), p).answer.failure == AnswerVerdict::garbage);
  CHECK(read_solution(line({}, all + 1), p).answer.failure == AnswerVerdict::garbage);
}

TEST_CASE("what is no solution is said", "[solution]") {
  const auto failure = [](const std::string &text) { return read_solution(text, program()).answer.failure; };
  for (const char *text :
       {"unsat\n", "s UNSATISFIABLE\n", "=====UNSATISFIABLE=====\n", "Infeasible - objective value 0\n",
        "Infeasible - objective value 13\n 0 q1 11 1\n 1 q3 2 1\n", "Status:     INTEGER EMPTY\nq1 0\n",
        "Model status\nInfeasible\n"})
    CHECK(failure(text) == AnswerVerdict::infeasible);
  for (const char *text :
       {"s UNKNOWN\nc Unsat: 0.00s\n", "unknown\n", "Stopped on time - objective value 0\n"})
    CHECK(failure(text) == AnswerVerdict::gave_up);
  CHECK_FALSE(failure("Stopped on time - objective value 13\n 0 q1 11 1\n 1 q3 2 1\n"));
  for (const char *text :
       {"", "This run was not UNSAT, out of memory", "q1 + q3 >= 3\nq1: particles", "q1 11.5\nq3 2",
        "q1 -11\nq3 2", "q1 nan\nq3 2", "q1 ** 11\nq3 2", "0 q1 ?\n1 q3 2"})
    CHECK(failure(text) == AnswerVerdict::garbage);
  CHECK(read_solution("q1 11\nq2 1\nq3 2", program()).answer.reason ==
        "q2 is no count of this problem: the solution is of another one");
}

} // namespace solution_reader_test
