// solve_and_check GRADATION: the smallest match, and its proof, which the checker's library judges.

#include <mdm/checker.hpp>
#include <mdm/mdm.hpp>

#include <fstream>
#include <iostream>
#include <iterator>

int main(int argc, char **argv) try {
  const std::string path = argc == 2 ? argv[1] : "";
  std::ifstream file(path);
  const std::string content{std::istreambuf_iterator<char>(file), {}};
  const mdm::Match match = mdm::solve(mdm::read_gradation(content, path));
  for (const mdm::MatchClass &c : match.classes())
    if (c.size)
      std::cout << c.quantity << " of size " << c.size->text() << " mm\n";
  const mdm::checker::Verdict verdict =
      mdm::checker::check({path, content}, {"the proof", mdm::certificate(match)});
  std::cout << verdict.line << verdict.reason << '\n';
  return verdict.code;
} catch (const mdm::InputError &e) {
  std::cerr << e.what() << '\n';
  return 2;
}
