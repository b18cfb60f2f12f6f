#include "suite.hpp"

#include "program_files.hpp"
#include "text.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace mdm::checker {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view proof_ending = ".proof", gradation_ending = ".gradation";

/// The names in a folder that have an ending, without it.
std::set<std::string> names_with(std::string_view ending, const std::string &folder) {
  std::set<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.ends_with(ending))
      names.insert(name.substr(0, name.size() - ending.size()));
  }
  if (error)
    fail(folder, "cannot be read: " + error.message() + ": give the folder of the certificates");
  return names;
}

std::string path_of(const std::string &folder, const std::string &name, std::string_view ending) {
  return (fs::path(folder) / (name + std::string(ending))).string();
}

/// NUMBER of a name NUMBER or NUMBER-ID; 0, which is no line, where it has none.
std::uint64_t number_of(const std::string &name) {
  constexpr std::size_t most_digits = 18;
  const auto end = std::find_if_not(name.begin(), name.end(), is_digit);
  const auto digits = static_cast<std::size_t>(end - name.begin());
  const bool is_number = digits > 0 && digits <= most_digits && (end == name.end() || *end == '-');
  return is_number ? std::stoull(name.substr(0, digits)) : 0;
}

/// The verdicts, as they are written and counted.
class Summary {
public:
  explicit Summary(bool verbose) : verbose_(verbose) {}

  void check(const Input &gradation, const std::string &certificate) {
    Verdict verdict = {Verdict::malformed, {}, {}};
    try {
      verdict = checker::check(gradation, read_input(certificate, most_certificate_bytes));
    } catch (const std::runtime_error &error) {
      verdict.reason = error.what();
    }
    if (verdict.code == Verdict::accepted)
      accept(verdict.line);
    else if (verdict.code == Verdict::refused)
      add(refused_, "refused: " + verdict.reason);
    else
      malformed(verdict.reason);
  }
  void malformed(const std::string &reason) { add(malformed_, "malformed: " + reason); }
  void missing(const std::string &what) { add(missing_, "missing: " + what); }

  /// Writes the numbers of all, which are of `what`, and returns the worst code.
  int end(const std::string &what) const {
    if (accepted_ + refused_ + malformed_ + missing_ == 0)
      fail(what, "nothing to check: give the suite and the folder of mdm batch --proofs");
    const auto count = [](std::uint64_t n, const char *of) { return std::to_string(n) + " " + of; };
    print(printable(what) + ": " + count(accepted_, "accepted, ") + count(refused_, "refused, ") +
          count(malformed_, "malformed, ") + count(missing_, "missing\n"));
    return malformed_ > 0            ? Verdict::malformed
           : refused_ + missing_ > 0 ? Verdict::refused
                                     : Verdict::accepted;
  }

private:
  void accept(const std::string &line) {
    ++accepted_;
    if (verbose_)
      print(line + "\n");
  }
  static void add(std::uint64_t &count, const std::string &line) {
    ++count;
    print(line + "\n");
  }

  bool verbose_;
  std::uint64_t accepted_ = 0, refused_ = 0, malformed_ = 0, missing_ = 0;
};

} // namespace

int check_suite(const std::string &suite, const std::string &folder, bool verbose) {
  std::multimap<std::uint64_t, std::string> proofs;
  for (const std::string &name : names_with(proof_ending, folder))
    proofs.emplace(number_of(name), path_of(folder, name, proof_ending));
  Summary summary(verbose);
  InputLines lines(suite);
  while (const std::optional<Input> line = lines.next()) {
    if (line->text.find_first_not_of(" \t\r") == std::string::npos)
      continue;
    const auto [first, last] = proofs.equal_range(lines.number());
    for (auto proof = first; proof != last; ++proof)
      summary.check(*line, proof->second);
    if (first == last)
      summary.missing(printable(line->name) + ": no certificate in " + checker::quoted(folder));
    proofs.erase(first, last);
  }
  for (const auto &[number, proof] : proofs)
    summary.malformed(printable(proof) + ": begins with the number of no line of " +
                      checker::quoted(lines.name()));
  return summary.end(lines.name());
}

int check_folder(const std::string &folder, bool verbose) {
  const std::set<std::string> proofs = names_with(proof_ending, folder),
                              gradations = names_with(gradation_ending, folder);
  std::set<std::string> all = proofs;
  all.insert(gradations.begin(), gradations.end());
  Summary summary(verbose);
  for (const std::string &name : all) {
    const std::string proof = path_of(folder, name, proof_ending),
                      gradation = path_of(folder, name, gradation_ending);
    if (proofs.count(name) == 0)
      summary.missing(printable(gradation) + ": no certificate beside it");
    else if (gradations.count(name) == 0)
      summary.missing(printable(proof) + ": no gradation beside it: give the suite");
    else
      try {
        summary.check(read_input(gradation, most_gradation_bytes), proof);
      } catch (const std::runtime_error &error) {
        summary.malformed(error.what());
      }
  }
  return summary.end(folder);
}

} // namespace mdm::checker
