// Certificates of samples (section 12), worked out by hand. tests/certificates/forge_samples.py judges random
// ones.

#include "catch.hpp"
#include "program.hpp"

#include <mdm/checker.hpp>

#include <algorithm>

namespace sample_certificates_test {

using namespace mdm_check_test;
using mdm::checker::Verdict;

namespace {

const std::string gradation = "size_mm,mass\n1,2\n2,1\n3,0\n", sample = "size_mm,quantity\n1.5,2\n2.5,1\n";
const std::string certificate =
    "mdm-certificate sample 1\nlaw 1\nretained 15\nparticles 3\nclass 1 2 600/11\n"
    "class 2 1 500/11\nretained-error 1 12.1212 12.1213\n"
    "passing-error 1 12.1212 12.1213\ntotal-error 24.2424 24.2425\n"
    "conditions yes yes yes no\nverdict match\nend\n";

std::string replaced(std::string text, const std::string &old, const std::string &by) {
  const std::size_t at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), by);
}

/// The sample comes in pieces of so many bytes.
Verdict judged(const std::string &of, const std::string &proof, std::size_t piece = 7) {
  std::size_t taken = 0;
  return mdm::checker::check_sample({"sand.csv", gradation}, "s.csv",
                                    [&] {
                                      const std::string_view next =
                                          std::string_view(of).substr(std::min(taken, of.size()), piece);
                                      taken += next.size();
                                      return next;
                                    },
                                    {"s.proof", proof});
}

int code(const std::string &old, const std::string &by) {
  return judged(sample, replaced(certificate, old, by)).code;
}

std::string of_sample(const std::string &text) {
  const Verdict verdict = judged(text, certificate);
  CHECK(verdict.code == Verdict::malformed);
  CHECK(verdict.line.empty());
  return verdict.reason;
}

bool begins(const std::string &text, const std::string &beginning) {
  return text.rfind(beginning, 0) == 0;
}

} // namespace

TEST_CASE("the checker accepts what is true of a sample, and says all of it", "[checker]") {
  for (const std::size_t piece : {1U, 3U, 100U})
    CHECK(judged(sample, certificate, piece).line ==
          "accepted: the 3 particles of \"s.csv\" match \"sand.csv\" within a tolerance; the largest error "
          "of a "
          "share is 12.1212 to 12.1213 %, in class 1; of what passes 12.1212 to 12.1213 %, at the upper "
          "opening "
          "of class 1; all together 24.2424 to 24.2425 %; conditions 1 yes, 2 yes, 3 yes, 4 no (retained "
          "within "
          "15% of the total mass; mass law x^1; sizes in mm)");
}

TEST_CASE("the checker accepts that a sample does not match, and says why", "[checker]") {
  const std::string within_10 = replaced(certificate, "retained 15", "retained 10");
  CHECK(judged(sample, within_10).code == Verdict::refused);
  const Verdict verdict =
      judged(sample, replaced(within_10, "verdict match", "verdict class 1 54.5454 54.5455 least 56.6666"));
  CHECK(begins(verdict.line,
               "accepted: the 3 particles of \"s.csv\" do not match \"sand.csv\" within a tolerance: "
               "class 1 holds 54.5454 to 54.5455 %, and at least 56.6666 % are asked for; the largest"));
  CHECK(judged(sample, replaced(within_10, "verdict match", "verdict class 1 54.5454 54.5455 least 56.6667"))
            .code == Verdict::refused);
  CHECK(
      judged(sample, replaced(within_10, "verdict match", "verdict class 1 54.5454 54.5455 most 40")).code ==
      Verdict::refused);
}

