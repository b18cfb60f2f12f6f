#include "program_files.hpp"
#include "standard_streams.hpp"
#include "suite.hpp"
#include "text.hpp"
#include "verdicts.hpp"

#include <mdm/checker.hpp>

#include <gmp.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

namespace {

using namespace mdm::checker;

constexpr const char *help = R"(mdm-check GRADATION CERTIFICATE
mdm-check GRADATION SAMPLE CERTIFICATE
mdm-check SPECIFICATION STOCKPILE STOCKPILE ... CERTIFICATE
mdm-check --print GRADATION [CERTIFICATE]
mdm-check --suite [SUITE] FOLDER [--answers ANSWERS] [-j THREADS] [--verbose]
mdm-check --suite SUITE STREAM [--answers ANSWERS] [-j THREADS] [--verbose]

Checks the proof that a number of particles is the smallest that matches a gradation exactly
or within a tolerance, or the proof of bounds on the smallest.
GRADATION is the gradation file (CSV or JSON; or that of a band) and CERTIFICATE what
mdm solve --proof wrote; one of them may be - for standard input.
Three files are also a gradation, a sample of particles in canonical CSV, and what mdm verify
--proof or mdm published --proof wrote of them: counts, shares, errors, and whether the sample
matches. A verdict that it does not match is accepted too, where it is true: the line says so.
With other files than these, more than two, the first is the specification of a blend, the limits of
what passes, and CERTIFICATE what mdm blend --proof wrote of the stockpiles, in their order.
SUITE has a gradation in JSON a line and FOLDER what mdm batch --proofs wrote of it: each
certificate is checked against the line whose number its name begins with, also NAME.proof.finer,
which says that the next finer step of a budget needs more particles. Without SUITE, each
NAME.proof is checked against NAME.gradation beside it. FOLDER may also be of mdm crosscheck
--proofs: NAME.proof is then of NAME.sample.csv, and beside it is NAME.gradation.json. STREAM has
all certificates of a suite one after the other, of mdm crosscheck --proofs each behind its sample,
and STREAM.index says which line each is of. A file whose name ends in .zst is unpacked.
A certificate says what was asked. With ANSWERS, what mdm batch wrote of SUITE (JSON or CSV), each
is compared with the answer of its line: the number, quantities, sizes and openings; of JSON also
the question, which CSV does not have, and not the budget. Read the questions in the last line.

Examples:
  mdm solve sand.csv --proof sand.proof
  mdm-check sand.csv sand.proof
  mdm-check limits.csv A.csv B.csv mix.proof
  mdm-check sand.csv sizes.csv sizes.proof
  mdm-check --print sand.csv
  mdm batch suite.jsonl --proofs proofs && mdm-check --suite suite.jsonl proofs
  mdm batch suite.jsonl --proofs a.proofs && mdm-check --suite suite.jsonl a.proofs -j 2
  mdm crosscheck suite.jsonl answers.csv --proofs b.proofs
  mdm-check --suite suite.jsonl b.proofs
  mdm-check --suite suite.jsonl proofs --answers answers.jsonl

Exits with 0 (accepted), 1 (refused: the certificate does not prove its claim) or
2 (malformed: a file cannot be read, or the command is wrong). The verdict is on standard
output, the reason of another one than accepted on standard error. With --suite all is on
standard output, with the number of each verdict and each question in the last line, and the
worst one is the exit code: a line without a certificate, and a certificate that differs from its
answer, count as refused, a certificate without a line as malformed.

  --print     the gradation as it is read, as CSV on standard output, before the verdict
  --suite     all certificates of a folder or a stream: those that are not accepted, and a summary
  --answers   with --suite and SUITE, the answers that the certificates are compared with
  -j THREADS  with --suite, check by so many threads: 1 (without) to 1024
  --verbose   with --suite, also the verdicts of those that are accepted
  -h, --help  this text
  --version   the versions of this program and of GMP
)";

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

/// Writes a verdict behind a text, unless a file is malformed.
int report(const Verdict &verdict, const std::string &before = {}) {
  if (verdict.code == Verdict::malformed)
    throw std::runtime_error(verdict.reason);
  print(before + verdict.line + "\n");
  if (!verdict.reason.empty())
    std::fprintf(stderr, "%s\n", verdict.reason.c_str());
  return verdict.code;
}

/// The words of the command line: names of files, and flags.
struct Words {
  std::vector<std::string> files;
  bool prints = false, has_suite = false;
  Manner manner = {};
  std::optional<std::string> answers = {};
};

/// Takes `-j THREADS` or `-jTHREADS` out of the arguments.
unsigned take_threads(std::vector<std::string> &arguments) {
  constexpr unsigned long most = 1024;
  const auto option = std::find_if(arguments.begin(), arguments.end(),
                                   [](const std::string &a) { return a.starts_with("-j"); });
  if (option == arguments.end())
    return 1;
  auto end = option + 1;
  std::string number = option->substr(2);
  if (number.empty() && end != arguments.end())
    number = *end++;
  const bool is_number =
      !number.empty() && number.size() <= 4 && std::all_of(number.begin(), number.end(), is_digit);
  const unsigned long threads = is_number ? std::stoul(number) : 0;
  if (threads < 1 || threads > most)
    fail("mdm-check",
         "-j: " + quoted(number) + " is no number of threads from 1 to 1024: see mdm-check --help");
  arguments.erase(option, end);
  return static_cast<unsigned>(threads);
}

