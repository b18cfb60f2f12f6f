// judge_gradation GRADATION SPECIFICATION: whether a sieve analysis keeps limits such as `astm-c33-fine`, or
// those in a file.

#include <mdm/mdm.hpp>

#include <fstream>
#include <iostream>
#include <sstream>

static std::string content(const std::string &path) {
  std::ifstream file(path);
  std::ostringstream text;
  if (!(text << file.rdbuf()))
    throw mdm::InputError(path + ": it cannot be read");
  return text.str();
}

int main(int argc, char **argv) try {
  if (argc != 3)
    throw mdm::InputError("give a gradation and a specification");
  std::optional<mdm::Specification> asked = mdm::shipped_specification(argv[2]);
  if (!asked)
    asked = mdm::read_specification(content(argv[2]), argv[2]);
  const mdm::UnderstoodGradation report = mdm::understand_gradation(content(argv[1]), argv[1]);
  const mdm::JudgedGradation judged = mdm::judge_gradation(report, *asked);
  for (const mdm::JudgedSieve &sieve : judged.sieves)
    std::cout << mdm::to_decimal(sieve.limits.size) << " mm: " << sieve.least.text() << " to "
              << sieve.most.text() << " % pass: " << mdm::name(sieve.verdict) << '\n';
  std::cout << judged.id << ": " << mdm::name(judged.verdict) << '\n';
  return judged.verdict == mdm::Compliance::holds ? 0 : 1;
} catch (const mdm::InputError &e) {
  std::cerr << e.what() << '\n';
  return 2;
}
