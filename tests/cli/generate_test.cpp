// mdm generate: representative sets as a user sees them.

#include "answer.hpp"

namespace generate_test {

using namespace cli_test;

namespace {

/// N' of two isochoric classes of discs on [1, 2]: d_m = 6/5 and 12/7, (10/7)^2 = 2.04.
const Arguments two = {"generate", "--beta",          "1,1", "--dmin",     "1",         "--ratio",
                       "2",        "--classes",       "2",   "--classing", "isochoric", "--dimension",
                       "2",        "--min-per-class", "100", "--at-least", "1"};

Arguments with(Arguments arguments, const Arguments &more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

Json json(const Arguments &arguments, int exit_code = 0) {
  const Outcome outcome = mdm(with(arguments, {"--format", "json"}));
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == exit_code);
  return Json::parse(outcome.out);
}

} // namespace

TEST_CASE("the set has the counts, bounds and fractions of its classes", "[generate]") {
  const Json set = json(two);
  CHECK(set.at("schema") == "mdm-generate-1");
  CHECK(set.at("particles") == "304");
  CHECK(set.at("classes")[0].at("quantity") == "204");
  CHECK(set.at("classes")[0].at("lower") == Json({"1", "1"}));
  CHECK(set.at("classes")[0].at("upper") == Json({"1.5", "1.5"}));
  CHECK(set.at("classes")[1].at("volume_fraction") == Json({"0.5", "0.5"}));
  CHECK_FALSE(set.contains("sizes"));
}

TEST_CASE("sizes are exact fractions in dimension 2, and the same for the same seed", "[generate]") {
  Arguments few = {"generate", "--beta",      "1,1", "--dmin",          "1", "--dmax",     "2", "--classes",
                   "1",        "--dimension", "2",   "--min-per-class", "2", "--at-least", "1", "--sizes"};
  // 2 / (2 - y) at y = 1/4 and 3/4
  CHECK(json(few).at("sizes") == Json({"8/7", "8/5"}));
  CHECK(json(with(few, {"--seed", "7"})).at("seed") == "7");
  CHECK(json(few).at("seed").is_null());
  CHECK(json(with(few, {"--seed", "7"})) == json(with(few, {"--seed", "7"})));
  CHECK(json(with(few, {"--seed", "7"})) != json(with(few, {"--seed", "8"})));
  const Outcome csv = mdm(with(few, {"--format", "csv", "--digits", "4"}));
  CHECK(csv.out == "class,size_lo,size_hi\n1,1.142,1.143\n1,1.6,1.6\n");
}

TEST_CASE("the exact alternative matches what was rounded", "[generate]") {
  const Json set = json(with(two, {"--method", "match"}));
  CHECK(set.at("method") == "match");
  CHECK(set.at("particles").get<std::string>().size() <= 3);
  for (const Json &c : set.at("classes"))
    CHECK(std::stoi(c.at("quantity").get<std::string>()) >= 100);
  const Outcome text = mdm(with(two, {"--method", "match"}));
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("N = 304") != std::string::npos);
  CHECK(text.out.find("rounded to 6 digits") != std::string::npos);
}

TEST_CASE("a spread of the exact alternative has every class's volume exactly", "[generate]") {
  const Arguments match = with(two, {"--method", "match"}), spread = with(match, {"--spread"});
  const Json set = json(spread);
  CHECK((set.at("sizes") == json(with(spread, {"--seed", "1"})).at("sizes")));
  CHECK((set.at("sizes") != json(with(spread, {"--seed", "2"})).at("sizes")));
  // Discs from 1 to 2 in two classes: in each, sizes at the lower ends have too little and at the upper too
  // much for the ratio of the classes.
  std::size_t i = 0;
  std::vector<Rational> low, high, fraction;
  for (const Json &c : set.at("classes")) {
    low.emplace_back(0);
    high.emplace_back(0);
    fraction.push_back(rational(c.at("volume_fraction")[0]));
    for (int left = std::stoi(c.at("quantity").get<std::string>()); left > 0; --left, ++i) {
      const Json &size = set.at("sizes").at(i);
      CHECK(rational(c.at("lower")[0]) < rational(size[0]));
      CHECK(rational(size[1]) <= rational(c.at("upper")[0]));
      low.back() += rational(size[0]) * rational(size[0]);
      high.back() += rational(size[1]) * rational(size[1]);
    }
  }
  CHECK(i == set.at("sizes").size());
  REQUIRE(low.size() == 2);
  CHECK(low[0] * fraction[1] < high[1] * fraction[0]);
  CHECK(low[1] * fraction[0] < high[0] * fraction[1]);
  CHECK(high[0] - low[0] < high[0] / 1000000000);
  check_refused(mdm(with(two, {"--spread"})), "--method match");
  check_refused(mdm(with(spread, {"--format", "csv", "--quantiles"})), "--quantiles");
  check_refused(mdm(with(spread, {"--format", "csv", "--table", "5"})), "--spread and --table");
  CHECK(json(with(spread, {"--sizes"})) == set);
  CHECK(lines_of(mdm(with(spread, {"--format", "csv"})).out).size() == i + 1);
}

