#pragma once
/// \file
/// Judges pairs of files with the checker, in this process, and with a program that is extracted from Coq.

#include "checker/mutants.hpp"

#include <mdm/checker.hpp>

#include <cstdlib>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace verified_test {

using mdm::checker::Verdict;

/// A gradation file and a certificate; the latter of a sample, if there is one.
struct Pair {
  std::string gradation, certificate;
  std::optional<std::string> sample = {};
};

inline Verdict::Code code_of(const std::string &line) {
  return line.rfind("accepted: ", 0) == 0  ? Verdict::accepted
         : line.rfind("refused: ", 0) == 0 ? Verdict::refused
                                           : Verdict::malformed;
}

/// How often each verdict was the same.
struct Agreement {
  std::size_t accepted = 0, refused = 0, malformed = 0;
  std::size_t not_taken = 0; ///< samples that mdm-check takes, and the program says that it does not
  std::vector<std::string> differences; ///< both verdicts and the pair
};

inline bool is_not_taken(const std::string &line) {
  return line.ends_with(": use mdm-check");
}

/// What the checker says, in this process.
inline Verdict verdict_on(const Pair &pair, const std::function<std::string(const std::string &)> &file_of) {
  const mdm::checker::Input gradation{file_of(pair.gradation), pair.gradation},
      certificate{file_of(pair.certificate), pair.certificate};
  if (!pair.sample)
    return mdm::checker::check(gradation, certificate);
  std::string_view rest = *pair.sample;
  return mdm::checker::check_sample(
      gradation, file_of(*pair.sample), [&] { return std::exchange(rest, std::string_view()); }, certificate);
}

/// The program judges many pairs in one run, a line each and for a refusal another one with its reason. Where
/// both accept or refuse the lines must be the same too. All pairs have a sample, or none has.
inline Agreement compare(const std::string &program, const std::vector<Pair> &pairs) {
  constexpr std::size_t pairs_a_run = 2000;
  Agreement agreement;
  for (std::size_t begin = 0; begin < pairs.size(); begin += pairs_a_run) {
    const std::size_t end = std::min(begin + pairs_a_run, pairs.size());
    const mdm_check_test::TemporaryFolder folder;
    const auto path = [&](const std::string &name) { return (folder.path() / name).string(); };
    std::map<std::string, std::string> files; // by their text
    const auto file_of = [&](const std::string &text) {
      const auto [file, is_new] = files.try_emplace(text, path(std::to_string(files.size())));
      if (is_new)
        mdm_check_test::write_file(file->second, text);
      return file->second;
    };
    std::string names;
    for (std::size_t i = begin; i < end; ++i)
      names += file_of(pairs[i].gradation) + "\n" +
               (pairs[i].sample ? file_of(*pairs[i].sample) + "\n" : "") + file_of(pairs[i].certificate) +
               "\n";
    mdm_check_test::write_file(path("names"), names);
    const bool of_samples = pairs[begin].sample.has_value();
    const std::string command = "xargs -n " + std::to_string((of_samples ? 3 : 2) * pairs_a_run) +
                                " -s 1000000 '" + program + "' " + (of_samples ? "--samples" : "") + " <" +
                                path("names") + " >" + path("verdicts") + " 2>&1";
    if (std::system(command.c_str()) == -1) // refusals end it with another code: the verdicts say it
      throw std::runtime_error("xargs cannot be run");
    std::istringstream verdicts(mdm_check_test::read_file(path("verdicts")));
    for (std::size_t i = begin; i < end; ++i) {
      const Pair &pair = pairs[i];
      const Verdict verdict = verdict_on(pair, file_of);
      std::string line;
      std::getline(verdicts, line);
      const Verdict::Code code = line.empty() ? Verdict::malformed : code_of(line);
      if (code == Verdict::refused)
        verdicts.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
      if (pair.sample && is_not_taken(line) && verdict.code != Verdict::malformed)
        ++agreement.not_taken;
      else if (line.empty() || code != verdict.code || (code != Verdict::malformed && line != verdict.line))
        agreement.differences.push_back(verdict.line + "\nbut " + line + "\n" + pair.gradation +
                                        pair.certificate);
      else
        ++(code == Verdict::accepted  ? agreement.accepted
           : code == Verdict::refused ? agreement.refused
                                      : agreement.malformed);
    }
  }
  return agreement;
}

/// The pairs of a folder that tests/certificates/make.py writes, by the certificate's name.
inline std::map<std::string, Pair> certificates(const std::string &folder) {
  std::map<std::string, Pair> pairs;
  for (const auto &entry :
       std::filesystem::directory_iterator(std::filesystem::path(MDM_CERTIFICATES_DIR) / folder)) {
    std::filesystem::path gradation = entry.path();
    if (gradation.extension() != ".proof")
      continue;
    gradation.replace_extension(".csv");
    if (!std::filesystem::exists(gradation))
      gradation.replace_extension(".json");
    pairs[entry.path().stem().string()] = {mdm_check_test::read_file(gradation),
                                           mdm_check_test::read_file(entry.path())};
  }
  return pairs;
}

/// The samples of a folder that tests/certificates/make.py writes, by their folder's name.
inline std::map<std::string, Pair> samples(const std::string &verdict) {
  std::map<std::string, Pair> pairs;
  for (const auto &entry : std::filesystem::directory_iterator(std::filesystem::path(MDM_CERTIFICATES_DIR) /
                                                               "samples" / verdict)) {
    const std::filesystem::path csv = entry.path() / "gradation.csv";
    const auto text = [&](const std::filesystem::path &file) { return mdm_check_test::read_file(file); };
    pairs[entry.path().filename().string()] = {
        text(std::filesystem::exists(csv) ? csv : entry.path() / "gradation.json"),
        text(entry.path() / "proof"), text(entry.path() / "sample.csv")};
  }
  return pairs;
}

} // namespace verified_test