TEST_CASE("the checker refuses each number of a sample's certificate that is wrong", "[checker]") {
  CHECK(code("particles 3", "particles 4") == Verdict::refused);
  CHECK(code("particles 3", "particles 3\nbelow 1") == Verdict::refused);
  CHECK(code("class 1 2 ", "class 1 3 ") == Verdict::refused);
  CHECK(code("600/11", "601/11") == Verdict::refused);
  CHECK(code("600/11", "54.5455 54.5456") == Verdict::refused);
  CHECK(code("600/11", "54.5 54.6") == Verdict::accepted);
  CHECK(code("class 2 1 500/11\n", "") == Verdict::refused);
  CHECK(code("retained-error 1 12.1212", "retained-error 1 12.1213") == Verdict::refused);
  CHECK(code("passing-error 1 12.1212 12.1213\n", "") == Verdict::refused);
  CHECK(code("total-error 24.2424 24.2425", "total-error 24.2424 24.2424") == Verdict::refused);
  CHECK(code("yes yes yes no", "yes yes yes yes") == Verdict::refused);
  CHECK(code("yes yes yes no", "yes yes open no") == Verdict::refused);
  CHECK(code("verdict match", "verdict outside") == Verdict::refused);
  CHECK(code("law 1\n", "law 2\n") == Verdict::refused);
  CHECK(code("particles 3", "places 3\nparticles 3") == Verdict::refused);
}

TEST_CASE("the checker cannot read a sample's certificate of another form", "[checker]") {
  CHECK(code("sample 1", "sample 2") == Verdict::malformed);
  CHECK(code("particles 3", "particles 03") == Verdict::malformed);
  CHECK(code("600/11", "1200/22") == Verdict::malformed);
  CHECK(code("12.1212 12.1213", "12.1213 12.1212") == Verdict::malformed);
  CHECK(code("600/11", "54.5 54.5") == Verdict::malformed);
  CHECK(code("yes no\n", "maybe no\n") == Verdict::malformed);
  CHECK(code("verdict match", "verdict total 1 2 least 3") == Verdict::malformed);
  CHECK(code("end\n", "end\n\n") == Verdict::malformed);
  CHECK(judged(sample, replaced(certificate, "600/11", "0.5")).reason.rfind("s.proof:5: ", 0) == 0);
}

TEST_CASE("the checker reads a sample of no other form, and names its line", "[checker]") {
  CHECK(begins(of_sample(""), "s.csv:1: the file is empty"));
  CHECK(begins(of_sample("size_mm\n"), "s.csv:2: there are no particles"));
  CHECK(begins(of_sample("{\"sizes\": [1.5]}\n"),
               "s.csv:1: '{\"sizes\": [1.5]}' is no header of a sample that can be "
               "checked: mdm verify --proof writes one"));
  CHECK(begins(of_sample("size_mm,quantity\n1.5,2\n2.5, 1\n"), "s.csv:3: "));
  CHECK(begins(of_sample("size_mm,quantity\n1.5,2\n2.5,1"), "s.csv:3: the last line has no end"));
  CHECK(begins(of_sample("size_mm,quantity\n1.5,2\n\n"), "s.csv:3: the row has not as many fields"));
  CHECK(begins(of_sample("size_mm,quantity\n1.5,0\n"), "s.csv:2: a quantity is 0"));
  CHECK(begins(of_sample("size_mm\r\n1.5\r\n"), "s.csv:1: "));
  CHECK(begins(of_sample("size_mm\n-1\n"), "s.csv:2: a size is not above 0"));
  CHECK(begins(of_sample("size_mm^1\n1\n"), "s.csv:1: '1' is no power"));
  CHECK(begins(of_sample("size_mm^2\n2/4\n"), "s.csv:2: '2/4' is not in lowest terms"));
  CHECK(begins(of_sample("size_lo_mm,size_hi_um\n1,2\n"), "s.csv:1: the upper bound"));
  CHECK(begins(of_sample("size_lo_mm,size_hi_mm\n>2,2\n"), "s.csv:2: the bounds of a size do not ascend"));
}