TEST_CASE("a spread of a real sand has the curve as well as sizes drawn by the paper", "[generate]") {
  const Json set = json({"generate", "--curve", example("hostun-rf-sand"), "--method", "match", "--spread",
                         "--at-least", "200000", "--seed", "1"});
  const auto c_r = [&](const char *of) {
    return std::stod(set.at("quality").at(of).at("Cr").at(1).get<std::string>());
  };
  CHECK(c_r("match") <= c_r("drawn"));
  CHECK(c_r("match") < 0.0075);
}

TEST_CASE("of a spread as of drawn sizes, the quality of large sets is told if asked for", "[generate]") {
  const auto spread = [](const std::string &at_least, const Arguments &more) {
    Arguments arguments = with(two, {"--method", "match", "--spread"});
    *(std::find(arguments.begin(), arguments.end(), "--at-least") + 1) = at_least;
    return with(arguments, more);
  };
  const Json many = json(spread("1000010", {}));
  REQUIRE(many.at("notes").size() == 2);
  CHECK(many.at("notes")[0].get<std::string>().find("the mean volume of the particles") == 0);
  CHECK(many.at("notes")[1].get<std::string>().find("--points") != std::string::npos);
  CHECK_FALSE(many.contains("quality"));
  const Json few = json(spread("10", {}));
  CHECK(few.at("notes").size() == 1);
  CHECK_FALSE(few.at("quality").at("match").is_null());
  // Too many even if asked for; and none of them can be listed.
  CHECK(mdm(spread("1000000001", {"--points", "2"})).out.find("the match, spread") == std::string::npos);
  for (const char *format : {"json", "csv"})
    check_refused(mdm(spread("1000000001", {"--format", format})), "10^9");
}

TEST_CASE("a match has no error, whatever its rounded volumes add up to", "[generate]") {
  const Json set =
      json({"generate", "--beta", "1,3", "--dmin", "0.1", "--ratio", "20", "--classes", "4", "--match-digits",
            "2", "--dimension", "2", "--min-per-class", "1", "--at-least", "1", "--method", "match"});
  Rational all = 0;
  for (const Json &c : set.at("classes"))
    all += rational(c.at("volume_fraction")[0]);
  REQUIRE(all != 1);
  CHECK(set.at("quality").at("match").at("worst_error") == Json({"0", "0"}));
}

TEST_CASE("a table of the curve is exact where the curve is", "[generate]") {
  const Json set = json(with(two, {"--table", "3"}));
  CHECK(set.at("curve")[1].at("size") == Json({"1.5", "1.5"}));
  CHECK(set.at("curve")[1].at("passing") == Json({"0.5", "0.5"}));
}

TEST_CASE("a set that is not accessible is a negative verdict", "[generate]") {
  CHECK(json(with(two, {"--at-most", "304"})).at("accessible") == true);
  CHECK(json(with(two, {"--at-most", "303"}), 1).at("accessible") == false);
}

