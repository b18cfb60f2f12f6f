// Every pair of files that tests/certificates/make.py writes is a test: the folder says the verdict.

#include "catch.hpp"
#include "program.hpp"

#include <algorithm>

namespace certificates_test {

using namespace mdm_check_test;

namespace {

bool is_one_line(const std::string &text) {
  return text.size() > 1 && std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

void judge_folder(const std::string &name, int exit_code, const std::string &beginning,
                  std::size_t least_tests) {
  std::size_t tests = 0;
  for (const auto &entry :
       std::filesystem::directory_iterator(std::filesystem::path(MDM_CERTIFICATES_DIR) / name)) {
    std::filesystem::path proof = entry.path();
    if (proof.extension() != ".proof")
      continue;
    std::filesystem::path gradation = proof;
    gradation.replace_extension(".csv");
    if (!std::filesystem::exists(gradation))
      gradation.replace_extension(".json");
    const Outcome outcome = run({gradation.string(), proof.string()});
    INFO(proof << "\n" << outcome.out << outcome.err);
    CHECK(outcome.exit_code == exit_code);
    if (exit_code < 2)
      CHECK(is_one_line(outcome.out));
    if (exit_code > 0)
      CHECK(is_one_line(outcome.err));
    CHECK((exit_code == 2 ? outcome.out : exit_code == 0 ? outcome.err : std::string()).empty());
    CHECK((exit_code == 2 ? outcome.err : outcome.out).rfind(beginning, 0) == 0);
    ++tests;
  }
  CHECK(tests >= least_tests);
}

} // namespace

TEST_CASE("the checker accepts the certificates of accepted", "[checker]") {
  judge_folder("accepted", 0, "accepted: ", 20);
}

TEST_CASE("the checker refuses the certificates of rejected", "[checker]") {
  judge_folder("rejected", 1, "refused: ", 25);
}

TEST_CASE("the checker cannot read the certificates of unparsable", "[checker]") {
  judge_folder("unparsable", 2, MDM_CERTIFICATES_DIR, 25);
}

namespace {

/// What the checker says of an accepted pair, whose gradation it reads from standard input.
std::string verdict(const std::string &name, const std::string &extension = ".csv") {
  const std::filesystem::path folder = std::filesystem::path(MDM_CERTIFICATES_DIR) / "accepted";
  return run({"-", (folder / (name + ".proof")).string()}, (folder / (name + extension)).string()).out;
}

std::string smallest(const std::string &N, const std::string &parts, const std::string &how = "exactly") {
  return "accepted: N = " + N + " is the smallest number of particles that matches \"standard input\" " +
         how + " (" + parts + ")\n";
}

/// The text that --print has for a gradation.
std::string printed(const std::string &gradation) {
  const TemporaryFolder folder;
  const Outcome outcome = run({"--print", write_file(folder.path() / "g", gradation).string()});
  CHECK(outcome.exit_code == 0);
  return outcome.out;
}

} // namespace

TEST_CASE("the verdict repeats the whole question", "[checker]") {
  CHECK(
      verdict("at_least_everything") ==
      "accepted: N = 60 is the smallest number of particles, 60 or more, that matches \"standard input\" "
      "exactly (mass law x^3; sizes in mm; the pan counted as 0.9 mm of the file; classes below 1 mm of the "
      "file left out; openings of the file multiplied by 1.5; at least 2 particles in each class with "
      "mass; solids of a cylinder of diameter 6 mm and height 5 mm at void ratio 0.5)\n");
  CHECK(verdict("box") ==
        smallest("5122", "mass law x^3; sizes in mm; solids of a box of 3 x 2.5 x 2 mm at void ratio 0.7"));
  CHECK(verdict("power_5_2") == smallest("167", "mass law x^(5/2); sizes in mm"));
  CHECK(
      verdict("tree_passing_each_and_more") ==
      smallest("6",
               "retained within 12% of the total mass; passing within 15% of the total mass; passing within "
               "10% of the total mass at 2 mm, 4% at 5 mm of the file; total deviation within 20.5% of the "
               "total mass; mass law x^1; sizes in mm",
               "within a tolerance"));
  CHECK(verdict("tree_passing_file") ==
        smallest("6",
                 "retained within 20% of the total mass; passing within the file's tolerances; total "
                 "deviation within 25% of the total mass; mass law x^1; sizes in mm",
                 "within a tolerance"));
  CHECK(verdict("tree_none_of_a_band") ==
        "accepted: no number of particles matches \"standard input\" within a tolerance (50 to 60% of the "
        "total mass passing 2 mm of the file; 20 to 40% of the total mass passing 5 mm of the file; mass law "
        "x^1; sizes in mm)\n");
}

TEST_CASE("a percentage stands beside its opening of the file, whatever is left out or multiplied",
          "[checker]") {
  const std::string tolerance = "within a tolerance";
  CHECK(verdict("tree_passing_each_cut_factor") ==
        smallest("3",
                 "passing within 20% of the total mass at 2 mm, 15.5% at 4 mm of the file; mass law x^1; "
                 "sizes in mm; the pan counted as 0.5 mm of the file; classes below 1 mm of the file left "
                 "out; openings of the file multiplied by 2.5",
                 tolerance));
  CHECK(verdict("tree_half_phi_passing_each") ==
        smallest("4", "passing within 5% of the total mass at phi 1 of the file; mass law x^2; sizes in phi",
                 tolerance));
}

TEST_CASE("the verdict says what bounds are proved", "[checker]") {
  const std::string how = " \"standard input\" within a tolerance";
  const std::string band =
      " (75 to 85% of the total mass passing 2 mm of the file; mass law x^1; sizes in mm)\n";
  const std::string passing = " (passing within 5% of the total mass; mass law x^1; sizes in mm)\n";
  CHECK(verdict("tree_sums_by_hand") ==
        "accepted: N = 5 is the smallest number of particles that matches" + how + band);
  CHECK(verdict("tree_bounds_by_hand") ==
        "accepted: the smallest number of particles that matches" + how + " is between 4 and 5" + band);
  CHECK(verdict("tree_bound_alone_by_hand") ==
        "accepted: no number of particles below 4 matches" + how + band);
  CHECK(verdict("tree_bounds_at_least") ==
        "accepted: the smallest number of particles, 3 or more, that matches" + how + " is between 5 and 6" +
            passing);
  CHECK(verdict("tree_bound_alone_at_least") ==
        "accepted: no number of particles below 6, 3 or more, matches" + how + passing);
}

TEST_CASE("the verdict says what the gradation file is about", "[checker]") {
  CHECK(verdict("inches") == smallest("2", "mass law x^3; sizes in mm, from inches"));
  CHECK(verdict("sieve_names") == smallest("163271087", "mass law x^3; sizes in mm, from sieve names"));
  CHECK(verdict("half_phi_that_ties") == smallest("10", "mass law x^3; sizes in phi"));
  CHECK(verdict("size_um_retained_percent") == smallest("4", "mass law x^3; sizes in um; percents sum to 3"));
  CHECK(verdict("size_m_retained_fraction") == smallest("4", "mass law x^3; sizes in m; fractions sum to 3"));
  CHECK(verdict("passing_implies_a_pan")
            .find("(mass law x^3; sizes in mm; a pan implied below the finest sieve)") != std::string::npos);
  CHECK(verdict("json_descending_inches", ".json")
            .find("(mass law x^3; sizes in mm, from inches; factors from the file)") != std::string::npos);
  CHECK(
      verdict("band_with_an_implied_pan") ==
      smallest("3",
               "passing within the file's limits; mass law x^1; sizes in mm; a pan implied below the finest "
               "sieve; masses from the middle of the file's limits",
               "within a tolerance"));
}

TEST_CASE("a file's name cannot write a verdict of its own", "[checker]") {
  const TemporaryFolder folder;
  const std::string proof = std::string(MDM_CERTIFICATES_DIR) + "/accepted/sphere_two_classes.proof";
  const auto name_in_verdict = [&](const std::string &name) {
    const std::string path = write_file(folder.path() / name, "size_mm,mass\n1,2\n2,1\n3,0\n").string();
    const std::string out = run({path, proof}).out;
    const std::string before = "matches \"" + folder.path().string() + "/";
    const std::size_t begin = out.find(before) + before.size();
    return out.substr(begin, out.find(" exactly (mass law", begin) - begin);
  };
  CHECK(name_in_verdict("sand.csv") == "sand.csv\"");
  CHECK(name_in_verdict("sand.csv exactly (law x^3); also any file") ==
        "sand.csv exactly (law x^3); also any file\"");
  CHECK(name_in_verdict("sand.csv\" exactly (law") == "sand.csv\\\" exactly (law\"");
  CHECK(name_in_verdict("a\\xC2b") == "a\\\\xC2b\"");
  CHECK(name_in_verdict("a\xC2\xAD\xD8\x9C\xE2\x80\xAE\n") == "a\\xC2\\xAD\\xD8\\x9C\\xE2\\x80\\xAE\\x0A\"");
  CHECK(name_in_verdict("\xC3\xA4\xFF") == "\xC3\xA4\\xFF\"");
  CHECK(name_in_verdict(std::string(200, 'x')) == std::string(200, 'x') + "\"");
}

TEST_CASE("a refusal names the file on standard output and its reason on standard error", "[checker]") {
  const std::string folder = std::string(MDM_CERTIFICATES_DIR) + "/rejected/";
  const Outcome outcome = run({folder + "class_zero.csv", folder + "class_zero.proof"});
  CHECK(outcome.out ==
        "refused: the certificate does not prove its claim about \"" + folder + "class_zero.csv\"\n");
  CHECK(outcome.err == folder + "class_zero.proof: witness: one line a class with mass fails at class 1\n");
}

TEST_CASE("a gradation is printed as it is read", "[checker]") {
  CHECK(printed(
            "sieve,retained_g,factor,tolerance_percent\n3/8 in,0,2.70,0\nNo. 200,1.50,1,5e-1\npan,2,1,0\n") ==
        "size_mm,mass,tolerance_percent,factor\n0,2,0,1\n0.075,1.5,0.5,1\n9.5,0,0,2.7\n");
  CHECK(printed("size_in,passing_percent\n1,10\n2,100\n") == "size_mm,mass\n0,10\n25.4,90\n50.8,0\n");
  CHECK(printed("size_phi,mass\n-1,0\npan,1\n0.5,2\n-0.250,3\n") ==
        "size_phi,mass\npan,1\n0.5,2\n-0.25,3\n-1,0\n");
  CHECK(printed("{\"unit\": \"um\", \"sizes\": [300, 1e2], \"masses\": [0, 7]}") ==
        "size_um,mass\n100,7\n300,0\n");
  CHECK(printed("size_m,passing_min_percent,passing_max_percent\n2,90,100\n1,1.50,20\n") ==
        "size_m,passing_min_percent,passing_max_percent\n1,1.5,20\n2,90,100\n");
}

TEST_CASE("what is printed is read as the same", "[checker]") {
  std::size_t tests = 0;
  for (const auto &entry :
       std::filesystem::directory_iterator(std::filesystem::path(MDM_CERTIFICATES_DIR) / "accepted"))
    if (entry.path().extension() != ".proof") {
      const std::string text = printed(read_file(entry.path()));
      CHECK(printed(text) == text);
      ++tests;
    }
  CHECK(tests >= 118);
}

TEST_CASE("a verdict follows what is printed", "[checker]") {
  const std::string accepted = std::string(MDM_CERTIFICATES_DIR) + "/accepted/phi";
  const Outcome outcome = run({"--print", accepted + ".csv", accepted + ".proof"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.rfind("size_phi,mass\n1,1\n0,2\n-1,3\n-2,0\naccepted: N = 5 ", 0) == 0);
  const std::string refused = std::string(MDM_CERTIFICATES_DIR) + "/rejected/class_zero";
  CHECK(run({"--print", refused + ".csv", refused + ".proof"}).exit_code == 1);
  const TemporaryFolder folder;
  const std::string tiny =
      write_file(folder.path() / "g.csv", "size_mm,mass\n1." + std::string(998, '1') + "e-9,1\n1,0\n")
          .string();
  const Outcome too_long = run({"--print", tiny});
  CHECK(too_long.exit_code == 2);
  CHECK(too_long.out.empty());
}

} // namespace certificates_test
