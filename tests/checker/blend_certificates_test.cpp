// Every folder that tests/certificates/blends.py writes is a test: a specification, stockpiles and a
// certificate; the folder above says the verdict.

#include "catch.hpp"
#include "program.hpp"

#include <algorithm>

namespace blend_certificates_test {

using namespace mdm_check_test;

namespace {

const std::filesystem::path folders = std::filesystem::path(MDM_CERTIFICATES_DIR) / "blends";

Outcome judge(const std::filesystem::path &folder) {
  return run({folder / "limits.csv", folder / "1.csv", folder / "2.csv", folder / "proof"});
}

void judge_all(const std::string &verdict, int exit_code, const std::string &beginning,
               std::size_t least_tests) {
  std::size_t tests = 0;
  for (const auto &entry : std::filesystem::directory_iterator(folders / verdict)) {
    const Outcome outcome = judge(entry.path());
    INFO(entry.path() << "\n" << outcome.out << outcome.err);
    CHECK(outcome.exit_code == exit_code);
    const std::string &told = exit_code == 2 ? outcome.err : outcome.out;
    CHECK(told.rfind(beginning, 0) == 0);
    CHECK(std::count(told.begin(), told.end(), '\n') == 1);
    CHECK((exit_code == 2 ? outcome.out : exit_code == 0 ? outcome.err : std::string()).empty());
    ++tests;
  }
  CHECK(tests >= least_tests);
}

} // namespace

TEST_CASE("the checker accepts the certificates of blends that prove their claim", "[checker]") {
  judge_all("accepted", 0, "accepted: ", 14);
}

TEST_CASE("the checker refuses the certificates of blends that do not", "[checker]") {
  judge_all("rejected", 1, "refused: ", 17);
}

TEST_CASE("the checker cannot read certificates of blends of another form", "[checker]") {
  judge_all("unparsable", 2, folders.string(), 23);
}

TEST_CASE("the verdict on a blend names the blend, its value and the whole question", "[checker]") {
  const std::filesystem::path folder = folders / "accepted" / "cost";
  const std::string first = "\"" + (folder / "1.csv").string() + "\"",
                    second = "\"" + (folder / "2.csv").string() + "\"",
                    limits = "\"" + (folder / "limits.csv").string() + "\"";
  CHECK(judge(folder).out ==
        "accepted: the blend of 55, 45 steps of " + first + ", " + second + " keeps the limits of " + limits +
            ", and none has a lower cost than its 8719/1000 (shares in steps of 1/100; costs 7, "
            "541/50; sieves in mm 3/40, 19/4, 25/2, 19)\n");
  const std::string interpolated = judge(folders / "accepted" / "interpolated").out;
  CHECK(interpolated.find("1.csv\" interpolated linear in size at 8; ") != std::string::npos);
  CHECK(judge(folders / "accepted" / "impossible").out.find("accepted: no blend of ") == 0);
}

TEST_CASE("a stockpile that is given twice is refused, whatever the certificate says", "[checker]") {
  const std::filesystem::path folder = folders / "accepted" / "cost", one = folder / "1.csv";
  for (const std::filesystem::path &certificate : {folder / "proof", folder / "none"}) {
    const Outcome outcome = run({folder / "limits.csv", one, folder / "2.csv", one, certificate});
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
  }
  CHECK(run({folder / "limits.csv", one, one, folder / "proof"}).err ==
        one.string() + ": two stockpiles are this file: give each once\n");
}

TEST_CASE("stockpiles in another order, or one too few, are refused", "[checker]") {
  const std::filesystem::path folder = folders / "accepted" / "cost";
  CHECK(run({folder / "limits.csv", folder / "2.csv", folder / "1.csv", folder / "proof"}).exit_code == 1);
  CHECK(run({folder / "limits.csv", folder / "1.csv", folder / "proof"}).exit_code == 1);
  CHECK(run({folder / "1.csv", folder / "1.csv", folder / "2.csv", folder / "proof"}).exit_code == 1);
  CHECK(run({folder / "limits.csv", folder / "limits.csv", folder / "2.csv", folder / "proof"}).exit_code ==
        1);
  CHECK(run({folder / "proof", folder / "1.csv", folder / "2.csv", folder / "proof"}).exit_code == 2);
}

} // namespace blend_certificates_test