TEST_CASE("no particle has more of its class than --largest-share", "[generate]") {
  // Discs in the classes [1, 3/2] and [3/2, 2]: (u / d_m)^2 is 25/16 and 49/36, so 10 % takes 16 and 14
  // particles. The second class is the scarcer: 14, and the first has 14 (10/7)^2 = 28.57.
  Arguments some = {"generate", "--beta",          "1,1", "--dmin",     "1",         "--ratio",
                    "2",        "--classes",       "2",   "--classing", "isochoric", "--dimension",
                    "2",        "--min-per-class", "1",   "--at-least", "1",         "--largest-share",
                    "10%"};
  const Json set = json(some);
  CHECK(set.at("classes")[0].at("quantity") == "28");
  CHECK(set.at("classes")[1].at("quantity") == "14");
  // 0.5 % takes 312.5 and 272.2: 313 and 273, and the first has 273 (10/7)^2 = 557.1.
  some.back() = "0.5";
  CHECK(json(some).at("classes")[0].at("quantity") == "557");
  CHECK(json(some).at("classes")[1].at("quantity") == "273");
  // Particles of one size: 1 / P of them.
  some.back() = "4%";
  const Json matched = json(with(some, {"--method", "match"}));
  for (const Json &c : matched.at("classes"))
    CHECK(std::stoi(c.at("quantity").get<std::string>()) >= 25);
  // A spread: (3/2)^2 / P = 56.25 in the first, wider class.
  const Json spread = json(with(some, {"--method", "match", "--spread"}));
  for (const Json &c : spread.at("classes"))
    CHECK(std::stoi(c.at("quantity").get<std::string>()) >= 57);
  CHECK(mdm(some).out.find("no particle above 4 % of its class") != std::string::npos);
  for (const char *wrong : {"0", "101%", "-1", "x", "1e-7"}) {
    some.back() = wrong;
    check_refused(mdm(some), "--largest-share");
  }
}

TEST_CASE("the shapes with a C_u and a C_c are boxes, at the spans that are asked for", "[generate]") {
  const Json found = json({"generate", "--cu", "4", "--cc", "2", "--span", "0.5,0.95"}, 0);
  CHECK(found.at("schema") == "mdm-inverse-1");
  CHECK(found.at("spans")[0].at("boxes").empty()); // d_60 / d_10 is below 3
  REQUIRE(found.at("spans")[1].at("boxes").size() == 1);
  const Json &box = found.at("spans")[1].at("boxes")[0];
  CHECK(box.at("holds_one") == true);
  CHECK(std::stod(box.at("a")[0].get<std::string>()) == Approx(0.76716).epsilon(1e-3));
  CHECK(std::stod(box.at("b")[1].get<std::string>()) == Approx(0.24813).epsilon(1e-3));
  const Outcome none = mdm({"generate", "--cu", "6", "--cc", "7", "--span", "0.9", "--format", "csv"});
  CHECK(none.exit_code == 1);
  CHECK(none.out == "span,a_lo,a_hi,b_lo,b_hi,shapes\n0.9,,,,,none\n");
  // The shape is (0.8624497866, 1.6134880730), by scipy.
  const Outcome edge =
      mdm({"generate", "--cu", "6", "--cc", "1.2", "--span", "0.95", "--within", "0.86244:20"});
  CHECK(edge.exit_code == 3);
  CHECK(edge.out.find("not certain") != std::string::npos);
}

TEST_CASE("the shape of a gradation has its C_u and C_c, and the span of its sieves", "[generate]") {
  const std::string graded = "size_mm,passing_percent\n0.1,0\n0.2,10\n0.5,30\n1.2,60\n4,100\n";
  const Outcome fit = mdm({"generate", "--fit", "-", "--format", "json"}, graded);
  INFO(fit.err);
  CHECK((fit.exit_code == 0 || fit.exit_code == 1));
  const Json found = Json::parse(fit.out);
  CHECK(found.at("Cu") == Json({"6", "6"}));
  CHECK(found.at("spans")[0].at("span") == "39/41");
  check_refused(mdm({"generate", "--fit", "-"}, "size_mm,passing_percent\n0.2,12\n0.5,30\n1.2,60\n4,100\n"),
                "D10");
  check_refused(mdm({"generate", "--fit", "-"}, "size_mm,passing_percent\n0.2,9\n0.5,30\n1.2,60\n4,100\n"),
                "--span");
}

