// mdm judge: verdicts on samples as a user sees them.

#include "answer.hpp"

namespace judge_test {

using namespace cli_test;

namespace {

const std::string good =
    "size_mm,passing_percent\n9.5,100\n4.75,97.3\n2.36,88\n1.18,70\n0.6,45\n0.3,18\n0.15,4\n";
const std::string bad =
    "size_mm,passing_percent\n9.5,100\n4.75,93\n2.36,91\n1.18,90\n0.6,45\n0.3,18\n0.15,4\n";
const std::string edge =
    "size_mm,passing_percent\n9.5,100\n4.75,95\n2.36,88\n1.18,70\n0.6,45\n0.3,18\n0.15,4\n";

bool has(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

Outcome judged(const std::string &sample, Arguments more = {}) {
  Arguments arguments = {"judge", "-", "--spec", "astm-c33-fine"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return mdm(arguments, sample);
}

} // namespace

TEST_CASE("a sample passes", "[judge]") {
  const Outcome outcome = judged(good);
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.rfind("stdin: PASS of astm-c33-fine\n", 0) == 0);
  CHECK(has(outcome.out, "97.25 to 97.35"));
  CHECK(has(outcome.out, "note: astm-c33-fine: Fine aggregate for concrete, ASTM C33/C33M-18"));
  CHECK_FALSE(has(outcome.out, " \n"));
}

TEST_CASE("a sample fails, at all sieves that it fails at", "[judge]") {
  const Outcome outcome = judged(bad, {"--format", "json"});
  CHECK(outcome.exit_code == 1);
  const Json j = Json::parse(outcome.out);
  CHECK(j.at("schema") == "mdm-judge-1");
  CHECK(j.at("verdict") == "fail");
  std::vector<std::string> failing;
  for (const Json &sieve : j.at("samples")[0].at("sieves"))
    if (sieve.at("verdict") == "fail")
      failing.push_back(sieve.at("size"));
  CHECK(failing == std::vector<std::string>{"1.18", "4.75"});
}

TEST_CASE("a verdict that hangs on the rounding is no pass and has a curve on either side", "[judge]") {
  const Outcome outcome = judged(edge, {"--format", "json"});
  CHECK(outcome.exit_code == 1);
  const Json sample = Json::parse(outcome.out).at("samples")[0];
  CHECK(sample.at("verdict") == "hangs");
  CHECK(sample.at("rounded") == true);
  CHECK(sample.at("within")[5] == Json({{"size", "4.75"}, {"percent", "95"}}));
  CHECK(sample.at("outside")[5] == Json({{"size", "4.75"}, {"percent", "189/2"}}));
  CHECK(has(judged(edge).out, "stdin: HANGS"));
  CHECK(judged(edge, {"--rounding", "none"}).exit_code == 0);
  CHECK(judged(good, {"--rounding", "10"}).exit_code == 1);
}

TEST_CASE("a percent that is beyond its limit is shown with the digits that tell it from the limit",
          "[judge]") {
  const TemporaryFolder folder;
  const std::string limits =
      folder.write("limits.csv", "size_mm,passing_min_percent,passing_max_percent\n2,90,100\n1,0,60\n");
  const std::string sample = folder.write("s.csv", "size_mm,mass\n0.075,50000\n1,39999\n2,10001\n4,0\n");
  CHECK(has(mdm({"judge", sample, "--spec", limits, "--digits", "4"}).out, " 89.999 "));
  const std::string report = folder / "r.html";
  CHECK(mdm({"report", sample, "--spec", limits, "-o", report}).exit_code == 1);
  CHECK(has(read_file(report), "89.999 fail"));
}

TEST_CASE("masses are exact", "[judge]") {
  const std::string masses = "size_mm,mass\n9.5,0\n4.75,5\n2.36,7\n1.18,18\n0.6,25\n0.3,27\n0.15,14\n0,4\n";
  CHECK(judged(masses).exit_code == 0);
  CHECK(judged(masses, {"--rounding", "0.1"}).exit_code == 1);
}

TEST_CASE("several samples have a column each", "[judge]") {
  const TemporaryFolder folder;
  const std::string first = folder.write("good.csv", good), second = folder.write("bad.csv", bad);
  const Outcome outcome = mdm({"judge", first, second, "--spec", "astm-c33-fine"});
  INFO(outcome.out);
  CHECK(outcome.exit_code == 1);
  CHECK(has(outcome.out, "93 fail"));
  CHECK(has(outcome.out, "90 fail"));
  const Outcome csv = mdm({"judge", first, second, "--spec", "astm-c33-fine", "--format", "csv"});
  CHECK(has(csv.out, "good,,,,,,,,pass\n"));
  CHECK(has(csv.out, "bad,,,,,,,,fail\n"));
  CHECK(has(csv.out, "bad,4.75,95,100,93,93,92.5,93.5,fail\n"));
}

TEST_CASE("a size without a sieve is interpolated and noted", "[judge]") {
  const TemporaryFolder folder;
  const std::string spec = folder.write("spec.csv", "Sieve (mm),Lower,Upper\n2,50,50\n4,100,100\n");
  // 2 mm is halfway from 1 to 4 mm.
  const Outcome outcome =
      mdm({"judge", "-", "--spec", spec, "--rounding", "none"}, "size_mm,passing_percent\n4,100\n1,0\n");
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(has(outcome.out, "no sieve of 2 mm: what passes is interpolated"));
}

TEST_CASE("what cannot be judged is refused", "[judge]") {
  const auto refused = [](const Arguments &arguments, const std::string &input, const std::string &why) {
    const Outcome outcome = mdm(arguments, input);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(has(outcome.err, why));
  };
  refused({"judge", "-", "--spec", "astm-c33-fin"}, good, "specifications that come with mdm: astm-c33-57");
  refused({"judge", "-", "--spec", "-"}, good, "standard input is one file");
  refused({"judge", "-", "--spec", "astm-c33-fine", "--rounding", "-1"}, good, "--rounding");
  refused({"judge", "-", "--spec", "astm-c33-fine", "--rounding", "coarse"}, good, "--rounding");
  refused({"judge", "-", "--spec", "astm-c33-fine"}, "size_mm,retained_percent\n4,0\n2,20.0\npan,79.5\n",
          "stdin: the percents retained do not add up to 100");
}

TEST_CASE("internal stability is judged, with the size at which it is least", "[judge]") {
  const std::string gap =
      "size_mm,passing_percent\n64,100\n32,85\n16,60\n8,40\n4,30\n2,22\n1,20\n0.5,18\n0.25,10\n0.125,0\n";
  const Outcome fails = mdm({"judge", "-", "--stability", "kenney-lau", "--rounding", "none"}, gap);
  INFO(fails.out << fails.err);
  CHECK(fails.exit_code == 1);
  CHECK(fails.out.rfind("stdin: FAIL of kenney-lau\n", 0) == 0);
  // 18 % pass 0.5 mm, 22 % pass 2 mm: H/F = 4/18. At 1 mm 30 % pass 4 mm: H/F = 10/20.
  CHECK(has(fails.out, "H/F  0.222222  at least 1"));
  CHECK(has(fails.out, "D: 0.5 mm"));
  const Json j = Json::parse(
      mdm({"judge", "-", "--stability", "kezdi", "--rounding", "none", "--format", "json"}, gap).out);
  CHECK(j.at("schema") == "mdm-rule-1");
  CHECK(j.at("verdict") == "fail");
  CHECK(j.at("samples")[0].at("requirements")[0].at("limit") == Json({"4", "4"}));
}

TEST_CASE("filters are judged for a base by a rule", "[judge]") {
  const TemporaryFolder folder;
  folder.write("base.csv", "size_mm,passing_percent\n0.3,100\n0.15,85\n0.075,15\n0.02,0\n");
  folder.write("filter.csv", "size_mm,passing_percent\n4,100\n0.6,15\n0.1,0\n");
  const Arguments ask = {"judge", folder / "filter.csv", "--filter-for", folder / "base.csv", "--rule"};
  const auto by = [&ask](Arguments more) {
    more.insert(more.begin(), ask.begin(), ask.end());
    return mdm(more);
  };
  const Outcome passes = by({"terzaghi", "--rounding", "none", "--format", "csv"});
  INFO(passes.out << passes.err);
  CHECK(passes.exit_code == 0);
  CHECK(has(passes.out, "filter,retention,D15,mm,0.6,0.6,most,0.6,0.6,pass\n"));
  CHECK(by({"terzaghi"}).exit_code == 1); // the percents may be rounded: it hangs
  CHECK(has(by({"fema", "--rounding", "none"}).out, "category of the base: 3"));
  CHECK(by({"terzaghi", "--dispersive"}).exit_code == 2);
}

TEST_CASE("what is judged is asked for once, and rules have names", "[judge]") {
  const auto refused = [](const Arguments &arguments, const std::string &why) {
    const Outcome outcome = mdm(arguments, good);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(has(outcome.err, why));
  };
  refused({"judge", "-"}, "one of --spec, --job-mix, --stability and --filter-for");
  refused({"judge", "-", "--spec", "astm-c33-fine", "--stability", "kezdi"}, "one of --spec");
  refused({"judge", "-", "--stability", "kenney"}, "'kenney' is none of kenney-lau, kezdi, burenkova");
  refused({"judge", "-", "--stability", "kezdi", "--dispersive"}, "give --filter-for too");
  refused({"judge", "-", "--filter-for", "base.csv"}, "--rule is missing");
  refused({"judge", "-", "--filter-for", "base.csv", "--rule", "bs"}, "'bs' is none of terzaghi");
}

TEST_CASE("samples are drawn beside the limits", "[judge]") {
  const TemporaryFolder folder;
  CHECK(judged(bad, {"--plot", folder / "p.svg"}).exit_code == 1);
  const std::string picture = read_file(folder / "p.svg");
  for (const char *part : {"allowed: astm-c33-fine", "stdin: fail", "a limit is missed"})
    CHECK(has(picture, part));
  CHECK(judged(good, {"--plot", folder / "p.svg"}).exit_code == 0);
  CHECK_FALSE(has(read_file(folder / "p.svg"), "a limit is missed"));
  CHECK(mdm({"judge", "-", "--stability", "kezdi", "--plot", folder / "q.svg"}, good).exit_code == 1);
  CHECK(has(read_file(folder / "q.svg"), "stdin: "));
  folder.write("base.csv", good);
  mdm({"judge", "-", "--filter-for", folder / "base.csv", "--rule", "terzaghi", "--plot", folder / "r.svg"},
      good);
  CHECK(has(read_file(folder / "r.svg"), "base: base"));
  check_refused(judged(good, {"--plot", folder / "p.txt"}), "let OUT end in .svg, .png or .pdf");
  check_refused(judged(good, {"--plot", "-"}), "--plot needs a file");
}

TEST_CASE("samples are judged by a job mix and its tolerances", "[cli]") {
  const TemporaryFolder folder;
  const std::string mix = folder.write("mix.csv",
                                       "size_mm,passing_percent\n19,100\n4.75,60.5\n0.6,22\n0.075,5.0\n"),
                    field = folder.write("field.csv",
                                         "size_mm,passing_percent\n19,100\n4.75,67\n0.6,22\n0.075,7.0\n");
  const auto judged = [&](const Arguments &within) {
    Arguments all = {"judge", field, "--job-mix", mix};
    for (const std::string &text : within)
      all.insert(all.end(), {"--within", text});
    return mdm(all);
  };
  // At most 67.5 and 7 percent pass; 67 is from 66.5 to 67.5, and 7.0 from 6.95 to 7.05.
  CHECK(judged({"4.75mm=7"}).exit_code == 0);
  CHECK(contains(judged({"4.75=6.9%"}).out, "HANGS"));
  CHECK(judged({"4.75mm=5.9"}).exit_code == 1);
  CHECK(contains(judged({"0.075mm=2"}).out, "HANGS"));
  const Outcome all = judged({"7", "0.075mm=2.05"});
  CHECK(all.exit_code == 0);
  CHECK(contains(all.out, "field: PASS of job mix mix"));
  CHECK(contains(all.out, "7 points about 60.5 % passing 4.75 mm"));
  CHECK(contains(all.out, "2.05 points about 5 % passing 0.075 mm"));
  check_refused(judged({"3mm=2"}), "the job mix has no sieve '3mm'; there are 0.075, 0.6, 4.75, 19 mm");
  check_refused(judged({"4.75mm=-1"}), "is below 0");
  check_refused(judged({"4.75mm"}), "--within");
  // Nobody knows whether this is a decimal comma.
  check_refused(judged({"4.75mm=2,5"}), "a number without a sieve beside others");
  check_refused(judged({"7", "5"}), "a number without a sieve beside others");
  check_refused(judged({"4.75mm=2", "4.75=3"}), "'4.75' has its points twice");
  check_refused(judged({"No. 4=7"}), "a sieve is given by its opening, such as 4.75mm");
  check_refused(judged({}), "--job-mix and --within go together");
  check_refused(mdm({"judge", field, "--job-mix", mix, "--within", "5", "--spec", "astm-c33-fine"}),
                "one of --spec");
}

} // namespace judge_test
