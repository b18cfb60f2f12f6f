#include "suite.hpp"

#include "program_files.hpp"
#include "proof_stream.hpp"
#include "text.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace mdm::checker {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view proof_ending = ".proof";
/// Of a budget of mdm batch: that the next finer tolerance, or size factor, needs more particles.
constexpr std::string_view finer_ending = ".proof.finer";
/// Of mdm batch and mdm crosscheck.
constexpr std::string_view gradation_endings[] = {".gradation", ".gradation.json"};

/// The path that a name means: names are UTF-8, and Windows would take each byte of a plain text for a letter
/// of its own.
fs::path path_of(const std::string &name) {
  return {std::u8string(name.begin(), name.end())};
}

std::string name_of(const fs::path &path) {
  const std::u8string name = path.u8string();
  return {name.begin(), name.end()};
}

/// The names in a folder that have an ending, without it.
std::set<std::string> names_with(std::string_view ending, const std::string &folder) {
  std::set<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(path_of(folder), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = name_of(entry->path().filename());
    if (name.ends_with(ending))
      names.insert(name.substr(0, name.size() - ending.size()));
  }
  if (error)
    fail(folder, "cannot be read: " + error.default_error_condition().message() +
                     ": give the folder of the certificates, or a suite and their stream");
  return names;
}

std::string path_in(const std::string &folder, const std::string &name, std::string_view ending) {
  return name_of(path_of(folder) / path_of(name + std::string(ending)));
}

/// NUMBER of a name NUMBER or NUMBER-ID; 0, which is no line, where it has none.
std::uint64_t number_of(const std::string &name) {
  constexpr std::size_t most_digits = 18;
  const auto end = std::find_if_not(name.begin(), name.end(), is_digit);
  const auto digits = static_cast<std::size_t>(end - name.begin());
  const bool is_number = digits > 0 && digits <= most_digits && (end == name.end() || *end == '-');
  return is_number ? std::stoull(name.substr(0, digits)) : 0;
}

using NumberedPaths = std::multimap<std::uint64_t, std::string>;

NumberedPaths numbered_paths(const std::string &folder, std::string_view ending) {
  NumberedPaths paths;
  for (const std::string &name : names_with(ending, folder))
    paths.emplace(number_of(name), path_in(folder, name, ending));
  return paths;
}

bool is_blank(const Input &line) {
  return line.text.find_first_not_of(" \t\r") == std::string::npos;
}

/// Says that a line has a certificate and no answer, where there is a file of answers.
bool misses_answer(const std::optional<Answers> &answers, const SharedAnswer &answer, const Input &line,
                   Verdicts &verdicts) {
  if (!answers || answer)
    return false;
  verdicts.missing(printable(line.name) + ": no answer in " + checker::quoted(answers->name()));
  return true;
}

void check_end(std::optional<Answers> &answers, const std::string &suite) {
  if (!answers)
    return;
  if (const SharedAnswer more = answers->next())
    throw Answers::Broken(more->place + ": no line of " + checker::quoted(suite) +
                          " is left for it: give the answers of this suite");
}

/// Hands on the lines of a suite with the certificates of a stream.
void check_lines(InputLines &lines, ProofStream &proofs, std::optional<Answers> &answers,
                 Verdicts &verdicts) {
  while (const std::optional<Input> line = lines.next()) {
    const bool has_proof = proofs.number() == lines.number();
    if (has_proof && is_blank(*line))
      throw ProofStream::Broken(printable(proofs.place()) + ": line " + std::to_string(lines.number()) +
                                " is blank: give the suite of these proofs");
    if (is_blank(*line))
      continue;
    const SharedAnswer answer = answers ? answers->of(*line, lines.number()) : nullptr;
    if (!has_proof)
      verdicts.missing(printable(line->name) + ": no certificate in the stream");
    while (proofs.number() == lines.number()) {
      StreamedProof proof = proofs.take();
      if (proof.sample)
        verdicts.check_sample(*line, std::move(*proof.sample), std::move(proof.certificate));
      else if (!misses_answer(answers, answer, *line, verdicts))
        verdicts.check(*line, std::move(proof.certificate), answer);
    }
  }
  if (proofs.number())
    throw ProofStream::Broken(printable(proofs.place()) + ": no line " + std::to_string(*proofs.number()) +
                              " in " + checker::quoted(lines.name()) + ": give the suite of these proofs");
  proofs.check_end();
  check_end(answers, lines.name());
}

