// Gradations by number, from the file to the verdict.

#include "answer.hpp"
#include "proved.hpp"

namespace number_gradation_test {

using namespace cli_test;

namespace {

const std::string shares = "size_mm,number_percent\n1,50\n2,33.3\n4,0\n8,16.7\n16,0\n";
const std::string cumulative = "size_mm,cumulative_number_percent\n16,100\n8,83.3\n4,83.3\n2,50\n1,0\n";

struct Proved : ProvedGradation {
  explicit Proved(const Arguments &options, int exit_code = 0, const std::string &content = shares)
      : ProvedGradation("sand", content, options, exit_code) {}
};

} // namespace

TEST_CASE("exact shares by number take the least common denominator", "[cli]") {
  for (const std::string &content : {shares, cumulative}) {
    const Proved proved({}, 0, content);
    CHECK(contains(proved.text, "1000 particles have the shares by number exactly"));
    CHECK(read_file(proved.proof) ==
          "mdm-certificate number 1\nparticles 1000\nquantities 500 333 0 167\nend\n");
    CHECK(contains(proved.verdict().out,
                   "accepted: 1000 is the least number of particles that have the shares"));
  }
}

TEST_CASE("shares by number within a tolerance have a proof", "[cli]") {
  for (const char *tolerance : {"retained:1%", "passing:1%", "total:1%"}) {
    const Proved proved({"--tolerance", tolerance});
    CHECK(contains(proved.text, "6 particles have"));
    CHECK(contains(read_file(proved.proof), "particles 6\nquantities 3 2 0 1\n"));
    CHECK(proved.verdict().exit_code == 0);
  }
  const Proved both({"--tolerance", "retained:10%", "--tolerance", "passing:5%"});
  CHECK(contains(both.verdict().out, "(retained within 10% of the number; passing within 5% of the number)"));
  const Proved turned(
      {"--tolerance", "passing:5%", "--tolerance", "retained:10%", "--tolerance", "retained:20%"});
  CHECK(read_file(turned.proof) == read_file(both.proof));
  CHECK(turned.verdict().exit_code == 0);
}

TEST_CASE("a search by number that reaches its limit has a proof of the bound", "[cli]") {
  const Proved proved({"--tolerance", "retained:0.0000000001%"}, 3,
                      "size_mm,number_percent\n1,33.333333333\n2,66.666666667\n4,0\n");
  CHECK(contains(proved.text, "the limit of steps was reached"));
  CHECK(contains(proved.verdict().out, "accepted: no set of fewer than 8388609 particles has"));
  CHECK(proved.forged("bound 8388609", "bound 8388610") == 1);
}

TEST_CASE("forged certificates by number are refused", "[cli]") {
  const Proved exact({});
  CHECK(exact.forged("particles 1000", "particles 999") == 1);
  CHECK(exact.forged("500 333 0 167", "500 332 1 167") == 1);
  CHECK(exact.forged("500 333 0 167", "500 333 167") == 1);
  CHECK(exact.forged("particles 1000\nquantities 500 333 0 167",
                     "particles 2000\nquantities 1000 666 0 334") == 1);
  CHECK(exact.forged("particles 1000\nquantities 500 333 0 167", "bound 1001") == 1);
  CHECK(exact.forged("particles 1000\nquantities 500 333 0 167", "bound 1000") == 0);
  const Proved tolerant({"--tolerance", "retained:1%"});
  CHECK(tolerant.forged("particles 6\nquantities 3 2 0 1", "particles 12\nquantities 6 4 0 2") == 1);
  CHECK(tolerant.forged("retained 1\n", "retained 0.01\n") == 1);
  CHECK(tolerant.forged("retained 1\n", "passing 20\n") == 1);
  CHECK(tolerant.forged("retained 1\n", "") == 1);
  CHECK(tolerant.forged("particles 6\nquantities 3 2 0 1", "bound 7") == 1);
  CHECK(tolerant.forged("retained 1\n", "retained 1\ntotal 1\n") == 2);
  CHECK(tolerant.forged("retained 1\n", "retained 101\n") == 2);
  CHECK(tolerant.forged("quantities 3 2 0 1", "quantities 3 2 -0 1") == 2);
  CHECK(tolerant.forged("particles 6\n", "particles 0\n") == 2);
  CHECK(tolerant.forged("end\n", "end\nend\n") == 2);
  CHECK(tolerant.forged("end\n", "") == 2);
}

TEST_CASE("answers by number have all formats", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("sand.csv", shares);
  CHECK(
      mdm({"solve", file, "--format", "csv"}).out ==
      "lower_mm,upper_mm,number_share,quantity\n1,2,1/2,500\n2,4,333/1000,333\n4,8,0,0\n8,16,167/1000,167\n");
  const std::string json = mdm({"solve", file, "--format", "json", "--tolerance", "total:1%"}).out;
  CHECK(contains(json,
                 "{\"schema\":\"mdm-number-1\",\"id\":\"sand\",\"status\":\"optimal\",\"particles\":\"6\""));
  CHECK(contains(json, "\"tolerances\":[\"total:1%\"]"));
}

TEST_CASE("a gradation by number is nowhere taken as one by mass", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("sand.csv", shares);
  const std::string mass = folder.write("mass.csv", "size_mm,mass\n1,1\n2,1\n4,0\n");
  for (const Arguments &arguments : std::vector<Arguments>{{"report", file, "-o", folder / "r.html"},
                                                           {"convert", file},
                                                           {"tradeoff", file},
                                                           {"verify", file, mass},
                                                           {"published", "rounded", file},
                                                           {"judge", file, "--spec", "astm-c33-fine"}})
    check_refused(mdm(arguments), "share of the number of particles");
  CHECK(mdm({"solve", mass, "--proof", folder / "mass.proof"}).exit_code == 0);
  CHECK(mdm({"solve", file, "--proof", folder / "number.proof"}).exit_code == 0);
  CHECK(mdm_check(file, folder / "mass.proof").exit_code == 2);
  CHECK(mdm_check(mass, folder / "number.proof").exit_code == 2);
}

TEST_CASE("what says nothing of shares by number is refused", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("sand.csv", shares);
  for (const Arguments &options : std::vector<Arguments>{{"--law", "sphere"},
                                                         {"--at-least", "5"},
                                                         {"--particles", "10"},
                                                         {"--spectrum"},
                                                         {"--spread"},
                                                         {"--vipr", folder / "vipr"},
                                                         {"--unit", "mm"},
                                                         {"--time-limit", "5"}}) {
    Arguments arguments{"solve", file};
    arguments.insert(arguments.end(), options.begin(), options.end());
    check_refused(mdm(arguments), options.front() + ": it is of gradations by mass");
  }
  check_refused(mdm({"solve", file, "--tolerance", "rounding"}), "is not of shares by number");
  const std::string factor = folder.write("factor.csv", "size_mm,number_percent,factor\n1,5,1\n2,0,1\n");
  check_refused(mdm({"solve", factor}), "has no use beside number_percent");
}

TEST_CASE("describe tells the shares of the mass of a gradation by number, and back") {
  const TemporaryFolder folder;
  const std::string numbers = folder.write("n.csv", "size_mm,number_percent\n1,50\n2,50\n4,0\n"),
                    masses = folder.write("m.csv", "size_mm,mass\n1,1\n2,8\n4,0\n");
  // Sizes from 1 to 2 and from 2 to 4 mm: the first class weighs from 1 against 64 to 8 against 8.
  const Outcome text = mdm({"describe", numbers, "--format", "csv", "--digits", "3"});
  CHECK(text.out ==
        "lower_mm,upper_mm,number_percent,mass_percent_lo,mass_percent_hi\n1,2,50,1.53,50\n2,4,50,50,98.5\n");
  const Outcome back = mdm({"describe", masses, "--by-number", "--format", "csv", "--digits", "3"});
  CHECK(back.out == "lower_mm,upper_mm,mass_percent,number_percent_lo,number_percent_hi\n"
                    "1,2,11.1,11.1,88.9\n2,4,88.8,11.1,88.9\n");
  CHECK(contains(mdm({"describe", numbers}).out, "shares of the mass from those of the number"));
  CHECK(
      contains(mdm({"describe", masses, "--by-number"}).out, "shares of the number from those of the mass"));
}

TEST_CASE("describe refuses what says nothing of shares by number") {
  const TemporaryFolder folder;
  const std::string numbers = folder.write("n.csv", shares),
                    masses = folder.write("m.csv", "size_mm,mass\n1,1\n2,0\n");
  for (const Arguments &arguments : {Arguments{"describe", numbers, masses},
                                     {"describe", masses, numbers},
                                     {"describe", numbers, "--sediment"},
                                     {"describe", numbers, "--by-number"},
                                     {"describe", numbers, "--pan-size", "0.5mm"},
                                     {"describe", numbers, "--d", "10"},
                                     {"describe", numbers, "--unit", "mm"},
                                     {"describe", masses, masses, "--by-number"},
                                     {"describe", masses, "--by-number", "--extrapolate"}}) {
    const Outcome outcome = mdm(arguments);
    CAPTURE(arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK_FALSE(outcome.err.empty());
  }
}

} // namespace number_gradation_test
