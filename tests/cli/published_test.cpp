// mdm published: what it reports, what it refuses.

#include "answer.hpp"

#include <sstream>

namespace published_test {

using namespace cli_test;

namespace {

const std::string athabasca = example("athabasca-sand");

Json published(const Arguments &arguments, int exit_code = 0) {
  Arguments all{"published"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.insert(all.end(), {"--format", "json"});
  const Outcome outcome = mdm(all);
  INFO(outcome.err);
  CHECK(outcome.exit_code == exit_code);
  const Json answer = Json::parse(outcome.out);
  CHECK(answer.at("schema") == "mdm-published-1");
  return answer;
}

} // namespace

TEST_CASE("the published code's default finds its known numbers for real sands", "[cli]") {
  const Arguments knob{"--start", "0.5", "--increments", "1"};
  const auto particles = [&](const std::string &name) {
    Arguments arguments{"spanned-integer", example(name)};
    arguments.insert(arguments.end(), knob.begin(), knob.end());
    const Json answer = published(arguments);
    CHECK(answer.at("match") == true);
    return answer.at("particles").get<std::string>();
  };
  CHECK(particles("athabasca-sand") == "10350");
  CHECK(particles("c778-graded-sand") == "452");
  CHECK(particles("limestone-pfc") == "20577");
}

TEST_CASE("a report has the ratios, every iteration's exact error and the least match", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("two.csv", "size_mm,mass\n1,1\n2,5\n4,0\n");
  const Json fixed = published({"fixed-size", file, "--sizes", "upper", "--tolerance", "0%"});
  CHECK(fixed.at("reached") == true);
  CHECK(fixed.at("match") == true);
  CHECK(fixed.at("particles") == "13");
  CHECK(fixed.at("least") == "2");
  CHECK(fixed.at("ratio") == "13/2");
  const Json &finer = fixed.at("classes").at(0);
  CHECK(finer.at("phi") == "1/5");
  CHECK(finer.at("zeta") == Json({"8", "8"}));
  CHECK(finer.at("kappa") == Json({"8/5", "8/5"}));
  CHECK(finer.at("size") == Json({"2", "2"}));
  std::vector<std::string> errors;
  for (const Json &iteration : fixed.at("iterations"))
    errors.push_back(iteration.at("total_error"));
  CHECK(errors == std::vector<std::string>{"1/15", "1/57", "1/87", "1/57", "0"});
  CHECK(fixed.at("iterations").at(0).at("worst_class") == "1");
  CHECK(fixed.at("iterations").at(4).at("worst_class").is_null());
  const Outcome csv =
      mdm({"published", "fixed-size", file, "--sizes", "upper", "--tolerance", "0%", "--format", "csv"});
  CHECK(csv.out.find("\n5,1,13,0,0,\n") != std::string::npos);
  CHECK(fixed.at("iterations").at(0).at("errors") == Json({"-1/30", "1/30"}));

  const Json rounded = published({"rounded", file, "--sizes", "volume"});
  CHECK(rounded.at("match") == false);
  CHECK(rounded.at("classes").at(0).at("kappa").at(0) == "8/5");
  CHECK(rounded.at("iterations").size() == 1);
  // The size with the mean of the volumes 1 and 8 is the cube root of 9/2.
  const Json size = rounded.at("classes").at(0).at("size");
  CHECK(size.at(0).get<std::string>().rfind("1.6509636", 0) == 0);
}

TEST_CASE("what does not reach its end is reported with exit 1", "[cli]") {
  const Json fixed = published({"fixed-size", athabasca, "--tolerance", "0%", "--max-iterations", "3"}, 1);
  CHECK(fixed.at("reached") == false);
  CHECK(fixed.at("iterations").size() == 3);
  const TemporaryFolder folder;
  const std::string file = folder.write("open.csv", "size_mm,mass\n2,1\n3,8\n4,0\n");
  const Json open_end = published({"spanned-integer", file}, 1);
  CHECK(open_end.at("reached") == true);
  CHECK(open_end.at("match") == false);
  CHECK(open_end.at("particles") == "2");
  CHECK(open_end.at("least") == "3");
  CHECK(open_end.at("notes").size() == 1);
}

TEST_CASE("the iterations are CSV, and text is for people", "[cli]") {
  const Outcome csv = mdm({"published", "fixed-size", athabasca, "--sizes", "lower", "--format", "csv"});
  CHECK(csv.out.rfind("multiple,sizes_tried,particles,total_error,maximum_error,worst_class\n1,1,", 0) == 0);
  const Outcome text = mdm({"published", "spanned-integer", athabasca});
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("an exact match; the smallest exact match has 1485") != std::string::npos);
}

TEST_CASE("the example of proofs/README.md can be repeated: a window between two increments", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("window.csv", "size_mm,mass\n8,8\n9,9\n10,11\n11,0\n");
  const std::string readme = read_file(std::string(MDM_SOURCE_DIR) + "/proofs/README.md");
  CHECK(readme.find("With n = 10, 20, 50 or 100 increments of the class (`mdm published spanned-integer FILE "
                    "--start 1/n\n"
                    "--increments n`)") != std::string::npos);
  CHECK(readme.find("(`--start 1/127 --increments 127`)") != std::string::npos);
  const auto with_increments = [&](const std::string &n) {
    return published({"spanned-integer", file, "--start", "1/" + n, "--increments", n});
  };
  for (const char *n : {"10", "20", "50", "100"}) {
    const Json answer = with_increments(n);
    CHECK(answer.at("particles") == "7");
    CHECK(answer.at("match") == true);
    CHECK(answer.at("iterations").size() == 2);
  }
  for (const char *n : {"127", "128", "200"}) {
    const Json answer = with_increments(n);
    CHECK(answer.at("particles") == "3");
    CHECK(answer.at("match") == true);
    CHECK(answer.at("iterations").size() == 1);
  }
  const Outcome text = mdm({"published", "spanned-integer", file, "--start", "1/127", "--increments", "127"});
  CHECK(text.out.find("x_nS from 1/127 of its class") != std::string::npos);
}

TEST_CASE("an interior sieve with nothing retained is no obstacle", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("gap.csv", "size_mm,mass\n0,2\n1,0\n2,5\n4,0\n8,0\n");
  for (const char *algorithm : {"rounded", "fixed-size", "spanned-integer"}) {
    const Json answer = published({algorithm, file});
    CHECK(answer.at("classes").at(1).at("quantity") == "0");
    CHECK(answer.at("classes").at(1).at("size").is_null());
    CHECK(answer.at("classes").at(3).at("quantity") == "0");
  }
}

TEST_CASE("the tolerance of the fixed size algorithm has the words of every tolerance", "[cli]") {
  const auto settings = [](const std::string &tolerance) {
    return mdm({"published", "fixed-size", athabasca, "--tolerance", tolerance}).out;
  };
  CHECK(settings("total:2%") == settings("2%"));
  CHECK(settings("2") == settings("2%"));
  CHECK(contains(settings("total:2"), "total error up to 2 %"));
}

TEST_CASE("published refuses what it cannot do, with a remedy", "[cli]") {
  const TemporaryFolder folder;
  const auto refused = [&](Arguments arguments, const std::string &part) {
    arguments.insert(arguments.begin(), "published");
    arguments.insert(arguments.end(), {"-o", folder / "out"});
    check_refused(mdm(arguments), part);
    CHECK(folder.entries() == 0);
  };
  refused({"best", athabasca}, "spanned-integer");
  refused({"rounded", athabasca, "--tolerance", "1%"}, "not an option of rounded");
  refused({"fixed-size", athabasca, "--start", "0.5"}, "not an option of fixed-size");
  refused({"fixed-size", athabasca, "--tolerance", "retained:1%"}, "stops at a total error: write total:1%");
  refused({"fixed-size", athabasca, "--tolerance", "laboratory"}, "stops at a total error: write total:1%");
  refused({"fixed-size", athabasca, "--tolerance", "-1%"}, "not between 0 and 200");
  refused({"fixed-size", athabasca, "--sizes", "upper", "--size-at", "0.5"}, "give one of them");
  refused({"fixed-size", athabasca, "--size-at", "0"}, "not positive");
  refused({"fixed-size", athabasca, "--size-at", "1.01"}, "above 1");
  refused({"spanned-integer", athabasca, "--start", "1/0"}, "not positive");
  refused({"spanned-integer", athabasca, "--start", "3/2"}, "above 1");
  refused({"spanned-integer", athabasca, "--start", "1/2/3"}, "--start");
  refused({"fixed-size", athabasca, "--max-iterations", "0"}, "whole number from 1 on");
  refused({"fixed-size", athabasca, "--max-iterations", "100001"}, "at most 100000");
  refused({"spanned-integer", athabasca, "--law", "power:5/2"}, "athabasca-sand.csv: the law x^(5/2)");
  refused({"spanned-integer", athabasca + ".not"}, "cannot be read");
}

TEST_CASE("where the least match takes too long there are bounds, and exit 3", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "narrow.json",
      R"({"sizes":["1","1.00000000000000000001","1.00000000000000000002","1.00000000000000000004","2"],)"
      R"("masses":["1","1.3","3","7","0"]})");
  const Json rounded = published({"rounded", file}, 3);
  REQUIRE(rounded.at("least").size() == 2);
  CHECK(rounded.at("least").at(0) != rounded.at("least").at(1));
  CHECK(rounded.at("ratio").size() == 2);
  CHECK(rounded.at("notes").size() == 1);
  const Outcome plot = mdm({"plot", file, "--match", "-o", folder / "a.svg"});
  CHECK(plot.exit_code == 3);
  CHECK(plot.err.find("narrow.json: nothing was drawn") != std::string::npos);
  CHECK(folder.entries() == 1);
}

} // namespace published_test
