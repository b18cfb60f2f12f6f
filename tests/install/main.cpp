// The least number of particles that match the gradation of a file.

#include <mdm/mdm.hpp>

#include <iostream>

int main(int argc, char **argv) {
  if (argc != 2)
    return 2;
  const mdm::Match match = mdm::solve(mdm::read_gradation_file(argv[1]));
  mdm::Integer particles = 0;
  for (const mdm::MatchClass &c : match.classes())
    particles += c.quantity;
  std::cout << (particles == match.particles() ? mdm::to_string(particles) : "?") << '\n';
}