TEST_CASE("what asks for no shapes is refused", "[generate]") {
  check_refused(mdm({"generate", "--cu", "6"}), "belong together");
  check_refused(mdm({"generate", "--cc", "6"}), "belong together");
  check_refused(mdm({"generate", "--within", "1:2"}), "belong together");
  check_refused(mdm({"generate", "--cu", "0.5", "--cc", "1"}), "below 1");
  check_refused(mdm({"generate", "--cu", "0", "--cc", "1"}), "not positive");
  check_refused(mdm({"generate", "--cu", "6", "--cc", "1", "--span", "1"}), "not below 1");
  check_refused(mdm({"generate", "--cu", "6", "--cc", "1", "--within", "2"}), "FROM:TO");
  check_refused(mdm({"generate", "--cu", "6", "--cc", "1", "--within", "2:1"}), "FROM below TO");
  check_refused(mdm({"generate", "--cu", "6", "--cc", "1", "--within", "0.0001:1"}), "from 0.001 to 1000");
  check_refused(mdm({"generate", "--cu", "6", "--cc", "1", "--beta", "1,1"}), "make no set");
  check_refused(mdm({"generate", "--cu", "6", "--cc", "1", "--fit", "-"}, ""), "leave out");
  check_refused(mdm({"generate", "--cu", "6", "--cc", "1", "--plot", "shapes.gif"}), "--plot");
}

TEST_CASE("CSV leaves the verdict to standard error", "[generate]") {
  const Outcome done = mdm(with(two, {"--format", "csv", "--at-most", "304"}));
  CHECK(done.exit_code == 0);
  CHECK(done.err.empty());
  const Outcome many = mdm(with(two, {"--format", "csv", "--at-most", "303", "--quiet"}));
  CHECK(many.exit_code == 1);
  CHECK(many.err == "beta curve (1, 1): volume density uniform; grading curve a straight line: not "
                    "accessible with N_max = 303: N = 304 "
                    "(sum N' = 304)\n");
  const Outcome open = mdm({"generate", "--curve", "-", "--classing", "isochoric", "--classes", "2",
                            "--dimension", "2", "--at-least", "1", "--format", "csv"},
                           "size_mm,passing_percent\n1,0\n2,100\n");
  CHECK(open.exit_code == 3);
  CHECK(open.err.find("N is not known") != std::string::npos);
}

TEST_CASE("sets of measured curves have the sieves as classes", "[generate]") {
  const Outcome outcome = mdm({"generate", "--curve", "-", "--format", "csv", "--dimension", "2",
                               "--min-per-class", "3", "--at-least", "1"},
                              "size_mm,passing_percent\n1,0\n2,50\n4,50\n8,100\n");
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out ==
        "class,lower_lo,lower_hi,upper_lo,upper_hi,volume_fraction_lo,volume_fraction_hi,quantity,"
        "number_fraction_lo,number_fraction_hi\n"
        "1,1,1,2,2,0.5,0.5,48,0.941176470588235,0.941176470588236\n2,2,2,4,4,0,0,0,0,0\n"
        "3,4,4,8,8,0.5,0.5,3,0.0588235294117647,0.0588235294117648\n");
  CHECK(outcome.err.find("no volume, thus no particles, in class 2") != std::string::npos);
}

TEST_CASE("the factors of a file turn its masses into volumes", "[generate]") {
  const Arguments curve = {"generate",   "--curve", "-",        "--method", "match",
                           "--at-least", "100",     "--format", "json"};
  const std::string dense = "size_mm,mass,factor\n1,3,2\n2,1,2\n4,2,1\n8,0,1\n",
                    plain = "size_mm,mass\n1,1.5\n2,0.5\n4,2\n8,0\n";
  const Outcome outcome = mdm(curve, dense);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const Json set = Json::parse(outcome.out), same = Json::parse(mdm(curve, plain).out);
  CHECK(set.at("classes")[0].at("volume_fraction") == Json({"0.375", "0.375"}));
  for (const char *of : {"classes", "particles", "Cu", "Cc", "quality"})
    CHECK(set.at(of) == same.at(of));
  CHECK(set.at("notes")[0].get<std::string>().find("divided by their factors") != std::string::npos);
  CHECK(same.at("notes").empty());
  // solve knows the factors.
  const Outcome solved =
      mdm({"solve", "-", "--min-per-class", "10", "--at-least", "100", "--format", "json"}, dense);
  REQUIRE(solved.exit_code == 0);
  CHECK(Json::parse(solved.out).at("particles") == set.at("particles"));
}

