// judge_solver GRADATION: judges answers such as {"quantities": ["15", "2"]}, a line each.

#include <mdm/mdm.hpp>

#include <iostream>

int main(int argc, char **argv) try {
  const mdm::Crosscheck crosscheck(mdm::read_gradation_file(argc == 2 ? argv[1] : ""));
  bool all_minimal = true;
  for (std::string answer; std::getline(std::cin, answer);) {
    const mdm::CrosscheckRow row = crosscheck.judge(answer);
    std::cout << mdm::name(row.verdict);
    if (row.particles && row.minimum)
      std::cout << ": " << *row.particles << " particles, the least is " << *row.minimum;
    std::cout << (row.reason.empty() ? "" : ": " + row.reason) << '\n';
    all_minimal = all_minimal && row.verdict == mdm::AnswerVerdict::minimal;
  }
  return all_minimal ? 0 : 1;
} catch (const mdm::InputError &e) {
  std::cerr << e.what() << '\n';
  return 2;
}
