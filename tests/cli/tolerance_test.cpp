// mdm solve within tolerances. The small problems are worked out by hand: two classes of the same mass, (1,
// 2] and (2, 3] mm. Two particles of 2 mm and one of a little more are the exact match; one of 2 mm and one
// of a little more are within any tolerance above 0; one alone is half of the mass away.

#include "answer.hpp"

namespace tolerance_test {

using namespace cli_test;

namespace {

const std::string halves = "size_mm,mass\n1,1\n2,1\n3,0\n";
const std::string percents = "passing_min_percent,passing_max_percent\n";

/// All that a match of spheres within a tolerance owes its reader.
void check_tolerant(const Json &answer) {
  INFO(answer.dump());
  const Json &classes = answer.at("classes");
  const Json &achieved = answer.at("achieved");
  const Json &tolerance = answer.at("tolerance");
  const Rational scale = rational(answer.at("scale").at("chosen"));
  REQUIRE(achieved.size() == classes.size());
  Rational passing = 0;
  Integer particles = 0;
  const auto is_within = [](const Rational &share, const Json &bounds) {
    return rational(bounds.at(0)) <= share && share <= rational(bounds.at(1));
  };
  for (std::size_t j = 0; j < classes.size(); ++j) {
    const Json &c = classes[j];
    const Integer q(c.at("quantity").get<std::string>());
    const Rational share = rational(achieved[j]);
    passing += share;
    particles += q;
    CHECK((q == 0) == (share == 0));
    CHECK(c.at("size").is_null() == (q == 0));
    if (!tolerance.at("retained").empty())
      CHECK(is_within(share, tolerance.at("retained").at(j)));
    if (!tolerance.at("passing").empty())
      CHECK(is_within(passing, tolerance.at("passing").at(j)));
    if (q == 0)
      continue;
    const Rational lo = rational(c.at("size").at(0));
    const Rational hi = rational(c.at("size").at(1));
    CHECK(rational(c.at("lower")) < lo);
    CHECK(hi <= rational(c.at("upper")));
    CHECK(q * cube(lo) <= share * scale);
    CHECK(share * scale <= q * cube(hi));
  }
  CHECK(passing == 1);
  CHECK(answer.at("particles") == particles.str());
}

/// The answer of the gradation on standard input within the tolerances.
Json within(const Arguments &tolerances, const std::string &gradation = halves, Arguments more = {}) {
  Arguments arguments{"-"};
  for (const std::string &tolerance : tolerances)
    arguments.insert(arguments.end(), {"--tolerance", tolerance});
  arguments.insert(arguments.end(), more.begin(), more.end());
  Json answer = solve_json(arguments, 0, gradation);
  CHECK(answer.at("status") == "optimal");
  check_tolerant(answer);
  return answer;
}

std::string particles(const Arguments &tolerances, const std::string &gradation = halves,
                      const Arguments &more = {}) {
  return within(tolerances, gradation, more).at("particles");
}

Json band_alone(const std::string &rows, int exit_code = 0) {
  Json answer = solve_json({"--band", "-"}, exit_code, "size_mm," + percents + rows);
  if (exit_code == 0)
    check_tolerant(answer);
  return answer;
}

} // namespace

TEST_CASE("two halves within a tolerance, by hand", "[cli]") {
  CHECK(particles({"retained:0%"}) == "3");
  CHECK(particles({"retained:0.0001%"}) == "2");
  CHECK(particles({"retained:49.99%"}) == "2");
  CHECK(particles({"retained:50%"}) == "1");
  CHECK(particles({"retained:100%"}) == "1");
  CHECK(particles({"passing:0%"}) == "3");
  CHECK(particles({"passing:0.0001%"}) == "2");
  CHECK(particles({"passing:50%"}) == "1");
  CHECK(particles({"total:0%"}) == "3");
  CHECK(particles({"total:99.99%"}) == "2");
  CHECK(particles({"total:100%"}) == "1");
  CHECK(particles({"total:100%", "passing:49%"}) == "2");
  CHECK(particles({"laboratory"}) == "2");
}

TEST_CASE("a tolerance goes together with the other demands", "[cli]") {
  CHECK(particles({"retained:1%"}, halves, {"--min-per-class", "2"}) == "4");
  CHECK(particles({"retained:50%"}, halves, {"--min-per-class", "2"}) == "4");
  CHECK(particles({"retained:0%"}, halves, {"--min-per-class", "2"}) == "5");
  CHECK(particles({"retained:1%"}, halves, {"--at-least", "7"}) == "7");
  CHECK(particles({"retained:1%"}, halves, {"--size-factor", "0.001"}) == "2");
  // One particle of 3 mm at most has 4.5 pi mm^3; 15 mm^3 need two, the coarse class at least one of them.
  CHECK(particles({"retained:50%"}, halves, {"--solids-volume", "14"}) == "1");
  CHECK(particles({"retained:50%"}, halves, {"--solids-volume", "15"}) == "2");
  const std::string three = "size_mm,mass\npan,3\n1,1\n2,1\n3,0\n";
  CHECK(particles({"retained:1%"}, three, {"--cut-below", "1"}) == "2");
  CHECK(within({"retained:1%"}, three, {"--pan-size", "0.5"}).at("classes").at(0).at("lower") == "0.5");
}

TEST_CASE("a tolerance needs rational masses at the openings", "[cli]") {
  const Json square = solve_json({"-", "--tolerance", "retained:1%", "--law", "power:2"}, 0, halves);
  CHECK(square.at("particles") == "2");
  CHECK(square.at("solids_volume").is_null());
  CHECK(solve_json({"-", "--tolerance", "retained:1%", "--law", "power:5/2"}, 0,
                   "size_mm,mass\n1,1\n4,1\n9,0\n")
            .at("particles") == "2");
  check_refused(
      mdm({"solve", "-", "--tolerance", "retained:1%", "--law", "power:5/2"}, halves),
      "irrational at an opening, and a tolerance needs exact masses: use a law with a whole exponent");
}

TEST_CASE("a class may be empty, and one without mass may hold particles", "[cli]") {
  const std::string gap = "size_mm,mass\n1,1\n2,0\n4,1\n8,0\n";
  CHECK(particles({"passing:50%"}, gap) == "1");
  CHECK(particles({"passing:50%"}, gap, {"--at-least", "2"}) == "2");
  const TemporaryFolder folder;
  const std::string band = folder.write("b.csv", "size_mm," + percents + "2,0,0\n4,100,100\n");
  CHECK(quantities(within({}, gap, {"--band", band})) == "0 1 0");
}

TEST_CASE("tolerances of the file and its last digits", "[cli]") {
  CHECK(particles({"retained:file"}, "size_mm,mass,tolerance_percent\n1,1,0\n2,1,50\n3,0,50\n") == "3");
  CHECK(particles({"retained:file"}, "size_mm,mass,tolerance_percent\n1,1,1\n2,1,1\n3,0,0\n") == "2");
  CHECK(particles({"passing:file"}, "size_mm,mass,tolerance_percent\n1,1,0\n2,1,50\n3,0,0\n") == "1");
  CHECK(particles({"passing:file"}, "size_mm,mass,tolerance_percent\n1,1,50\n2,1,0\n3,0,50\n") == "3");
  const std::string pan = "size_mm,mass,tolerance_percent\npan,1,100\n1,1,1\n2,0,0\n";
  CHECK(particles({"retained:file"}, pan) == "2");
  CHECK(particles({"retained:file"}, pan, {"--cut-below", "1"}) == "1");
  const Json rounded = within({"rounding"}, "size_mm,passing_percent\n1,0\n2,50\n3,100\n");
  CHECK(rounded.at("particles") == "2");
  CHECK(rounded.at("tolerance").at("passing").dump() == R"([["99/200","101/200"],["0","1"]])");
  check_refused(mdm({"solve", "-", "--tolerance", "rounding"}, halves),
                "rounding needs what passes as the laboratory wrote it: a file with passing_percent");
  check_refused(mdm({"solve", "-", "--tolerance", "retained:file"}, halves),
                "no column tolerance_percent: add one");
}

TEST_CASE("JSON within a tolerance has what was asked for, its bounds and the achieved shares", "[cli]") {
  const Json answer = within({"retained:1%", "total:0.5%"});
  CHECK(answer.at("tolerance").at("asked") == Json({"retained:1%", "total:0.5%"}));
  CHECK(answer.at("tolerance").at("band").is_null());
  CHECK(answer.at("tolerance").at("retained").dump() == R"([["49/100","51/100"],["49/100","51/100"]])");
  CHECK(answer.at("tolerance").at("passing").empty());
  CHECK(answer.at("tolerance").at("total") == "1/200");
  const Rational deviation = rational(answer.at("achieved").at(1)) - Rational(1, 2);
  CHECK(deviation > 0);
  CHECK(2 * deviation <= Rational(1, 200));
}

TEST_CASE("the text names target, limits and what is achieved, of the kind that was asked for", "[cli]") {
  const Outcome laboratory = mdm({"solve", "-", "--tolerance", "laboratory"}, halves);
  CHECK(laboratory.exit_code == 0);
  CHECK(contains(laboratory.out, "stdin: 2 particles: the smallest set that matches (within laboratory)\n"));
  CHECK(contains(laboratory.out, "passes upper (%)        limits  achieved  laboratory +-  quantity"));
  CHECK(contains(laboratory.out, "47.5 .. 52.5"));
  CHECK(contains(laboratory.out, "  2.5  "));
  CHECK_FALSE(contains(laboratory.out, "retained (%)"));
  const Outcome total = mdm({"solve", "-", "--tolerance", "total:1%"}, halves);
  CHECK(contains(total.out, "retained (%)  achieved  quantity"));
  CHECK(contains(total.out, " of 1 percentage points\n"));
  const Outcome both = mdm({"solve", "-", "--tolerance", "passing:1%", "--tolerance", "retained:2%"}, halves);
  CHECK(contains(both.out, "49 .. 51"));
  CHECK(contains(both.out, "48 .. 52"));
}

TEST_CASE("CSV within a tolerance has the columns of every answer", "[cli]") {
  const Outcome csv = mdm({"solve", "-", "--tolerance", "retained:50%", "--format", "csv"}, halves);
  CHECK(csv.exit_code == 0);
  CHECK(csv.err.empty());
  CHECK(contains(csv.out, "lower_mm,upper_mm,mass,quantity,size_lo_mm,size_hi_mm\n"));
  CHECK((contains(csv.out, "\n1,2,1,0,,\n") || contains(csv.out, "\n2,3,1,0,,\n")));
}

TEST_CASE("a band alone is a question", "[cli]") {
  const Json answer = band_alone("1,0,0\n2,40,60\n3,100,100\n");
  CHECK(answer.at("id") == "stdin");
  CHECK(answer.at("particles") == "2");
  CHECK(answer.at("tolerance").at("band") == "stdin");
  CHECK(answer.at("tolerance").at("passing").dump() == R"([["2/5","3/5"],["1","1"]])");
  CHECK(answer.at("notes").dump() == R"(["No gradation was given: the target is the middle of the band."])");
  CHECK(band_alone("1,0,0\n2,50,50\n3,100,100\n").at("particles") == "3");
  CHECK(band_alone("1,0,0\n2,0,60\n3,100,100\n").at("particles") == "1");
  const Json pan = band_alone("2,0,10\n3,100,100\n");
  CHECK(pan.at("classes").at(0).at("lower") == "0");
  CHECK(quantities(pan) == "0 1");
  const Outcome text = mdm({"solve", "--band", example("c33-fine-aggregate-limits")});
  CHECK(text.exit_code == 0);
  CHECK(contains(text.out, "c33-fine-aggregate-limits: 12 particles: "));
  CHECK(contains(text.out, "80 .. 100"));
}

TEST_CASE("a band that contradicts itself is a negative verdict with its reason", "[cli]") {
  const Json answer = band_alone("1,20,30\n2,0,10\n4,100,100\n", 1);
  CHECK(answer.at("status") == "none");
  CHECK(answer.at("particles").is_null());
  CHECK(answer.at("achieved").is_null());
  const TemporaryFolder folder;
  const std::string band = folder.write("b.csv", "size_mm," + percents + "1,20,30\n2,0,10\n4,100,100\n");
  const std::string reason = "no set matches (within the band b): the band contradicts itself: at least 20 "
                             "percent must pass 1 mm, but at most 10 may pass 2 mm\n";
  for (const char *format : {"text", "csv"}) {
    const Outcome outcome = mdm({"solve", "--band", band, "--format", format});
    CHECK(outcome.exit_code == 1);
    CHECK(contains(outcome.out + outcome.err, "b: " + reason));
  }
}

TEST_CASE("a band beside a gradation bounds its curve", "[cli]") {
  const TemporaryFolder folder;
  const std::string curve = folder.write("curve.csv", halves);
  const auto band = [&folder](const std::string &rows) {
    return folder.write("band.csv", "size_mm," + percents + rows);
  };
  CHECK(solve_json({curve, "--band", band("2,40,60\n")}).at("particles") == "2");
  // More than half below 2 mm: that takes two particles there.
  CHECK(solve_json({curve, "--band", band("2,55,60\n")}).at("particles") == "3");
  const Outcome apart = mdm({"solve", curve, "--band", band("2,55,60\n"), "--tolerance", "retained:1%"});
  CHECK(apart.exit_code == 1);
  CHECK(contains(apart.out, "no gradation meets these demands at once"));
  check_refused(mdm({"solve", curve, "--band", band("1.5,40,60\n")}),
                "the band's sieve 1.5 mm is no sieve of the gradation: add a row for it, or leave it out");
  check_refused(mdm({"solve", curve, "--band", band("1,40,60\n")}), "add a row 'pan'");
  check_refused(mdm({"solve", "--band", band("2,40,60\n")}), "add a larger sieve that lets 100 pass");
  check_refused(mdm({"solve", band("2,40,60\n")}), "a band is for --band");
}

TEST_CASE("solve needs a gradation or a band, each of its own", "[cli]") {
  check_refused(mdm({"solve"}), "FILE is required, or --band; see mdm solve --help");
  check_refused(mdm({"solve", "-", "--band", "-"}, halves), "standard input is the gradation already");
  check_refused(mdm({"batch", "--band", "-"}, "{}"), "standard input has the gradations");
  const TemporaryFolder folder;
  const std::string band = folder.write("b.csv", "size_mm," + percents + "2,40,100\n");
  check_refused(mdm({"solve", "--band", band, "-o", band}), "different names");
  check_refused(mdm({"solve", "-", "--band", band, "-o", band}, halves), "different names");
  check_refused(mdm({"batch", "--band", band, "-o", band}), "different names");
  check_refused(mdm({"solve", "--band", band, "--specimen-id", "x"}), "--specimen-id");
  CHECK(folder.entries() == 1);
}

TEST_CASE("options of exact matches and of tolerances are not mixed", "[cli]") {
  for (const Arguments &options :
       {Arguments{"--spectrum"}, Arguments{"--scale", "upper"}, Arguments{"--max-steps", "3"}}) {
    Arguments arguments{"solve", "-", "--tolerance", "retained:1%"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    check_refused(mdm(arguments, halves), options.front() + ": ");
  }
  check_refused(mdm({"solve", "-", "--node-limit", "3"}, halves), "--node-limit: ");
}

TEST_CASE("tolerances that make no sense are refused with what to write", "[cli]") {
  for (const char *tolerance : {"one", "1%%", "retained:", "retained:-1%", "retained:nan%", "retained:inf%",
                                "retained:101%", "", "laboratory:2%"})
    check_refused(mdm({"solve", "-", "--tolerance", tolerance}, halves), "--tolerance: ");
}

TEST_CASE("option --at-most below the smallest match within a tolerance is a negative verdict", "[cli]") {
  const Json none = solve_json({"-", "--tolerance", "retained:1%", "--at-most", "1"}, 1, halves);
  CHECK(none.at("status") == "none");
  CHECK(none.at("lower_bound") == "2");
  CHECK(none.at("particles").is_null());
  CHECK(none.at("achieved").is_null());
  CHECK(solve_json({"-", "--tolerance", "retained:1%", "--at-most", "2"}, 0, halves).at("particles") == "2");
}

TEST_CASE("a limit ends the search with what is certain", "[cli]") {
  const std::string sand = example("ottawa-f65-sand"); // with more particles than the chain's bound
  const Integer least(solve_json({sand, "--tolerance", "retained:1%"}).at("particles").get<std::string>());
  const Integer exact(solve_json({sand}).at("particles").get<std::string>()); // within the tolerance
  for (const char *nodes : {"0", "1", "2", "4"}) {
    const Json answer = solve_json({sand, "--tolerance", "retained:1%", "--node-limit", nodes}, 3);
    REQUIRE(answer.at("status") == "feasible");
    check_tolerant(answer);
    CHECK(Integer(answer.at("lower_bound").get<std::string>()) <= least);
    CHECK(Integer(answer.at("particles").get<std::string>()) >= least);
    CHECK(Integer(answer.at("particles").get<std::string>()) <= exact);
  }
  const Json stopped = solve_json({sand, "--tolerance", "retained:1%", "--time-limit", "0"}, 3);
  CHECK(stopped.at("status") == "feasible");
  CHECK(Integer(stopped.at("lower_bound").get<std::string>()) <= least);
  const Outcome text = mdm({"solve", sand, "--tolerance", "retained:1%", "--node-limit", "0"});
  CHECK(text.exit_code == 3);
  CHECK(contains(text.out, "stopped at a limit"));
}

TEST_CASE("a batch within a tolerance answers each line", "[cli]") {
  const std::string lines = R"({"id":"a","sizes":["1","2","3"],"masses":["1","1","0"]})"
                            "\n"
                            R"({"id":"b","sizes":["1","2"],"masses":["1","0"]})"
                            "\n";
  const Outcome outcome = mdm({"batch", "--tolerance", "passing:1%"}, lines);
  CHECK(outcome.exit_code == 0);
  const std::size_t end = outcome.out.find('\n');
  const Json first = Json::parse(outcome.out.substr(0, end));
  const Json second = Json::parse(outcome.out.substr(end + 1));
  check_tolerant(first);
  CHECK(first.at("particles") == "2");
  CHECK(second.at("particles") == "1");
  const TemporaryFolder folder;
  const std::string band = folder.write("b.csv", "size_mm," + percents + "3,100,100\n");
  const Outcome with_band = mdm({"batch", "--band", band}, lines);
  CHECK(with_band.exit_code == 0);
  CHECK(contains(with_band.out, R"("band":"b")"));
}

TEST_CASE("a lower bound above --at-most is an answer, also where no match was found", "[cli]") {
  const TemporaryFolder folder;
  const std::string band =
      folder.write("b.csv", "size_mm,passing_min_percent,passing_max_percent\n2,20,30\n4,40,60\n");
  const std::string gradation = folder.write("g.csv", "size_mm,passing_percent\n1,0\n2,60\n4,90\n8,100\n");
  const Arguments question = {"solve", gradation, "--band", band, "--law", "power:2", "--at-most", "3"};
  Arguments as_json = question;
  as_json.insert(as_json.end(), {"--format", "json"});
  const Outcome none = mdm(as_json);
  INFO(none.out << none.err);
  CHECK(none.exit_code == 1);
  const Json answer = Json::parse(none.out);
  CHECK(answer.at("status") == "none");
  CHECK(Integer(answer.at("lower_bound").get<std::string>()) > 3);
  CHECK(contains(mdm(question).out, "no match within the limit on N"));
}

} // namespace tolerance_test