TEST_CASE("a sample has sizes at an opening, powers, ranges and units", "[checker]") {
  CHECK(judged("size_um,quantity\n1500,2\n2500,1\n", certificate).code == Verdict::accepted);
  CHECK(judged("size_mm\n1.5\n1.5\n2.5\n", certificate).code == Verdict::accepted);
  CHECK(judged("size_lo_mm,size_hi_mm,quantity\n1.5,1.5,2\n2.5,2.5,1\n", certificate).code ==
        Verdict::accepted);
  CHECK(judged("size_lo_mm,size_hi_mm,quantity\n>1.5,1.6,2\n2.5,2.5,1\n", certificate).code ==
        Verdict::refused);
  std::string at_opening = replaced(replaced(certificate, "600/11", "800/13"), "500/11", "500/13");
  for (const char *const name : {"retained-error 1 ", "passing-error 1 "})
    at_opening =
        replaced(at_opening, name + std::string("12.1212 12.1213"), name + std::string("5.1282 5.1283"));
  at_opening = replaced(at_opening, "24.2424 24.2425", "10.2564 10.2565");
  CHECK(judged("size_mm,quantity\n2,2\n2.5,1\n", at_opening).code == Verdict::accepted);
  CHECK(judged("size_mm^2,quantity\n4,2\n25/4,1\n", replaced(at_opening, "particles", "places 9\nparticles"))
            .code == Verdict::accepted);
}

namespace {

/// All folders of samples that tests/certificates/sample_cases.py writes in a folder have this verdict.
void judge_samples(const std::string &verdict, int exit_code, std::size_t least_tests) {
  std::size_t tests = 0;
  for (const auto &entry : std::filesystem::directory_iterator(std::filesystem::path(MDM_CERTIFICATES_DIR) /
                                                               "samples" / verdict)) {
    const std::filesystem::path csv = entry.path() / "gradation.csv";
    const std::filesystem::path g = std::filesystem::exists(csv) ? csv : entry.path() / "gradation.json";
    const Outcome outcome = run({g, entry.path() / "sample.csv", entry.path() / "proof"});
    INFO(entry.path() << "\n" << outcome.out << outcome.err);
    CHECK(outcome.exit_code == exit_code);
    CHECK(outcome.out.empty() == (exit_code == 2));
    CHECK(outcome.err.empty() == (exit_code == 0));
    ++tests;
  }
  CHECK(tests >= least_tests);
}

} // namespace

TEST_CASE("the checker judges the samples that tests/certificates makes", "[checker]") {
  judge_samples("accepted", 0, 25);
  judge_samples("enclosed", 0, 5);
  judge_samples("rejected", 1, 45);
  judge_samples("unparsable", 2, 50);
}

TEST_CASE("the program judges three files, and says what is missing with two", "[checker]") {
  const TemporaryFolder folder;
  const std::string g = write_file(folder.path() / "g.csv", gradation),
                    s = write_file(folder.path() / "s.csv", sample),
                    proof = write_file(folder.path() / "s.proof", certificate);
  const Outcome accepted = run({g, s, proof});
  CHECK(accepted.exit_code == 0);
  CHECK(begins(accepted.out, "accepted: the 3 particles of "));
  CHECK(run({g, "-", proof}, s).out.find("the 3 particles of \"standard input\" match") != std::string::npos);
  const Outcome two = run({g, proof});
  CHECK(two.exit_code == 2);
  CHECK(two.err.find("it is a certificate of a sample: give the sample before it") != std::string::npos);
  write_file(proof, replaced(certificate, "particles 3", "particles 2"));
  const Outcome refused = run({g, s, proof});
  CHECK(refused.exit_code == 1);
  CHECK(begins(refused.out, "refused: the certificate does not prove its claim about \""));
  CHECK(run({g, s, s, proof}).exit_code == 2);
  CHECK(run({g, (folder.path() / "none").string(), proof}).exit_code == 2);
}

} // namespace sample_certificates_test
