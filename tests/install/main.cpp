// The least number of particles that match the gradation of a file.

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>

#include <fstream>
#include <iostream>
#include <iterator>

int main(int argc, char **argv) {
  if (argc != 2)
    return 2;
  std::ifstream file(argv[1]);
  const std::string content{std::istreambuf_iterator<char>(file), {}};
  const mdm::Match match = mdm::solve(mdm::read_gradation(content, argv[1]));
  std::cout << match.particles() << '\n';
}
