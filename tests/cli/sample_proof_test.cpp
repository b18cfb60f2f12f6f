// mdm verify --proof and mdm published --proof: what is certified of a sample, and mdm-check on it.

#include "answer.hpp"

#include <filesystem>

namespace sample_proof_test {

using namespace cli_test;

namespace {

const std::string three = "size_mm,mass\n1,8\n2,0\n3,64\n4,0\n"; // (1, 2], (2, 3], (3, 4]

struct Proved {
  Outcome verify, check;
  std::string sample; ///< what was written beside
};

/// Verifies a sample and has its certificate checked, with the files beside it where they are.
Proved prove(const std::string &gradation, const std::string &particles, const Arguments &options = {},
             const std::string &name = "s.csv") {
  const TemporaryFolder folder;
  const std::string g = folder.write("g.csv", gradation), s = folder.write(name, particles),
                    proof = (folder.path() / "s.proof").string();
  Arguments words = {"verify", g, s, "--proof", proof};
  words.insert(words.end(), options.begin(), options.end());
  Proved made{mdm(words), {}, {}};
  const std::string beside = proof + ".sample.csv", readable = proof + ".gradation.csv";
  if (std::filesystem::exists(beside))
    made.sample = read_file(beside);
  if (std::filesystem::exists(proof))
    made.check = mdm_check(
        {std::filesystem::exists(readable) ? readable : g, made.sample.empty() ? s : beside, proof});
  else
    made.check.exit_code = -1;
  return made;
}

bool has(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("verify --proof: a canonical sample that matches is checked as it is") {
  const Proved made = prove(three, "size_mm,quantity\n2,1\n4,1\n");
  CHECK(made.verify.exit_code == 0);
  CHECK(has(made.verify.out, "check the proof with: mdm-check "));
  CHECK(made.sample.empty());
  CHECK(made.check.exit_code == 0);
  CHECK(has(made.check.out, "accepted: the 2 particles of "));
  CHECK(has(made.check.out, " exactly; conditions 1 yes, 2 yes, 3 yes, 4 yes (mass law x^3; sizes in mm)"));
}

TEST_CASE("verify --proof: that a sample does not match is certified, with the reason") {
  const Proved made = prove(three, "size_mm,quantity\n2,2\n4,1\n");
  CHECK(made.verify.exit_code == 1);
  CHECK(made.check.exit_code == 0);
  CHECK(has(made.check.out, " exactly: class 1 holds 20 %, and at most 11.1112 % are asked for; "));
  const Proved outside = prove(three, "size_mm\n1\n2\n5\n");
  CHECK(outside.verify.exit_code == 1);
  CHECK(has(outside.check.out, " exactly: 2 outside all classes; "));
}

TEST_CASE("verify --proof: tolerances and bands are those of the certificate") {
  const std::string sample = "size_mm,quantity\n2,2\n4,1\n"; // 20 % and 80 %, of 11.1 % and 88.9 %
  CHECK(has(prove(three, sample, {"--tolerance", "9%"}).check.out,
            " within a tolerance; the largest error of a share "));
  CHECK(has(prove(three, sample, {"--tolerance", "8%"}).check.out, " do not match "));
  CHECK(has(prove(three, sample, {"--tolerance", "total:17%"}).check.out,
            ": all errors together are 17.7777 to 17.7778 %, and at most 17 % are asked for; "));
  const TemporaryFolder folder;
  const std::string band =
      folder.write("band.csv", "size_mm,passing_min_percent,passing_max_percent\n2,10,15\n");
  CHECK(has(prove(three, sample, {"--band", band}).check.out,
            ": 20 % pass the upper opening of class 1, and at most 15 % are asked for; "));
}

TEST_CASE("verify --proof: other samples are written beside the certificate") {
  const Proved lines = prove(three, "2\n4\n", {"--from", "diameters"}, "s.txt");
  CHECK(lines.sample == "size_mm,quantity\n2,1\n4,1\n");
  CHECK(lines.check.exit_code == 0);
  const Proved blanks = prove(three, "# mine\nsize_mm , quantity\n2,1\n4,1\n");
  CHECK(blanks.sample == "size_mm,quantity\n2,1\n4,1\n");
  const Proved dump = prove(three, "x y z r\n0 0 0 1\n0 0 0 2\n", {"--from", "xyzr"}, "s.txt");
  CHECK((dump.sample.empty() || dump.check.exit_code == 0));
  const Proved ranges =
      prove(three, "lower_mm,upper_mm,mass,quantity,size_lo_mm,size_hi_mm\n1,2,8,1,1,2\n3,4,64,1,3.9,4\n",
            {"--tolerance", "90%"});
  CHECK(ranges.sample == "size_lo_mm,size_hi_mm,quantity\n>1,2,1\n3.9,4,1\n");
  CHECK(ranges.check.exit_code == 0);
}

TEST_CASE("verify --proof: the sizes of an answer are roots, and match exactly") {
  const TemporaryFolder folder;
  const std::string g = folder.write("g.csv", three);
  for (const char *const law : {"sphere", "power:5/2"}) {
    const Outcome answer = mdm({"solve", g, "--format", "json", "--law", law});
    REQUIRE(answer.exit_code == 0);
    const Proved made = prove(three, answer.out, {"--law", law}, "a.json");
    CHECK(made.verify.exit_code == 0);
    CHECK(made.sample.rfind(std::string("size_mm^") + (law[0] == 's' ? "3" : "5") + ",quantity\n", 0) == 0);
    CHECK(has(made.check.out, " exactly; conditions 1 yes, 2 yes, 3 yes, 4 yes "));
    CHECK(prove(three, made.sample, {"--law", law}).check.exit_code == 0);
  }
}

TEST_CASE("verify --proof: where ranges leave it open there is none, with the reason") {
  const Proved made = prove(three, "size_lo_mm,size_hi_mm\n1.9,2\n3.9,4\n");
  CHECK(made.verify.exit_code == 3);
  CHECK(made.check.exit_code == -1);
  CHECK(has(made.verify.out, "no proof was written to "));
  CHECK(has(made.verify.out, "3 one size per class (articulately): yes")); // one particle a class
  CHECK(has(
      prove(three, "size_lo_mm,size_hi_mm,quantity\n1.9,2,2\n3.9,4,1\n", {"--tolerance", "50%"}).check.out,
      "conditions 1 yes, 2 yes, 3 open, 4 no"));
}

TEST_CASE("verify --proof: what has no certificate is refused") {
  const TemporaryFolder folder;
  const std::string g = folder.write("g.csv", three), s = folder.write("s.csv", "size_mm\n2\n4\n");
  CHECK(has(mdm({"verify", g, s, "--proof", "-"}).err, "--proof needs a file"));
  CHECK(mdm({"verify", g, s, "--proof", s}).exit_code == 2);
  CHECK(has(mdm({"verify", g, s, "--snap", "1e-12", "--proof", folder.path() / "p"}).err,
            "--snap: a certificate is of"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "p"));
}

TEST_CASE("published --proof: the algorithm's sample is certified, with what it was to reach") {
  const TemporaryFolder folder;
  const std::string g = folder.write("g.csv", three), proof = (folder.path() / "p").string();
  const auto checked = [&](Arguments words) {
    words.insert(words.end(), {g, "--proof", proof});
    words.insert(words.begin(), "published");
    mdm(words);
    return mdm_check({g, proof + ".sample.csv", proof});
  };
  const Outcome rounded = checked({"rounded"});
  CHECK(rounded.exit_code == 0);
  CHECK(has(rounded.out, " exactly"));
  const Outcome fixed = checked({"fixed-size", "--tolerance", "5%"});
  CHECK(fixed.exit_code == 0);
  CHECK(has(fixed.out, "total deviation within 5% of the total mass"));
  CHECK(checked({"spanned-integer"}).exit_code == 0);
}

TEST_CASE("crosscheck --proofs: answers that match and answers that do not are certified") {
  const TemporaryFolder folder;
  const std::string suite = folder.write("suite.jsonl", R"({"id":"a","sizes":[1,2,3],"masses":[2,1,0]})"
                                                        "\n"
                                                        R"({"id":"b","sizes":[1,2,3],"masses":[2,1,0]})"
                                                        "\n"),
                    answers =
                        folder.write("answers.jsonl", R"({"id":"a","quantities":[3,1]})"
                                                      "\n"
                                                      R"({"id":"a","quantities":[1,1],"sizes":[1.5,2.5]})"
                                                      "\n"
                                                      R"({"id":"b","quantities":[1,1]})"
                                                      "\n"),
                    proofs = (folder.path() / "proofs").string();
  const Outcome judged = mdm({"crosscheck", suite, answers, "--proofs", proofs});
  CHECK(judged.exit_code == 1);
  CHECK(has(judged.out, "2 certificates are in "));
  CHECK(has(judged.out, "of 1 answers there is none"));
  const auto check = [&](const std::string &name) {
    const std::string file = proofs + "/" + name;
    return mdm_check({file + ".gradation.json", file + ".sample.csv", file + ".proof"});
  };
  CHECK(has(check("1").out, "accepted: the 4 particles of "));
  CHECK(has(check("1").out, " exactly; conditions 1 yes, 2 yes, 3 yes, 4 yes "));
  CHECK(read_file(proofs + "/1.sample.csv").rfind("size_mm^3,quantity\n", 0) == 0);
  CHECK(has(check("1-2").out, " do not match "));
  CHECK(
      has(check("1-2").out, ": class 1 holds 17.7631 to 17.7632 %, and at least 66.6666 % are asked for; "));
  CHECK_FALSE(std::filesystem::exists(proofs + "/2.proof"));
  CHECK(has(judged.out, "check them with: mdm-check --suite " + proofs));
  const Outcome all = mdm_check({"--suite", proofs});
  CHECK(has(all.out, ": 2 accepted, 0 refused, 0 malformed, 0 missing"));
  CHECK(all.exit_code == 0);
  const Outcome by_line = mdm_check({"--suite", suite, proofs});
  CHECK(has(by_line.out, ": 2 accepted, 0 refused, 0 malformed, 1 missing"));
}

} // namespace sample_proof_test
