#include "text.hpp"

#include <mdm/checker.hpp>

#include <gmp.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

namespace {

using namespace mdm::checker;

constexpr const char *help = R"(mdm-check GRADATION CERTIFICATE
mdm-check --print GRADATION [CERTIFICATE]

Checks the proof that a number of particles is the smallest that matches a gradation exactly
or within a tolerance, or the proof of bounds on the smallest.
GRADATION is the gradation file (CSV or JSON; or that of a band) and CERTIFICATE what
mdm solve --proof wrote; one of them may be - for standard input.

Examples:
  mdm solve sand.csv --proof sand.proof
  mdm-check sand.csv sand.proof
  mdm-check --print sand.csv

Exits with 0 (accepted), 1 (refused: the certificate does not prove its claim) or
2 (malformed: a file cannot be read, or the command is wrong). The verdict is on standard
output, the reason of another one than accepted on standard error.

  --print     the gradation as it is read, as CSV on standard output, before the verdict
  -h, --help  this text
  --version   the versions of this program and of GMP
)";

[[noreturn]] void fail(const std::string &who, const std::string &what) {
  throw std::runtime_error(printable(who) + ": " + what);
}

[[noreturn]] void out_of_memory() {
  std::fputs("mdm-check: out of memory: check on a larger machine\n", stderr);
  std::_Exit(Verdict::malformed);
}
/// GMP cannot pass on an exception: without memory the program ends here.
void *reallocate(void *memory, std::size_t, std::size_t size) {
  if (void *const larger = std::realloc(memory, size))
    return larger;
  out_of_memory();
}

/// Reads a file in pieces, so that a device without end ends at the limit.
Input read_input(const std::string &path, std::size_t most_bytes) {
  Input input{path == "-" ? "standard input" : path, {}};
  const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(
      path == "-" ? stdin : std::fopen(path.c_str(), "rb"), &std::fclose);
  std::vector<char> piece(std::size_t{1} << 16U);
  while (const std::size_t got = file ? std::fread(piece.data(), 1, piece.size(), file.get()) : 0) {
    input.text.append(piece.data(), got);
    if (input.text.size() > most_bytes)
      fail(input.name,
           "longer than " + std::to_string(most_bytes >> 20U) + " MiB: give the file that was meant");
  }
  if (!file || std::ferror(file.get()) != 0)
    fail(input.name, std::string("cannot be read: ") + std::strerror(errno) + ": give a file that is there");
  return input;
}

int print(const std::string &text) {
  if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
    fail("standard output",
         std::string("cannot be written: ") + std::strerror(errno) + ": send it elsewhere");
  return 0;
}

/// Writes a verdict behind a text, unless a file is malformed.
int report(const Verdict &verdict, const std::string &before = {}) {
  if (verdict.code == Verdict::malformed)
    throw std::runtime_error(verdict.reason);
  print(before + verdict.line + "\n");
  if (!verdict.reason.empty())
    std::fprintf(stderr, "%s\n", verdict.reason.c_str());
  return verdict.code;
}

int run(std::vector<std::string> arguments) {
  if (arguments.size() == 1 && (arguments[0] == "-h" || arguments[0] == "--help"))
    return print(help);
  if (arguments.size() == 1 && arguments[0] == "--version")
    return print(std::string("mdm-check " MDM_CHECK_VERSION " (GMP ") + gmp_version + ")\n");
  const bool printing = !arguments.empty() && arguments[0] == "--print";
  if (printing)
    arguments.erase(arguments.begin());
  for (const std::string &argument : arguments)
    if (argument.size() > 1 && argument[0] == '-')
      fail("mdm-check", "no option " + quoted(argument) + ": see mdm-check --help");
  const bool printing_alone = printing && arguments.size() == 1;
  if ((arguments.size() != 2 && !printing_alone) || std::count(arguments.begin(), arguments.end(), "-") > 1)
    fail("mdm-check", "give one gradation and one certificate: see mdm-check --help");
  const Input gradation = read_input(arguments[0], std::size_t{64} << 20U);
  if (printing_alone)
    return report(print(gradation));
  const Input certificate = read_input(arguments[1], std::size_t{256} << 20U);
  std::string csv;
  if (printing) {
    const Verdict printed = print(gradation);
    if (printed.code == Verdict::malformed)
      return report(printed);
    csv = printed.line + "\n";
  }
  return report(check(gradation, certificate), csv);
}

} // namespace

int main(int argc, char **argv) {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  std::set_new_handler(out_of_memory);
  mp_set_memory_functions([](std::size_t size) { return reallocate(nullptr, 0, size); }, reallocate, nullptr);
  try {
    return run({argv + (argc > 0 ? 1 : 0), argv + argc});
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return Verdict::malformed;
  }
}
