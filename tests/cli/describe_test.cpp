// mdm describe: index numbers, fractions and groups as a user sees them.

#include "answer.hpp"

namespace describe_test {

using namespace cli_test;

namespace {

Json describe_json(Arguments arguments, const std::string &input = "") {
  arguments.insert(arguments.begin(), "describe");
  arguments.insert(arguments.end(), {"--format", "json"});
  const Outcome outcome = mdm(arguments, input);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  REQUIRE(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 1);
  return Json::parse(outcome.out);
}

/// D10 = 0.1, D30 = 0.3, D60 = 0.6 mm.
const std::string sand = "size_mm,passing_percent\n4.75,100\n0.6,60\n0.3,30\n0.1,10\n0.075,4\n0.01,0\n";
const std::string coarse_pan = "size_mm,passing_percent\n4.75,100\n0.6,60\n0.3,30\n0.15,14\n";

bool has(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("the text form has the group, the index numbers and the fractions", "[describe]") {
  const Outcome outcome = mdm({"describe", "-"}, sand);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  INFO(outcome.out);
  CHECK(outcome.out.rfind("stdin: SW, well-graded sand\n", 0) == 0);
  for (const char *part : {"  D10     0.1 mm\n", "  D30     0.3 mm\n", "  D50     0.4762 mm\n",
                           "  C_u     6\n", "  C_c     1.5\n", "percent of the mass, ASTM D2487",
                           "percent of the mass, ISO 14688", "to 0.075 mm            4\n"})
    CHECK(has(outcome.out, part));
  CHECK_FALSE(has(outcome.out, " \n"));
  CHECK_FALSE(has(outcome.out, "boulders"));
}

TEST_CASE("the JSON form encloses, and exact values have equal ends", "[describe]") {
  const Json d = describe_json({"-"}, sand);
  CHECK(d.at("schema") == "mdm-describe-1");
  CHECK(d.at("id") == "stdin");
  CHECK(d.at("D10") == Json({"0.1", "0.1"}));
  CHECK(d.at("Cu") == Json({"6", "6"}));
  CHECK(d.at("Cc") == Json({"1.5", "1.5"}));
  for (const char *key : {"D50", "IGS", "IC"}) {
    const Rational lo = rational(d.at(key)[0]), hi = rational(d.at(key)[1]);
    CHECK(lo < hi);
    CHECK(hi - lo <= hi / 10000000);
    CHECK(d.at(key)[0].get<std::string>().size() <= 17);
  }
  CHECK(d.at("uscs") == Json({{"symbol", "SW"}, {"name", "well-graded sand"}, {"fines", "ML"}}));
  CHECK(d.at("passing")[1] == Json({{"size", "0.075"}, {"percent", {"4", "4"}}}));
  CHECK(d.at("versions").contains("arb"));
  const Json &fractions = d.at("uscs_fractions");
  CHECK(fractions.back() ==
        Json({{"name", "fines"}, {"above", "0"}, {"up_to", "0.075"}, {"percent", {"4", "4"}}}));
  CHECK(fractions.front().at("up_to").is_null());
}

TEST_CASE("the CSV form has a row for each", "[describe]") {
  const Outcome outcome = mdm({"describe", "-", "--format", "csv", "--digits", "3"}, sand);
  CHECK(outcome.exit_code == 0);
  for (const char *row : {"item,unit,lo,hi,text\n", "\nD10,mm,0.1,0.1,\n", "\nD50,mm,0.476,0.477,\n",
                          "\nCu,,6,6,\n", "\nUSCS symbol,,,,SW\n", "\nUSCS name,,,,\"well-graded sand\"\n",
                          "\nUSCS fines,percent,4,4,\n", "\nISO 14688 clay,percent,0,0,\n"})
    CHECK(has(outcome.out, row));
  CHECK(has(outcome.out, "\nnote,,,,\"ISO 14688: interpolated"));
  CHECK(outcome.err.empty());
}

TEST_CASE("what a pan at size 0 hides is null, with a note", "[describe]") {
  const Json d = describe_json({"-"}, coarse_pan);
  for (const char *key : {"D10", "Cu", "Cc", "IGS", "uscs"})
    CHECK(d.at(key).is_null());
  CHECK(d.at("D30") == Json({"0.3", "0.3"}));
  const std::string notes = d.at("notes").dump();
  for (const char *part : {"D10: below 0.15 mm, the finest sieve", "--extrapolate",
                           "no USCS group: ", "I_GS is not available", "14 % of the mass lies below 0.15 mm"})
    CHECK(has(notes, part));
  const Outcome text = mdm({"describe", "-"}, coarse_pan);
  CHECK(text.exit_code == 0);
  CHECK(has(text.out, "stdin: no USCS group\n"));
  CHECK(has(text.out, "  D10     not available\n"));
}

TEST_CASE("the pan can be extrapolated or given a size", "[describe]") {
  const Json line = describe_json({"-", "--extrapolate"}, coarse_pan);
  // 0.15 * 2^(-4/16)
  CHECK(line.at("D10")[0].get<std::string>().rfind("0.126134462", 0) == 0);
  CHECK(has(line.at("notes").dump(), "D10: extrapolated"));
  const Json sized = describe_json({"-", "--pan-size", "0.0375"}, coarse_pan);
  // 0.0375 * 4^(10/14)
  CHECK(sized.at("D10")[0].get<std::string>().rfind("0.10094", 0) == 0);
  CHECK_FALSE(sized.at("IGS").is_null());
}

TEST_CASE("an extrapolation that has nothing to extrapolate is refused", "[describe]") {
  check_refused(mdm({"describe", "-", "--extrapolate", "--pan-size", "0.01"}, coarse_pan), "--pan-size");
  check_refused(mdm({"describe", example("athabasca-sand"), "--extrapolate"}),
                "--extrapolate: there is no pan");
}

TEST_CASE("of diameters in the pan those are extrapolated that can be", "[describe]") {
  const std::string notes = describe_json({"-", "--extrapolate", "--d", "0.001"},
                                          "size_mm,passing_percent\n2,100\n1,14\n0.99,13.9\n")
                                .at("notes")
                                .dump();
  CHECK(has(notes, "D10: extrapolated along the line"));
  CHECK(has(notes, "D0.001: below 0.99 mm, the finest sieve, and the curve cannot be extrapolated"));
}

TEST_CASE("limits classify the fines", "[describe]") {
  const std::string silty = "size_mm,passing_percent\n4.75,100\n0.075,20\n0.01,0\n";
  CHECK(describe_json({"-"}, silty).at("uscs").at("symbol") == "SM");
  CHECK(has(describe_json({"-"}, silty).at("notes").dump(), "low-plasticity silt"));
  const Json clayey = describe_json({"-", "--liquid-limit", "40", "--plastic-limit", "20.5"}, silty);
  CHECK(clayey.at("uscs") == Json({{"symbol", "SC"}, {"name", "clayey sand"}, {"fines", "CL"}}));
  CHECK_FALSE(has(clayey.at("notes").dump(), "low-plasticity silt"));
}

TEST_CASE("a group that no precision decides is a limit", "[describe]") {
  const Outcome outcome =
      mdm({"describe", "-"}, "size_mm,passing_percent\n20,100\n7.6,60\n3.8,50\n0.12,20\n0.06,0\n");
  CHECK(outcome.exit_code == 3);
  CHECK(has(outcome.out, "no USCS group: gravel against sand: not decided"));
  CHECK(has(mdm({"describe", "--help"}).out, "Exit code 3"));
}

TEST_CASE("the real sands are described", "[describe]") {
  for (const auto &[file, symbol] : {std::pair("athabasca-sand", "SP"), std::pair("hostun-rf-sand", "SP"),
                                     std::pair("c778-graded-sand", "SP"), std::pair("ottawa-f65-sand", "SP"),
                                     std::pair("cen-standard-sand", "SW")})
    CHECK(describe_json({example(file)}).at("uscs").at("symbol") == symbol);
}

TEST_CASE("any diameters are described", "[describe]") {
  const Json d = describe_json({"-", "--d", "100,30,2.5,20,10"}, sand);
  REQUIRE(d.at("diameters").size() == 3); // D10 and D30 are there already
  CHECK(d.at("diameters")[0].at("percent") == "2.5");
  CHECK(d.at("diameters")[2] == Json({{"percent", "100"}, {"size", {"4.75", "4.75"}}}));
  // 0.1 * 3^(1/2)
  CHECK(d.at("diameters")[1].at("size")[0].get<std::string>().rfind("0.17320508", 0) == 0);
  CHECK(has(mdm({"describe", "-", "--d", "20"}, sand).out, "  D20     0.1732 mm\n"));
  CHECK(has(mdm({"describe", "-", "--d", "20", "--format", "csv", "--digits", "3"}, sand).out,
            "\nD60,mm,0.6,0.6,\nD20,mm,0.173,0.174,\n"));
  CHECK(describe_json({"-", "--d", "5"}, coarse_pan).at("diameters")[0].at("size").is_null());
  check_refused(mdm({"describe", "-", "--d", "5,101"}, sand), "--d: 5,101 has more than 100 percent");
  check_refused(mdm({"describe", "-", "--d", "0,5"}, sand), "--d");
}

TEST_CASE("mean sizes, fineness and conductivity are described", "[describe]") {
  const Json d = describe_json({"-", "--void-ratio", "0.6"}, "size_mm,passing_percent\n0.2,0\n0.4,100\n");
  CHECK(d.at("D43") == Json({"0.2", "0.4"}));
  CHECK(d.at("D32") == Json({"0.2", "0.4"}));
  CHECK(d.at("kKozenyCarman")[0] == "0.0002979");
  CHECK(d.at("kKozenyCarman")[1] == "0.0011916");
  CHECK_FALSE(describe_json({"-"}, sand).contains("kKozenyCarman"));
  check_refused(mdm({"describe", "-", "--void-ratio", "0"}, sand), "--void-ratio");
}

TEST_CASE("the ends of a range are rounded outwards", "[describe]") {
  const Outcome outcome =
      mdm({"describe", "-", "--digits", "3"}, "size_mm,mass\n0.12345,1\n2.34567,2\n30,0\n");
  // D[4,3] from (0.12345 + 2 * 2.34567) / 3 = 1.60493 to (2.34567 + 60) / 3 = 20.78189.
  CHECK(has(outcome.out, "  D[4,3]  1.6 to 20.8 mm\n"));
}

TEST_CASE("the AASHTO group has its index", "[describe]") {
  const std::string silty = "size_mm,passing_percent\n4.75,100\n2,100\n0.425,90\n0.075,60\n0.01,0\n";
  CHECK(describe_json({"-", "--liquid-limit", "35", "--plastic-limit", "23"}, silty).at("aashto") ==
        Json({{"symbol", "A-6"}, {"name", "clayey soil"}, {"index", "5"}}));
  CHECK(has(mdm({"describe", "-", "--liquid-limit", "35", "--plastic-limit", "23"}, silty).out,
            "  AASHTO  A-6 (5), clayey soil\n"));
  const Json without = describe_json({"-"}, silty);
  CHECK(without.at("aashto").at("index").is_null());
  CHECK(has(without.at("notes").dump(), "the group index of AASHTO M 145 needs the limits"));
}

TEST_CASE("the name of ISO 14688-2 stands in every form, or why there is none", "[describe]") {
  const std::string gravel = "size_mm,passing_percent\n63,100\n2,40\n0.063,10\n0.001,0\n";
  CHECK(has(mdm({"describe", "-"}, gravel).out, "  ISO     saGr, sandy gravel (14688-2:2004)\n"));
  CHECK(describe_json({"-"}, gravel).at("iso_14688") == Json({{"symbol", "saGr"}, {"name", "sandy gravel"}}));
  CHECK(has(mdm({"describe", "-", "--format", "csv"}, gravel).out, "ISO 14688-2 symbol,,,,saGr\n"));
  const Json without = describe_json({"-"}, "size_mm,passing_percent\n63,100\n2,40\n0.063,20\n0,0\n");
  CHECK(without.at("iso_14688").is_null());
  CHECK(has(without.at("notes").dump(), "no name of ISO 14688-2: below 0.063 mm, the finest sieve"));
}

TEST_CASE("of several samples there is a table with a line each", "[describe]") {
  const TemporaryFolder folder;
  folder.write("a.csv", sand);
  folder.write("b.csv", coarse_pan);
  const Outcome text = mdm({"describe", folder / "a.csv", folder / "b.csv", "--d", "90"});
  INFO(text.out);
  CHECK(text.exit_code == 0);
  CHECK(has(text.out, "sample  USCS  AASHTO     ISO 14688-2"));
  CHECK(has(text.out, "\n  a       SW    A-1-b (0)  Sa           0.1  0.3"));
  CHECK(has(text.out, "note: a, b: the fines are taken as low-plasticity silt") !=
        has(text.out, "note: b: no USCS group"));
  const Outcome csv =
      mdm({"describe", folder / "a.csv", folder / "b.csv", "--format", "csv", "--digits", "3"});
  CHECK(std::count(csv.out.begin(), csv.out.end(), '\n') == 3);
  CHECK(has(csv.out, "id,uscs,aashto,aashto_index,iso_14688,D10_lo,D10_hi,"));
  CHECK(has(csv.out, "\na,SW,A-1-b,0,Sa,0.1,0.1,"));
  CHECK(has(csv.out, "\nb,,A-1-b,0,,,,0.3,0.3,"));
  CHECK(has(csv.err, "b: no USCS group"));
  const Outcome json = mdm({"describe", folder / "a.csv", folder / "b.csv", "--format", "json"});
  const std::size_t end = json.out.find('\n');
  CHECK(Json::parse(json.out.substr(0, end)).at("id") == "a");
  CHECK(Json::parse(json.out.substr(end)).at("id") == "b");
  const Outcome sediment = mdm({"describe", folder / "a.csv", folder / "b.csv", "--sediment"});
  CHECK(has(sediment.out, "\n  a       "));
  CHECK(has(mdm({"describe", folder / "a.csv", folder / "b.csv", "--sediment", "--format", "csv"}).out,
            "id,folk_ward_mean_lo,folk_ward_mean_hi,folk_ward_mean_word,"));
  check_refused(mdm({"describe", "-", "-"}, sand), "standard input is one file");
  check_refused(mdm({"describe", folder / "a.csv", folder / "none.csv"}), "none.csv");
}

TEST_CASE("wrong options of describe are refused", "[describe]") {
  const auto refused = [](Arguments options, const std::string &message) {
    options.insert(options.begin(), {"describe", "-"});
    check_refused(mdm(options, sand), message);
  };
  refused({"--liquid-limit", "40"}, "go together");
  refused({"--plastic-limit", "40"}, "go together");
  refused({"--liquid-limit", "x", "--plastic-limit", "20"}, "--liquid-limit: 'x' is not a number");
  refused({"--liquid-limit", "20", "--plastic-limit", "40"}, "above the liquid limit");
  refused({"--liquid-limit", "-1", "--plastic-limit", "2"}, "the liquid limit is negative: give 0 or more");
  refused({"--digits", "0"}, "--help");
  refused({"--digits", "1001"}, "--help");
  refused({"--format", "yaml"}, "--help");
  refused({"--pan-size", "0.001"}, "there is no pan");
  refused({"--specimen-id", "BH1"}, "AGS4");
  check_refused(mdm({"describe"}), "--help");
  check_refused(mdm({"describe", "-"}, "size_mm,passing_percent\n1,50\n"), "stdin");
}

TEST_CASE("describe writes its output to a file or not at all", "[describe]") {
  const TemporaryFolder folder;
  CHECK(mdm({"describe", "-", "-o", folder / "d.json", "--format", "json"}, sand).out.empty());
  CHECK(Json::accept(read_file(folder / "d.json")));
  check_refused(mdm({"describe", "-", "-o", folder / "e.json"}, "nonsense"));
  CHECK(folder.entries() == 1);
}

} // namespace describe_test