TEST_CASE("a number of classes for a measured curve makes them geometric", "[generate]") {
  const std::string sieves = "size_mm,passing_percent\n1,0\n2,50\n8,100\n16,100\n";
  const Arguments curve = {"generate", "--curve", "-", "--classes", "2", "--format", "json"};
  const Outcome outcome = mdm(curve, sieves);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const Json classes = Json::parse(outcome.out).at("classes");
  REQUIRE(classes.size() == 2);
  CHECK(classes[0].at("upper") == Json({"4", "4"}));
  CHECK(mdm(with(curve, {"--classing", "geometric"}), sieves).out == outcome.out);
  check_refused(mdm(with(curve, {"--classing", "sieves"}), sieves), "--classes");
}

TEST_CASE("counts that enclosures do not decide are exit 3, with both values", "[generate]") {
  const Arguments tie = {"generate", "--curve",     "-", "--classing", "isochoric", "--classes",
                         "2",        "--dimension", "2", "--at-least", "1"};
  const std::string line = "size_mm,passing_percent\n1,0\n2,100\n";
  const Outcome text = mdm(tie, line);
  CHECK(text.exit_code == 3);
  CHECK(text.out.find("19 or 20") != std::string::npos);
  const Outcome sizes = mdm(with(tie, {"--format", "json", "--sizes"}), line);
  CHECK(sizes.exit_code == 3);
  const Json set = Json::parse(sizes.out);
  CHECK(set.at("classes")[0].at("estimate") == Json({"19", "20"}));
  CHECK(set.at("particles").is_null());
  CHECK(set.at("sizes").empty());
}

TEST_CASE("sizes are streamed: many of them take no memory, and both formats have the same", "[generate]") {
  const Arguments many = {"generate", "--beta", "3,3", "--dmin",  "0.02",      "--dmax",
                          "1.98",     "--seed", "5",   "--sizes", "--at-least"};
  TemporaryFolder folder;
  const std::string few_csv = folder / "few.csv", all_csv = folder / "all.csv";
  const Outcome few = mdm(with(many, {"1", "--format", "csv", "-o", few_csv}));
  CHECK(few.exit_code == 0);
  const Outcome all = mdm(with(many, {"400000", "--format", "csv", "-o", all_csv}));
  CHECK(all.exit_code == 0);
  const std::string text = read_file(all_csv);
  CHECK(std::count(text.begin(), text.end(), '\n') > 399000);
  if (!MDM_IS_SANITIZED)
    CHECK(all.max_rss_kib < few.max_rss_kib + 2000);

  const Json set = json(with(many, {"1"}));
  const std::string rows = read_file(few_csv);
  std::string expected = "class,size_lo,size_hi\n";
  std::size_t i = 0;
  for (std::size_t j = 0; j < set.at("classes").size(); ++j)
    for (int n = std::stoi(set.at("classes")[j].at("quantity").get<std::string>()); n > 0; --n, ++i)
      expected += std::to_string(j + 1) + "," + set.at("sizes")[i][0].get<std::string>() + "," +
                  set.at("sizes")[i][1].get<std::string>() + "\n";
  CHECK(rows == expected);
  CHECK(set.at("sizes").size() == i);
}

TEST_CASE("the quality of the set is told, as drawn and as matched", "[generate]") {
  const Json set = json(with(two, {"--method", "match"}));
  const Json &quality = set.at("quality");
  CHECK(quality.at("points") == "100");
  // Classes hold half of the volume each: of the match exactly, of 204 and 100 drawn discs nearly.
  CHECK(quality.at("match").at("worst_error") == Json({"0", "0"}));
  CHECK(rational(quality.at("drawn").at("worst_error")[1]) < Rational(1, 100));
  CHECK(rational(quality.at("drawn").at("Cr")[0]) > 0);
  CHECK(rational(quality.at("drawn").at("classes")[1].at("largest")[1]) < Rational(2, 100));
  CHECK(set.at("classes")[0].at("number_fraction").size() == 2);
  CHECK_FALSE(json(with(two, {"--points", "0"})).contains("quality"));
  CHECK(mdm(two).out.find("Eq. 6-10, quantiles") != std::string::npos);
}

TEST_CASE("f, F, V and h of the set stand in one table", "[generate]") {
  // One class of discs on [1, 2]: F = 2 (d - 1) / d, f = 2 / d^2.
  const Json line = json({"generate", "--beta", "1,1", "--dmin", "1", "--ratio", "2", "--classes", "1",
                          "--dimension", "2", "--table", "3"})
                        .at("curve")[1];
  CHECK(line.at("size") == Json({"1.5", "1.5"}));
  CHECK(line.at("volume_density") == Json({"1", "1"}));
  CHECK(line.at("partition") == Json({"0.666666666666666", "0.666666666666667"}));
  CHECK(line.at("number_density") == Json({"0.888888888888888", "0.888888888888889"}));
}

