// mdm tradeoff as a whole program.

#include "answer.hpp"
#include "tools.hpp"

namespace tradeoff_test {

using namespace cli_test;

namespace {

const std::string sand = example("athabasca-sand");
const std::string halves = "size_mm,mass\n1,1\n2,1\n3,0\n";

Outcome tradeoff(Arguments arguments, const std::string &standard_input = "") {
  arguments.insert(arguments.begin(), "tradeoff");
  return mdm(arguments, standard_input);
}

Json json(const Arguments &arguments, int exit_code = 0, const std::string &standard_input = "") {
  Arguments all = arguments;
  all.insert(all.end(), {"--format", "json"});
  const Outcome outcome = tradeoff(all, standard_input);
  INFO(outcome.err);
  CHECK(outcome.exit_code == exit_code);
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 1);
  return Json::parse(outcome.out);
}

} // namespace

TEST_CASE("the trade-off as text has a table for each choice", "[cli]") {
  const Outcome outcome = tradeoff({"-", "--tolerances", "50,0,1"}, halves);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == "stdin: the smallest match within a tolerance, and without the finest classes\n\n"
                       "  retained within (%)  particles  times fewer\n"
                       "                    0          3            1\n"
                       "                    1          2          1.5\n"
                       "                   50          1            3\n\n"
                       "  smallest sieve kept (mm)  mass lost (%)  particles  times fewer\n"
                       "                         1              0          3            1\n"
                       "                         2             50          1            3\n");
}

TEST_CASE("the trade-off of a real sand never rises", "[cli]") {
  for (const char *kind : {"retained", "passing", "total"}) {
    const Json t = json({sand, "--kind", kind});
    CHECK(t.at("schema") == "mdm-tradeoff-1");
    CHECK(t.at("id") == "athabasca-sand");
    CHECK(t.at("kind") == kind);
    CHECK(t.at("unit") == "mm");
    CHECK(t.at("question") == "");
    CHECK(t.at("versions").contains("mdm"));
    CHECK(t.at("by_tolerance").size() == 7);
    CHECK(t.at("by_tolerance").at(0).at("particles") == "1485");
    CHECK(t.at("by_sieve").size() == 7);
    CHECK(t.at("by_sieve").at(3).at("lost") == "1527/10000");
    CHECK(t.at("by_sieve").at(6).at("particles") == "1");
    for (const char *curve : {"by_tolerance", "by_sieve"}) {
      Integer last = 1485;
      for (const Json &row : t.at(curve)) {
        const Integer n(row.at("particles").get<std::string>());
        CHECK(n <= last);
        CHECK(row.at("status") == "optimal");
        CHECK(row.at("lower_bound") == row.at("particles"));
        last = n;
      }
    }
  }
}

TEST_CASE("the trade-off over the whole range has the least tolerance of every budget", "[cli]") {
  const Json rows = json({sand, "--particles", "all", "--tolerances", "0,1"}).at("by_tolerance");
  REQUIRE(rows.size() > 8);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    CHECK(rational(rows[i - 1].at("tolerance")) < rational(rows[i].at("tolerance")));
    CHECK(Integer(rows[i].at("particles").get<std::string>()) <=
          Integer(rows[i - 1].at("particles").get<std::string>()));
  }
  CHECK(rows.back().at("particles") == "1");
  const Json hundred = json({sand, "--particles", "100", "--tolerances", "0"}).at("by_tolerance").at(1);
  const Json solved = solve_json({sand, "--particles", "100"});
  CHECK(rational(hundred.at("tolerance")) == rational(solved.at("budget").at("tolerance")));
  CHECK(hundred.at("particles") == solved.at("particles"));
  const Arguments budget = {sand, "--particles", "100"};
  const auto beside = [&budget](Arguments options) {
    options.insert(options.begin(), budget.begin(), budget.end());
    return options;
  };
  CHECK(json(beside({"--tolerance", "passing"})) == json(beside({"--kind", "passing"})));
  CHECK(json(beside({"--tolerance", "passing"})) != json(budget));
  CHECK(json(beside({"--verbose"})) == json(budget));
  CHECK(contains(tradeoff(beside({"--tolerance", "passing", "--kind", "total"})).err,
                 "--kind: --tolerance says passing: leave one of them out"));
  CHECK(contains(tradeoff({sand, "--grid", "1"}).err, "--grid: it is of --particles"));
  CHECK(contains(tradeoff({sand, "--particles", "5", "--tolerance", "1%"}).err, "--particles: it chooses"));
  CHECK(contains(tradeoff({sand, "--particles", "1,x"}).err, "'x' is not a whole number"));
}