/// Takes `--answers FILE` out of the arguments.
std::optional<std::string> take_answers(std::vector<std::string> &arguments) {
  const auto option = std::find(arguments.begin(), arguments.end(), "--answers");
  if (option == arguments.end())
    return std::nullopt;
  if (option + 1 == arguments.end())
    fail("mdm-check", "--answers: no file behind it: see mdm-check --help");
  std::string file = option[1];
  arguments.erase(option, option + 2);
  return file;
}

Words words_of(std::vector<std::string> arguments) {
  Words words;
  words.prints = !arguments.empty() && arguments[0] == "--print";
  words.has_suite = !arguments.empty() && arguments[0] == "--suite";
  if (words.prints || words.has_suite)
    arguments.erase(arguments.begin());
  if (words.has_suite) {
    words.manner.verbose = std::erase(arguments, "--verbose") > 0;
    words.answers = take_answers(arguments);
    words.manner.threads = take_threads(arguments);
  }
  const char *const there_are = words.has_suite ? " behind --suite: there are --answers, -j and --verbose"
                                                : " here: there are --print, --suite, --help and --version";
  for (const std::string &argument : arguments)
    if (argument.size() > 1 && argument[0] == '-')
      fail("mdm-check", "no option " + quoted(argument) + there_are + "; see mdm-check --help");
  words.files = std::move(arguments);
  return words;
}

int run_suite(const Words &words) {
  const std::vector<std::string> &files = words.files;
  if (files.empty() || files.size() > 2 || files.back() == "-")
    fail("mdm-check", "give one suite and one folder or stream behind --suite: see mdm-check --help");
  if (words.answers && files.size() == 1)
    fail("mdm-check", "--answers: answers have the order of a suite: give it behind --suite");
  return files.size() == 1 ? check_folder(files[0], words.manner)
                           : check_suite(files[0], files[1], words.manner, words.answers);
}

/// The specification, the stockpiles and the certificate of a blend; or the three files of a sample.
Verdict check_several_files(const std::vector<std::string> &files) {
  if (std::count(files.begin(), files.end(), "-") > 1)
    fail("mdm-check", "standard input can be one file alone: see mdm-check --help");
  const Input certificate = read_input(files.back(), most_certificate_bytes);
  if (is_sample_certificate(certificate.text)) {
    if (files.size() != 3)
      fail(certificate.name, "it is a certificate of a sample: give a gradation, a sample and it");
    return check_sample_file(read_input(files[0], most_gradation_bytes), files[1], certificate);
  }
  const Input specification = read_input(files.front(), most_gradation_bytes);
  std::vector<Input> stockpiles;
  for (std::size_t i = 1; i + 1 < files.size(); ++i)
    stockpiles.push_back(read_input(files[i], most_gradation_bytes));
  return check_blend(specification, stockpiles, certificate);
}

int run(const std::vector<std::string> &arguments) {
  if (arguments.size() == 1 && (arguments[0] == "-h" || arguments[0] == "--help")) {
    print(help);
    return Verdict::accepted;
  }
  if (arguments.size() == 1 && arguments[0] == "--version") {
    print(std::string("mdm-check " MDM_CHECK_VERSION " (GMP ") + gmp_version + ")\n");
    return Verdict::accepted;
  }
  const Words words = words_of(arguments);
  const std::vector<std::string> &files = words.files;
  if (words.has_suite)
    return run_suite(words);
  if (!words.prints && files.size() > 2)
    return report(check_several_files(files));
  const bool printing_alone = words.prints && files.size() == 1;
  if (std::count(files.begin(), files.end(), "-") > 1)
    fail("mdm-check", "standard input has one file: give the others by name");
  if (files.size() != 2 && !printing_alone)
    fail("mdm-check", "give one gradation and one certificate: see mdm-check --help");
  const Input gradation = read_input(files[0], most_gradation_bytes);
  if (printing_alone)
    return report(print(gradation));
  const Input certificate = read_input(files[1], most_certificate_bytes);
  if (is_sample_certificate(certificate.text))
    fail(certificate.name, "it is a certificate of a sample: give the sample before it, mdm-check GRADATION "
                           "SAMPLE CERTIFICATE");
  std::string csv;
  if (words.prints) {
    const Verdict printed = print(gradation);
    if (printed.code == Verdict::malformed)
      return report(printed);
    csv = printed.line + "\n";
  }
  return report(check(gradation, certificate), csv);
}

} // namespace

int main(int argc, char **argv) {
  settle_streams();
  std::set_new_handler(out_of_memory);
  mp_set_memory_functions([](std::size_t size) { return reallocate(nullptr, 0, size); }, reallocate, nullptr);
  try {
    return run({argv + (argc > 0 ? 1 : 0), argv + argc});
  } catch (const ClosedPipe &) {
    return Verdict::malformed; // the reader has what it wanted
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return Verdict::malformed;
  }
}