TEST_CASE("h of the table is the integral of its V, and the curve's h stands beside it", "[generate]") {
  // One class from 1 to 2 with h(d) = (d - 1)^2 as the curve, a straight line as the set's.
  const Json table = json({"generate", "--beta", "2,1", "--dmin", "1", "--ratio", "2", "--classes", "1",
                           "--at-least", "5", "--table", "5", "--points", "0"})
                         .at("curve");
  REQUIRE(table.size() == 5);
  CHECK(table[1].at("passing") == Json({"0.25", "0.25"}));
  CHECK(table[1].at("curve_passing") == Json({"0.0625", "0.0625"}));
  // Irrational bounds: enclosures of the same.
  const Json more = json({"generate", "--beta", "1,3", "--dmin", "0.1", "--ratio", "20", "--classes", "3",
                          "--min-per-class", "1", "--at-least", "5", "--table", "5", "--points", "0"})
                        .at("curve");
  CHECK(more[1].at("passing")[0].get<std::string>().substr(0, 7) == "0.54649");
  CHECK(more[1].at("curve_passing") == Json({"0.578125", "0.578125"}));
  CHECK(more[0].at("passing") == Json({"0", "0"}));
  CHECK(more[4].at("passing") == Json({"1", "1"}));
}

TEST_CASE("accessible shapes are those whose sets are, both ways", "[generate]") {
  const Arguments terms = {"--classes", "4", "--min-per-class", "5", "--at-least", "100", "--at-most", "300"};
  const Arguments grid = with(
      {"generate", "--accessible", "--span", "0.5,0.9", "--a", "1:3:1", "--b", "0.5,3", "-j", "2"}, terms);
  const Json answer = json(grid);
  CHECK(answer.at("schema") == "mdm-accessible-1");
  const Json &shapes = answer.at("shapes");
  REQUIRE(shapes.size() == 12);
  unsigned accessible = 0;
  for (const Json &shape : shapes)
    for (const std::string method : {"paper", "match"}) {
      const bool expected = shape.at(method).at("accessible").get<bool>();
      accessible += expected ? 1 : 0;
      const std::string a_and_b = shape.at("a").get<std::string>() + "," + shape.at("b").get<std::string>();
      const Json set = json(with({"generate", "--beta", a_and_b, "--dmin", "1", "--span",
                                  shape.at("span").get<std::string>(), "--method", method},
                                 terms),
                            expected ? 0 : 1);
      CHECK(set.at("Cu")[0].get<std::string>().substr(0, 6) ==
            shape.at("Cu")[0].get<std::string>().substr(0, 6));
      if (method == "match")
        CHECK(set.at("particles") == shape.at("match").at("particles"));
    }
  CHECK(accessible > 0);
  CHECK(accessible < 24);
  const Outcome one = mdm(with(grid, {"--format", "csv"}));
  Arguments alone = grid;
  *(std::find(alone.begin(), alone.end(), "-j") + 1) = "1";
  CHECK(mdm(with(alone, {"--format", "csv"})).out == one.out);
  CHECK(std::count(one.out.begin(), one.out.end(), '\n') == 13);
  CHECK(mdm(grid).out.find("3 |") != std::string::npos);
}

TEST_CASE("shapes that are not decided are counted, with the reason", "[generate]") {
  // The exponents of the finest class's share are beyond what is matched.
  const Arguments grid = {"generate",     "--accessible", "--span", "0.97",      "--a",
                          "300:1000:350", "--b",          "1",      "--classes", "10"};
  const Outcome text = mdm(grid), csv = mdm(with(grid, {"--format", "csv", "--quiet"}));
  CHECK(text.exit_code == 3);
  CHECK(text.out.find("shapes are not decided (?), the first s = 0.97, a = ") != std::string::npos);
  CHECK(csv.exit_code == 3);
  CHECK(csv.err.find("shapes are not decided (?), the first s = 0.97, a = ") != std::string::npos);
}

