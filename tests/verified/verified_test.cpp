// mdm-check and the program that is extracted from its proof of correctness must give every pair of files the
// same verdict.

#include "catch.hpp"
#include "files.hpp"
#include "match/brute_force.hpp"
#include "proof/gradation_files.hpp"
#include "verified/comparison.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/proof/certificate.hpp>
#include <mdm/text/error.hpp>

#include <fstream>

namespace verified_test {

using namespace verified_test;
using mdm::ratio;

namespace {

void demand_agreement(const Agreement &agreement, std::size_t accepted, std::size_t refused,
                      std::size_t malformed) {
  for (std::size_t i = 0; i < std::min<std::size_t>(agreement.differences.size(), 3); ++i)
    FAIL_CHECK(agreement.differences[i]);
  CHECK(agreement.differences.empty());
  CHECK(agreement.accepted >= accepted);
  CHECK(agreement.refused >= refused);
  CHECK(agreement.malformed >= malformed);
}

/// What the program writes to standard error about a pair of files g and p.
std::string said_of(const std::string &gradation, const std::string &certificate) {
  const mdm_test::TemporaryFolder folder;
  folder.write("g", gradation);
  folder.write("p", certificate);
  const std::string command = "cd '" + folder.path().string() + "' && '" MDM_VERIFIED "' g p 2>said";
  CHECK(WEXITSTATUS(std::system(command.c_str())) == 2);
  return mdm_test::read_file(folder / "said");
}

/// So many of the texts.
std::vector<std::string> some(const std::set<std::string> &texts, std::size_t count,
                              std::mt19937_64 &random) {
  std::vector<std::string> chosen(texts.begin(), texts.end());
  std::shuffle(chosen.begin(), chosen.end(), random);
  chosen.resize(std::min(chosen.size(), count));
  return chosen;
}

/// A text with bytes changed, and one with numbers and lines changed.
std::pair<std::set<std::string>, std::set<std::string>> changed(const std::string &text) {
  std::set<std::string> bytes, numbers;
  mdm_check_test::change_bytes(text, bytes);
  mdm_check_test::shift_numbers(text, numbers);
  mdm_check_test::rearrange(mdm_check_test::lines_of(text), "", "", "", numbers);
  return {bytes, numbers};
}

int below(std::mt19937_64 &random, unsigned end) {
  return static_cast<int>(random() % end);
}

mdm::Gradation random_gradation(std::mt19937_64 &random) {
  const mdm::Gradation g = brute::random_gradation(random);
  mdm::Gradation::Data data{g.id(), g.unit(), g.sizes(), g.masses(), {}, {}, {}, {}};
  for (std::size_t j = 0; j < g.sizes().size(); ++j) {
    if (g.has_factors())
      data.factors.push_back(ratio(1 + below(random, 9), 4));
    data.tolerances.push_back(ratio(below(random, 80), 4));
  }
  return mdm::Gradation(std::move(data));
}

mdm::Question random_question(const mdm::Gradation &g, bool tolerant, std::mt19937_64 &random) {
  using Kind = mdm::AskedTolerance::Kind;
  const Kind kinds[] = {Kind::retained, Kind::passing, Kind::total, Kind::retained_file, Kind::passing_file};
  const mdm::MassLaw laws[] = {{3, 1}, {3, 1}, {3, 1}, {2, 1}, {5, 2}, {1, 3}};
  mdm::Question q;
  q.law = laws[random() % (tolerant ? 4 : 6)];
  for (std::size_t i = tolerant ? 1 + random() % 2 : 0; i > 0; --i)
    q.tolerances.push_back({kinds[random() % 5], ratio(below(random, 120), 4)});
  if (random() % 4 == 0)
    q.min_per_class = 1 + below(random, 4);
  if (random() % 3 == 0)
    q.at_least = 1 + below(random, tolerant ? 20 : 60);
  if (random() % 4 == 0)
    q.size_factor = ratio(1 + below(random, 30), 10);
  if (random() % 4 == 0 && g.sizes().front() == 0)
    q.pan_size = g.sizes()[1] / 2;
  if (q.law.is_sphere() && random() % 6 == 0)
    q.solids = mdm::Cylinder{1 + below(random, 12), 1 + below(random, 12), ratio(7, 10)};
  if (q.law.is_sphere() && !q.solids && random() % 12 == 0)
    q.solids = mdm::SolidsVolume{ratio(1 + below(random, 1000), 10)};
  return q;
}

} // namespace

TEST_CASE("both checkers agree on all certificates that tests/certificates makes") {
  std::vector<Pair> pairs;
  for (const char *folder : {"accepted", "rejected", "unparsable"})
    for (const auto &named : certificates(folder))
      pairs.push_back(named.second);
  demand_agreement(compare(MDM_VERIFIED, pairs), 80, 100, 140);
}

TEST_CASE("Coq's own integers give the same verdicts") {
  std::vector<Pair> pairs;
  for (const char *folder : {"accepted", "rejected", "unparsable"})
    for (const auto &[name, pair] : certificates(folder))
      if (pair.certificate.size() < 10'000 && pair.certificate.find("\npi ") == std::string::npos) // slow
        pairs.push_back(pair);
  demand_agreement(compare(MDM_VERIFIED_BINARY, pairs), 75, 95, 130);
}

TEST_CASE("both checkers agree on changed certificates") {
  std::mt19937_64 random(31);
  std::vector<Pair> pairs;
  for (const auto &[name, pair] : certificates("accepted")) {
    auto [bytes, numbers] = changed(pair.certificate);
    if (name.rfind("tree_", 0) == 0)
      mdm_check_test::change_leaves(pair.certificate, numbers);
    for (const auto &texts : {some(bytes, 200, random), some(numbers, 300, random)})
      for (const std::string &text : texts)
        pairs.push_back({pair.gradation, text});
  }
  demand_agreement(compare(MDM_VERIFIED, pairs), 600, 4500, 12000);
}

TEST_CASE("both checkers agree on changed gradations") {
  std::mt19937_64 random(32);
  std::vector<Pair> pairs;
  for (const auto &[name, pair] : certificates("accepted")) {
    const auto [bytes, numbers] = changed(pair.gradation);
    for (const auto &texts : {some(bytes, 150, random), some(numbers, 50, random)})
      for (const std::string &text : texts)
        pairs.push_back({text, pair.certificate});
  }
  demand_agreement(compare(MDM_VERIFIED, pairs), 1000, 1500, 5000);
}

TEST_CASE("both checkers agree on the certificates of random questions, changed or not") {
  std::mt19937_64 random(33);
  std::vector<Pair> pairs;
  for (int i = 0; i < 3000; ++i) {
    const mdm::Gradation g = random_gradation(random);
    const mdm::Match m = mdm::solve(g, random_question(g, i % 3 == 0, random));
    REQUIRE(m.complete);
    const Pair pair{mdm::gradation_csv(g), mdm::certificate(m)};
    pairs.push_back(pair);
    std::set<std::string> changed;
    mdm_check_test::shift_numbers(pair.certificate, changed);
    for (const std::string &text : some(changed, 4, random))
      pairs.push_back({pair.gradation, text});
  }
  demand_agreement(compare(MDM_VERIFIED, pairs), 3000, 5000, 1000);
}

TEST_CASE("both checkers accept the proofs of the study's gradations within tolerances") {
  std::ifstream suite(MDM_SUITE);
  std::vector<Pair> pairs;
  std::size_t number = 0;
  for (std::string line; std::getline(suite, line); ++number)
    for (const char *tolerance : {"retained:1%", "passing:0.5%", "laboratory"}) {
      if (number % 5 != 0)
        continue;
      mdm::Question question;
      question.tolerances = {mdm::parse_tolerance(tolerance)};
      const mdm::Match m = mdm::solve(mdm::read_json_gradation(line, "suite", ""), question);
      pairs.push_back({line + "\n", mdm::certificate(m)});
    }
  demand_agreement(compare(MDM_VERIFIED, pairs), 1650, 0, 0);
}

TEST_CASE("both checkers read the same gradation from files of all kinds, changed or not") {
  std::mt19937_64 random(34);
  std::vector<Pair> pairs;
  mdm::SolveOptions options;
  options.limits.max_steps = 1000;
  options.digits = 40;
  for (std::size_t i = 0; i < 30000; ++i) {
    const std::string &seed = gradation_files::seeds[i % gradation_files::seeds.size()];
    const std::string text =
        i < gradation_files::seeds.size() ? seed : gradation_files::mutated(seed, random);
    try {
      const mdm::Match m = mdm::solve(mdm::read_gradation(text, "file"), {}, options);
      if (m.complete)
        pairs.push_back({text, mdm::certificate(m)});
    } catch (const mdm::InputError &) {
      pairs.push_back({text, "mdm-certificate 1\nlaw 3\nparticles 1\nscale 1\nclass 1 1 1 1\nchain\nend\n"});
    }
  }
  demand_agreement(compare(MDM_VERIFIED, pairs), 1000, 0, 10000);
}

TEST_CASE("both checkers agree on all samples that tests/certificates makes") {
  std::vector<Pair> pairs, enclosed;
  for (const char *verdict : {"accepted", "rejected", "unparsable"})
    for (const auto &named : samples(verdict))
      pairs.push_back(named.second);
  for (const std::string program : {MDM_VERIFIED, MDM_VERIFIED_BINARY}) {
    const Agreement agreement = compare(program, pairs);
    demand_agreement(agreement, 25, 45, 50);
    CHECK(agreement.not_taken == 0);
  }
  for (const auto &named : samples("enclosed"))
    enclosed.push_back(named.second);
  const Agreement agreement = compare(MDM_VERIFIED, enclosed);
  demand_agreement(agreement, 0, 0, 0);
  CHECK(agreement.not_taken == enclosed.size());
}

TEST_CASE("both checkers agree on changed samples, their certificates and gradations") {
  std::mt19937_64 random(35);
  std::vector<Pair> pairs;
  for (const auto &[name, pair] : samples("accepted"))
    for (std::string Pair::*const part : {&Pair::gradation, &Pair::certificate}) {
      const auto [bytes, numbers] = changed(pair.*part);
      for (const auto &texts : {some(bytes, 150, random), some(numbers, 150, random)})
        for (const std::string &text : texts) {
          pairs.push_back(pair);
          pairs.back().*part = text;
        }
    }
  for (const auto &[name, pair] : samples("accepted")) {
    const auto [bytes, numbers] = changed(*pair.sample);
    for (const auto &texts : {some(bytes, 150, random), some(numbers, 50, random)})
      for (const std::string &text : texts) {
        pairs.push_back(pair);
        pairs.back().sample = text;
      }
  }
  const Agreement agreement = compare(MDM_VERIFIED, pairs);
  demand_agreement(agreement, 500, 1500, 6000);
  CHECK(agreement.not_taken < pairs.size() / 100);
}

TEST_CASE("both checkers have the same limits for samples") {
  const std::string gradation = "size_mm,mass\n1,2\n2,1\n3,0\n";
  const auto certificate = [](const std::string &law) {
    return "mdm-certificate sample 1\nlaw " + law +
           "\nretained 100\npassing 100\nparticles 1\nclass 1 1 100\nclass 2 0 0\nretained-error 1 33 34\n"
           "passing-error 1 33 34\ntotal-error 66 67\nconditions yes yes yes no\nverdict match\nend\n";
  };
  // 2 * 1000 times the bits of a size of 158 digits or so is above 2^20, and so is the common denominator of
  // many sizes.
  std::vector<Pair> pairs;
  for (std::size_t digits = 150; digits < 165; ++digits)
    pairs.push_back({gradation, certificate("1000"), "size_mm\n1." + std::string(digits, '0') + "1\n"});
  for (std::size_t digits = 300; digits < 330; digits += 5) {
    const std::string opening = "2." + std::string(digits, '0') + "1";
    pairs.push_back(
        {"size_mm,mass\n1,2\n" + opening + ",1\n3,0\n", certificate("1000"), "size_mm^1000\n3\n"});
    pairs.push_back(
        {"size_mm,mass\n1,2\n" + opening + ",1\n3,0\n", certificate("6000"), "size_mm^3000\n3\n"});
  }
  for (std::size_t digits = 1; digits < 5; ++digits)
    pairs.push_back(
        {"size_phi,mass\n0." + std::string(digits, '3') + ",2\n-1,0\n", certificate("3"), "size_mm\n1.5\n"});
  demand_agreement(compare(MDM_VERIFIED, pairs), 8, 0, 8);
}

TEST_CASE("both checkers have the same limits") {
  const std::string gradation = "size_mm,mass\n1,2\n2,1\n3,0\n";
  const auto certificate = [](const std::string &question, const std::string &N, const std::string &q) {
    return "mdm-certificate 1\nlaw 1000\n" + question + "particles " + N + "\nscale 10\nclass 1 " + q +
           " 1.5 1.5\nchain 2\nend\n";
  };
  // 1000 times the bits of a number of 316 digits or more is above 2^20.
  std::vector<Pair> pairs;
  for (std::size_t digits = 312; digits < 320; ++digits) {
    const std::string number = "1" + std::string(digits, '0');
    pairs.push_back({"size_mm,mass\n1,2\n2,1\n" + number + "1,0\n", certificate("", "4", "3")});
    pairs.push_back({"size_mm,mass\n1,2\n2," + number + "1\n3,0\n", certificate("", "4", "3")});
    pairs.push_back({gradation, certificate("", number, "3")});
    pairs.push_back({gradation, certificate("", "4", number)});
    pairs.push_back({gradation, certificate("at-least " + number + "\n", "4", "3")});
    pairs.push_back({gradation, certificate("min-per-class " + number + "\n", "4", "3")});
  }
  for (const int digits : {999, 1000})
    pairs.push_back({gradation, "mdm-certificate 1\nlaw 3\nsolids-volume 1\npi 3.1 3.2" +
                                    std::string(static_cast<std::size_t>(digits - 1), '4') +
                                    "\nparticles 4\nscale 10\nclass 1 3 1.5 1.5\nchain 2\nend\n"});
  demand_agreement(compare(MDM_VERIFIED, pairs), 0, 15, 15);
}

TEST_CASE(
    "both checkers have the same limits for lengths to the power of half-phi, and for the file of a band") {
  std::vector<Pair> pairs;
  // 4 times the bits of a number of 78,914 digits is about 2^20.
  for (const std::size_t digits : {1000U, 78'900U, 78'930U})
    for (const char *line : {"pan-size", "cut-below", "size-factor"})
      pairs.push_back({"size_phi,mass\npan,1\n0,2\n-0.25,1\n-1,0\n",
                       "mdm-certificate 1\nlaw 3\n" + std::string(line) + " " + std::string(digits, '9') +
                           "\nparticles 4\nscale 10\nclass 1 3 1.5 1.5\nchain 2\nend\n"});
  for (std::size_t zeros = 310; zeros < 320; ++zeros)
    pairs.push_back({"size_mm,passing_min_percent,passing_max_percent\n1,0,100\n2,0,1." +
                         std::string(zeros, '0') + "1\n3,0,100\n",
                     "mdm-certificate 1\nlaw 1000\nband file\nparticles none\nleaf 1 m\nend\n"});
  demand_agreement(compare(MDM_VERIFIED, pairs), 0, 8, 8);
}

TEST_CASE("the program says which certificates are those of mdm-check alone") {
  const std::string said = "p: its law is a table or a sum: use mdm-check\n";
  for (const std::string law : {"table 0 0 5 8", "sum 1 3 2 2"})
    CHECK(said_of("size_mm,mass\n1,2\n2,1\n3,0\n", "mdm-certificate 1\nlaw " + law + "\nparticles 4\n") ==
          said);
  CHECK(said_of("size_mm,mass\n1,2\n2,1\n3,0\n", "mdm-certificate 1\nlaw x\n") ==
        "p: a number of the line law: let mdm solve --proof write it again\n");
}

TEST_CASE("the program judges pairs, and says how it wants to be called") {
  const auto exit_code = [](const std::string &arguments) {
    const std::string program = "'" + std::string(MDM_VERIFIED) + "' ";
    return WEXITSTATUS(std::system((program + arguments + " >/dev/null 2>&1").c_str()));
  };
  const std::string folder = "'" MDM_CERTIFICATES_DIR "'/";
  const std::string good = " " + folder + "accepted/box.csv " + folder + "accepted/box.proof";
  const std::string other = " " + folder + "accepted/box.csv " + folder + "accepted/cut_below.proof";
  CHECK(exit_code(good) == 0);
  CHECK(exit_code("- " + folder + "accepted/box.proof <" + folder + "accepted/box.csv") == 0);
  CHECK(exit_code(good + other) == 1);
  CHECK(exit_code(other + good) == 1);
  CHECK(exit_code(other + " absent absent" + good) == 2);
  CHECK(exit_code("--help") == 0);
  CHECK(exit_code("--version") == 0);
  CHECK(exit_code("") == 2);
  CHECK(exit_code("--unknown" + good) == 2);
  CHECK(exit_code("- -") == 2);
  CHECK(exit_code(folder + "accepted/box.csv") == 2);
}

} // namespace verified_test