TEST_CASE("the options of the gradation and the floor change both curves", "[cli]") {
  const Json t = json(
      {sand, "--cut-below", "0.25", "--size-factor", "2", "--min-per-class", "5", "--tolerances", "0,1%"});
  CHECK(t.at("question") ==
        "at least 5 particles in each class; classes below 0.25 mm left out; sizes multiplied by 2");
  CHECK(t.at("by_sieve").size() == 3);
  CHECK(t.at("by_sieve").at(0).at("smallest") == "0.5");
  CHECK(t.at("by_sieve").at(2).at("particles") == "5");
  const Json exact = solve_json({sand, "--cut-below", "0.25", "--min-per-class", "5"});
  CHECK(t.at("by_sieve").at(0).at("particles") == exact.at("particles"));
  CHECK(t.at("by_tolerance").at(0).at("particles") == exact.at("particles"));
}

TEST_CASE("every row of the trade-off answers the whole question", "[cli]") {
  const Arguments specimen = {"--specimen", "cylinder:5x10", "--void-ratio", "0.6", "--at-least", "300"};
  const auto with = [&](Arguments options) {
    options.insert(options.begin(), sand);
    options.insert(options.end(), specimen.begin(), specimen.end());
    return options;
  };
  const Json t = json(with({"--tolerances", "0,2"}));
  CHECK(t.at("by_tolerance").at(0).at("particles") == solve_json(with({})).at("particles"));
  CHECK(t.at("by_tolerance").at(1).at("particles") ==
        solve_json(with({"--tolerance", "retained:2%"})).at("particles"));
  CHECK(t.at("by_sieve").at(3).at("particles") == solve_json(with({"--cut-below", "0.15"})).at("particles"));
  CHECK(t.at("by_sieve").at(6).at("particles") == "300");
}

TEST_CASE("the trade-off's tolerances hold besides those of the question", "[cli]") {
  const Json t = json({sand, "--tolerance", "total:5%", "--tolerances", "0,1"});
  CHECK(t.at("by_tolerance").at(0).at("particles") == "1485");
  CHECK(t.at("by_tolerance").at(1).at("particles") ==
        solve_json({sand, "--tolerance", "total:5%", "--tolerance", "retained:1%"}).at("particles"));
  CHECK(t.at("by_sieve").at(0).at("particles") ==
        solve_json({sand, "--tolerance", "total:5%"}).at("particles"));
  CHECK(t.at("by_sieve").at(2).at("particles") ==
        solve_json({sand, "--tolerance", "total:5%", "--cut-below", "0.11"}).at("particles"));
}

TEST_CASE("rows of the trade-off without a match say so", "[cli]") {
  const TemporaryFolder folder;
  const std::string band =
      folder.write("band.csv", "size_mm,passing_min_percent,passing_max_percent\n0.11,6,10\n");
  const Outcome outcome = tradeoff({sand, "--band", band, "--tolerances", "0,1,2"});
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.out, "                    0       none            -\n"));
  const Json t = json({sand, "--band", band, "--tolerances", "0,1,2"});
  CHECK(t.at("by_tolerance").at(0).at("status") == "none");
  CHECK(t.at("by_tolerance").at(0).at("particles").is_null());
  CHECK(t.at("by_tolerance").at(1).at("particles") ==
        solve_json({sand, "--band", band, "--tolerance", "retained:1%"}).at("particles"));
  CHECK(t.at("by_sieve").at(0).at("status") == "optimal");
  CHECK(t.at("by_sieve").at(2).at("status") == "none");
  CHECK(json({sand, "--at-most", "500", "--tolerances", "0,5"}).at("by_tolerance").at(0).at("status") ==
        "none");
  check_refused(tradeoff({sand, "--at-most", "0", "--tolerances", "0", "--plot", folder / "t.svg"}),
                "nothing can be drawn");
}

TEST_CASE("budgets that no tolerance reaches, and matches that are too large, are told", "[cli]") {
  const Outcome missed = tradeoff({sand, "--at-least", "2000", "--particles", "50", "--tolerances", "0"});
  CHECK(missed.exit_code == 0);
  CHECK(contains(missed.out, "note: there is no tolerance with which so few particles suffice: 50\n"));
  const Outcome at_most = tradeoff({sand, "--at-most", "1", "--tolerances", "0"});
  CHECK(at_most.exit_code == 0); // without its finer classes one particle is enough
  CHECK(contains(at_most.out, "note: where more than 1 particles are needed there is none: --at-most\n"));
}

TEST_CASE("a limit leaves rows with bounds and exit code 3", "[cli]") {
  const Json t = json({example("ottawa-f65-sand"), "--node-limit", "2", "--tolerances", "0,1"}, 3);
  CHECK(t.at("by_tolerance").at(0).at("status") == "optimal");
  const Json &row = t.at("by_tolerance").at(1);
  CHECK(row.at("status") == "feasible");
  CHECK(Integer(row.at("particles").get<std::string>()) > Integer(row.at("lower_bound").get<std::string>()));
  const Outcome text = tradeoff({sand, "--time-limit", "0", "--tolerances", "1"});
  CHECK(text.exit_code == 3);
  CHECK(contains(text.out, "[1021, 1485]")); // 1021 is the least
}