int check_stream(const std::string &suite, const std::string &stream, const Manner &manner,
                 std::optional<Answers> &answers) {
  Verdicts verdicts(manner);
  InputLines lines(suite);
  try {
    ProofStream proofs(stream);
    if (answers && proofs.has_samples())
      fail(stream,
           "its certificates are of the answers of another solver, which stand in it: leave out --answers");
    check_lines(lines, proofs, answers, verdicts);
  } catch (const ProofStream::Broken &error) {
    verdicts.malformed(error.what());
  } catch (const Answers::Broken &error) {
    verdicts.malformed(error.what());
  }
  return verdicts.end(lines.name());
}

/// Hands on the lines of a suite with the certificates of a folder, and takes these out of the lists.
void check_lines(InputLines &lines, NumberedPaths &proofs, NumberedPaths &finer, const std::string &folder,
                 std::optional<Answers> &answers, Verdicts &verdicts) {
  while (const std::optional<Input> line = lines.next()) {
    if (is_blank(*line))
      continue;
    const SharedAnswer answer = answers ? answers->of(*line, lines.number()) : nullptr;
    const auto [first, last] = proofs.equal_range(lines.number());
    for (auto proof = first; proof != last; ++proof)
      if (!misses_answer(answers, answer, *line, verdicts))
        verdicts.check_file(*line, proof->second, answer);
    if (first == last)
      verdicts.missing(printable(line->name) + ": no certificate in " + checker::quoted(folder));
    proofs.erase(first, last);
    const auto [first_finer, last_finer] = finer.equal_range(lines.number());
    for (auto proof = first_finer; proof != last_finer; ++proof)
      verdicts.check_file(*line, proof->second);
    finer.erase(first_finer, last_finer);
  }
  check_end(answers, lines.name());
}

int check_suite_folder(const std::string &suite, const std::string &folder, const Manner &manner,
                       std::optional<Answers> &answers) {
  NumberedPaths proofs = numbered_paths(folder, proof_ending), finer = numbered_paths(folder, finer_ending);
  Verdicts verdicts(manner);
  InputLines lines(suite);
  try {
    check_lines(lines, proofs, finer, folder, answers, verdicts);
  } catch (const Answers::Broken &error) {
    verdicts.malformed(error.what());
    return verdicts.end(lines.name());
  }
  proofs.merge(finer);
  for (const auto &[number, proof] : proofs)
    verdicts.malformed(printable(proof) + ": begins with the number of no line of " +
                       checker::quoted(lines.name()));
  return verdicts.end(lines.name());
}

/// Judges a certificate against the gradation in a file.
void check_beside(const std::string &gradation, const std::string &proof, Verdicts &verdicts) {
  try {
    verdicts.check_file(read_input(gradation, most_gradation_bytes), proof);
  } catch (const std::runtime_error &error) {
    verdicts.malformed(error.what());
  }
}

} // namespace

int check_suite(const std::string &suite, const std::string &proofs, const Manner &manner,
                const std::optional<std::string> &name_of_answers) {
  std::optional<Answers> answers;
  if (name_of_answers)
    answers.emplace(*name_of_answers);
  std::error_code is_not_there; // a folder's reader says so
  return fs::is_directory(path_of(proofs), is_not_there) || is_not_there
             ? check_suite_folder(suite, proofs, manner, answers)
             : check_stream(suite, proofs, manner, answers);
}

int check_folder(const std::string &folder, const Manner &manner) {
  const std::set<std::string> proofs = names_with(proof_ending, folder),
                              finer = names_with(finer_ending, folder);
  std::map<std::string, std::string> gradations;
  for (const std::string_view ending : gradation_endings)
    for (const std::string &name : names_with(ending, folder))
      gradations.emplace(name, path_in(folder, name, ending));
  std::set<std::string> all = proofs;
  all.insert(finer.begin(), finer.end());
  for (const auto &[name, path] : gradations)
    all.insert(name);
  Verdicts verdicts(manner);
  for (const std::string &name : all) {
    const std::string proof = path_in(folder, name, proof_ending);
    const auto gradation = gradations.find(name);
    if (gradation == gradations.end()) {
      verdicts.missing(printable(proof) + ": no gradation beside it: give the suite");
      continue;
    }
    if (proofs.count(name) > 0)
      check_beside(gradation->second, proof, verdicts);
    else
      verdicts.missing(printable(gradation->second) + ": no certificate beside it");
    if (finer.count(name) > 0)
      check_beside(gradation->second, path_in(folder, name, finer_ending), verdicts);
  }
  return verdicts.end(folder);
}

} // namespace mdm::checker
