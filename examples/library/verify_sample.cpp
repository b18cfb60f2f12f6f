// verify_sample GRADATION PARTICLES TOLERANCE: whether a file of particles matches within `retained:1%`.

#include <mdm/mdm.hpp>

#include <fstream>
#include <iostream>

int main(int argc, char **argv) try {
  if (argc != 4)
    throw mdm::InputError("give a gradation, a file of particles and a tolerance");
  mdm::Question asked;
  asked.tolerances = {mdm::parse_tolerance(argv[3])};
  mdm::SampleVerifier verifier(mdm::read_gradation_file(argv[1]), asked);
  std::ifstream particles(argv[2]);
  verifier.read(particles, argv[2]);
  const mdm::SampleVerdict verdict = verifier.verdict(argv[2]);
  for (const mdm::VerifiedClass &c : verdict.classes)
    std::cout << "up to " << c.upper.text() << " mm: " << c.quantity << '\n';
  const bool matches = verdict.is_match.value_or(false);
  std::cout << verdict.outside << " in no class: " << (matches ? "it matches" : "it does not match") << '\n';
  return matches ? 0 : 1;
} catch (const mdm::InputError &e) {
  std::cerr << e.what() << '\n';
  return 2;
}