TEST_CASE("the map of accessible shapes is drawn", "[generate]") {
  TemporaryFolder folder;
  const Outcome outcome = mdm({"generate", "--accessible", "--span", "0.3,0.5", "--a", "1,2", "--b", "1,2",
                               "--plot", folder / "map.svg"});
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(read_file(folder / "map.svg").find("smallest match") != std::string::npos);
}

TEST_CASE("extreme shapes and counts end soon, with an answer or a refusal", "[generate]") {
  for (const char *shape : {"0.001,1000", "1000,0.001", "1000,1", "0.001,0.001"}) {
    const Outcome outcome =
        mdm({"generate", "--beta", shape, "--dmin", "1", "--span", "0.5", "--classes", "4"});
    INFO(shape << outcome.err);
    CHECK(outcome.signal == 0);
    CHECK((outcome.exit_code == 0 || outcome.exit_code == 2 || outcome.exit_code == 3));
  }
  const Json narrow = json({"generate", "--beta", "1,1", "--dmin", "1", "--dmax",
                            "1." + std::string(33, '0') + "1", "--dimension", "2"});
  CHECK(narrow.at("particles") == "2000");
  const Json c_r = narrow.at("quality").at("drawn").at("Cr");
  CHECK(rational(c_r[0]) <= rational(c_r[1]));
  CHECK(rational(c_r[1]) < Rational(1, 1000));
  CHECK(c_r[1].get<std::string>().size() < 40);
  const Outcome text = mdm({"generate", "--beta", "1,1", "--dmin", "1", "--dmax",
                            "1." + std::string(33, '0') + "1", "--dimension", "2"});
  CHECK(text.out.find("<= 0.0003") != std::string::npos); // what is certain of C_r, and not 0
  const std::string huge(300, '9');
  const Arguments many = {"generate", "--beta", "1,1", "--dmin", "1", "--ratio", "2", "--at-least", huge};
  CHECK(json(many).at("particles").get<std::string>().size() == 300);
  check_refused(mdm(with(many, {"--sizes", "--format", "csv"})), "10^12");
  CHECK(json({"generate", "--beta", "1,1", "--dmin", "1", "--ratio", "100", "--classes", "1000",
              "--dimension", "2", "--points", "0"})
            .at("particles") == "213975");
}

TEST_CASE("a match of decimals that are too long or small is refused with a remedy", "[generate]") {
  const Arguments beta = {"generate", "--dmin", "1", "--method", "match", "--points", "0", "--classes", "10"};
  check_refused(mdm(with(beta, {"--beta", "1,1000", "--span", "0.97"})), "fewer or isochoric classes");
  check_refused(mdm(with(beta, {"--beta", "1,3", "--ratio", "20", "--match-digits", "1000"})),
                "fewer --match-digits");
}

TEST_CASE("what no grid of shapes can be made of is refused", "[generate]") {
  for (const Arguments &more : std::vector<Arguments>{{},
                                                      {"--span", "1"},
                                                      {"--span", "0.5", "--ratio", "2"},
                                                      {"--span", "0.5", "--dmin", "1"},
                                                      {"--span", "0.5", "--beta", "1,1"},
                                                      {"--span", "0.5", "--a", "1:2"},
                                                      {"--span", "0.5", "--a", "2:1:1"},
                                                      {"--span", "0.5", "--a", "0:1:1"},
                                                      {"--span", "0.5", "--a", "1:2:0.0001"},
                                                      {"--span", "0.5", "--a", "1,,2"},
                                                      {"--span", "0.5", "--a", "1,2000"},
                                                      {"--span", "0.5", "--b", "0.0001:1:0.5"},
                                                      {"--span", "0.5", "--b", ""},
                                                      {"--span", "0.5", "--classing", "sieves"},
                                                      {"--span", "0.5", "--method", "match"},
                                                      {"--span", "0.5", "--sizes", "--format", "csv"},
                                                      {"--span", "0.5", "--method", "match", "--spread"},
                                                      {"--span", "0.5", "--at-most", "10"},
                                                      {"--span", "0.5", "--digits", "3"},
                                                      {"--span", "0.5", "--plot", "-"},
                                                      {"--span", "0.5", "--plot", "map.gif"}})
    check_refused(mdm(with({"generate", "--accessible"}, more)));
  check_refused(mdm(with(two, {"--a", "1"})), "--accessible");
  check_refused(mdm(with(two, {"-j", "2"})), "--accessible");
}