TEST_CASE("the trade-off as CSV goes to a file, notes to standard error", "[cli]") {
  const TemporaryFolder folder;
  const Outcome outcome = tradeoff({"-", "--tolerances", "0", "--format", "csv", "-o", folder / "t.csv"},
                                   "size_mm,passing_percent\n1,10\n2,100\n");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.empty());
  CHECK(contains(outcome.err, "note: A pan of size 0 was added"));
  CHECK(read_file(folder / "t.csv") ==
        "kind,tolerance_percent,smallest_mm,lost_percent,particles,lower_bound,status\n"
        "retained,0,0,0,2,2,optimal\nretained,0,0,0,2,2,optimal\nretained,0,1,10,1,1,optimal\n");
}

TEST_CASE("the trade-off refuses what makes no sense, and leaves no file", "[cli]") {
  const TemporaryFolder folder;
  const auto refused = [&folder](Arguments options, const std::string &message) {
    options.insert(options.begin(), {sand, "-o", folder / "out"});
    check_refused(tradeoff(options), message);
    CHECK(folder.entries() == 0);
  };
  for (const char *list : {"1,,2", ",", "1,x", "nan", "-1", "101", "1;2", "1%%"})
    refused({std::string("--tolerances=") + list}, "--tolerances: ");
  refused({"--tolerances", "1,,2"}, "--tolerances: a value is missing");
  refused({"--kind", "rounding"}, "--kind");
  refused({"--plot", folder / "a.gif"}, "let OUT end in .svg, .png or .pdf");
  refused({"--plot", "-"}, "--plot needs a file");
  refused({"--plot", folder / "out"}, "different names");
  refused({"--time-limit", "-1"}, "--time-limit");
  refused({"--law", "power:5/2"}, "use a law with a whole exponent");
  refused({"--specimen", "cylinder:1x2"}, "belong together");
  refused({"--digits", "none"}, "--digits");
  refused({"--scale", "lower"}, "--scale");
  refused({"--cut-below", "0.2"}, "athabasca-sand.csv: there is no sieve of");
}

TEST_CASE("the trade-off of a specimen has the least size factor of every budget", "[cli]") {
  const Arguments asked = {"tradeoff",     example("athabasca-sand"),
                           "--specimen",   "cylinder:50x100",
                           "--void-ratio", "0.6",
                           "--tolerances", "0",
                           "--particles",  "20000,2000000"};
  const auto as = [&asked](const std::string &format) {
    Arguments all = asked;
    all.insert(all.end(), {"--format", format});
    return mdm(all).out;
  };
  const Json rows = Json::parse(as("json")).at("by_size_factor");
  REQUIRE(rows.size() == 3);
  CHECK(rows[0].at("size_factor") == "1");
  CHECK(rows[1].at("size_factor") == "2.652");
  CHECK(rows[1].at("particles") == "1999776");
  CHECK(rows[2].at("size_factor") == "12.31");
  CHECK(rows[2].at("coarsest") == "1");
  CHECK(rows[2].at("specimen_over_largest") == "6250/3693"); // 50 / (2.4 * 12.31)
  CHECK(as("csv").find("retained,0,0.038,0,19999,19999,optimal,12.31\n") != std::string::npos);
  CHECK(as("text").find("from the size factor 12.31 on the specimen is less than 6") != std::string::npos);
  Arguments magnified = asked;
  magnified.insert(magnified.end(), {"--size-factor", "2", "--format", "json"});
  CHECK_FALSE(Json::parse(mdm(magnified).out).contains("by_size_factor"));
}

TEST_CASE("the trade-off is drawn beside its tables", "[cli]") {
  const TemporaryFolder folder;
  const Outcome outcome = tradeoff({sand, "--tolerances", "0,1,5", "--plot", folder / "t.svg"});
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.out, "smallest sieve kept (mm)"));
  const std::string svg = read_file(folder / "t.svg");
  for (const char *text : {"1485", "1021", "238", "mass lost (percent)", "smallest sieve kept (mm)"})
    CHECK(svg.find(text) != std::string::npos);
  CHECK(folder.entries() == 1);
}

TEST_CASE("tolerances may stand with spaces", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("g.csv", "size_mm,mass\n1,2\n2,1\n3,0\n");
  CHECK(mdm({"tradeoff", file, "--tolerances", " 0, 1% "}).out ==
        mdm({"tradeoff", file, "--tolerances", "0,1"}).out);
}

} // namespace tradeoff_test
