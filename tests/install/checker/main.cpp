// Whether a certificate proves its claim about a gradation, by the checker's library alone.

#include <mdm/checker.hpp>

#include <fstream>
#include <iostream>
#include <iterator>

namespace {

mdm::checker::Input read(const char *path) {
  std::ifstream file(path);
  return {path, {std::istreambuf_iterator<char>(file), {}}};
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 3)
    return 2;
  const mdm::checker::Verdict verdict = mdm::checker::check(read(argv[1]), read(argv[2]));
  std::cout << verdict.line << '\n' << verdict.reason << '\n';
  return verdict.code;
}