TEST_CASE("what no set can be made of is refused", "[generate]") {
  const Arguments beta = {"generate", "--beta", "1,3", "--dmin", "1"};
  for (const Arguments &more : std::vector<Arguments>{{"--span", "0"},
                                                      {"--span", "1"},
                                                      {"--ratio", "1"},
                                                      {"--dmax", "1"},
                                                      {"--dmax", "0.5"},
                                                      {},
                                                      {"--ratio", "2", "--span", "0.5"},
                                                      {"--ratio", "2", "--classes", "0"},
                                                      {"--ratio", "2", "--at-least", "20", "--at-most", "10"},
                                                      {"--ratio", "2", "--classing", "sieves"},
                                                      {"--ratio", "2", "--sizes"},
                                                      {"--ratio", "2", "--seed", "1", "--quantiles"},
                                                      {"--ratio", "2", "--seed", "18446744073709551616"},
                                                      {"--ratio", "2", "--points", "1"},
                                                      {"--ratio", "2", "--match-digits", "7"},
                                                      {"--ratio", "2", "--time-limit", "7"},
                                                      {"--ratio", "2", "--seed", "1", "--format", "csv"},
                                                      {"--ratio", "2", "--quantiles", "--format", "csv"},
                                                      {"--ratio", "2", "--points", "9", "--format", "csv"},
                                                      {"--ratio", "2", "--table", "1"}})
    check_refused(mdm(with(beta, more)));
  for (const char *parameters : {"0,1", "1,0", "1", "1,2,3", "1000000,1", "x,1"})
    check_refused(mdm({"generate", "--beta", parameters, "--dmin", "1", "--ratio", "2"}));
  check_refused(mdm({"generate"}));
  check_refused(mdm(with(beta, {"--span", "0"})), "write a number above 0");
  const Outcome tiny = mdm({"generate", "--beta", "1e-400,1", "--dmin", "1", "--ratio", "2"});
  check_refused(tiny, "from 0.001 to 1000");
  CHECK(tiny.err.size() < 250);
}

TEST_CASE("numbers of generate are worded as they are, and time limits are decimals", "[generate]") {
  const Arguments one = {"generate", "--beta", "1,1", "--dmin", "1", "--ratio", "2", "--classes", "1"};
  CHECK(mdm(one).out.find("  1 geometric class, at least") != std::string::npos);
  CHECK(mdm({"generate", "--accessible", "--span", "0.5", "--a", "1", "--b", "1", "--classes", "1"})
            .out.find("  1 geometric class, at least") != std::string::npos);
  check_refused(mdm({"generate", "--beta", "1,1", "--dmin", "1", "--ratio", "2", "--classes", "10001"}),
                "is above 10000");
  CHECK(mdm(with(one, {"--method", "match", "--time-limit", "7.5"})).exit_code == 0);
  check_refused(mdm(with(one, {"--method", "match", "--time-limit", "-1"})), "--time-limit");
}

TEST_CASE("the help names what its options take", "[generate]") {
  const Outcome help = mdm({"generate", "--help"});
  CHECK(help.exit_code == 0);
  CHECK(help.out.find(" :{") == std::string::npos);
  CHECK(help.out.find("--method TEXT:{paper,match}") != std::string::npos);
}

TEST_CASE("the sizes of a set whose unit is known have it in their header", "[cli]") {
  const TemporaryFolder folder;
  const std::string um = folder.write("um.csv", "size_um,mass\n100,1\n200,3\n400,0\n"),
                    sizes = folder / "sizes.csv";
  REQUIRE(mdm({"generate", "--curve", um, "--sizes", "--at-least", "10", "--min-per-class", "1", "-o", sizes})
              .exit_code == 0);
  CHECK(read_file(sizes).starts_with("class,size_lo_mm,size_hi_mm\n"));
  CHECK(mdm({"verify", um, sizes, "--tolerance", "30"}).exit_code == 0);
  const std::string discs = folder / "discs.csv";
  REQUIRE(mdm({"generate", "--curve", um, "--dimension", "2", "--sizes", "--at-least", "300", "-o", discs})
              .exit_code == 0);
  CHECK(mdm({"pack", discs, "-o", folder / "p", "--quiet"}).exit_code == 0);
}

} // namespace generate_test
