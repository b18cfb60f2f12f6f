// Files of phi that is no whole number, from end to end.

#include "answer.hpp"
#include "run.hpp"

namespace phi_test {

using namespace cli_test;

namespace {

const std::string tied = "size_phi,mass\n-2,0\n-1.5,1\n-1,0\n-0.5,0\n0,1\n";

} // namespace

TEST_CASE("phi: the exact answer has the exact openings, and mdm reads what it wrote") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", tied), answer = folder / "answer.json";
  REQUIRE(mdm({"solve", sand, "--format", "json", "-o", answer}).exit_code == 0);
  const Json json = Json::parse(read_file(answer));
  CHECK(json.at("particles") == "10");
  CHECK(json.at("size_power") == "2");
  CHECK(json.at("scale").at("scale_power") == "2");
  CHECK(json.at("classes").at(0).at("upper") == "1.4142135623731");
  CHECK(json.at("classes").at(0).at("upper_power") == "2");
  CHECK(json.at("classes").at(3).at("lower_power") == "8");
  const Outcome verified = mdm({"verify", sand, answer});
  CHECK(verified.exit_code == 0);
  CHECK(contains(verified.out, "matches exactly"));
  const Outcome exported = mdm({"export", answer, "--to", "csv"});
  CHECK(exported.exit_code == 0);
  CHECK(contains(exported.out, "quantity"));
  const std::string list = folder.write("list.csv", exported.out);
  CHECK(mdm({"verify", sand, list, "--tolerance", "0.001%"}).exit_code == 0);
  // An answer whose decimals do not name its powers is none of mdm's.
  std::string changed = read_file(answer);
  changed.replace(changed.find("1.4142135623731\""), 15, "1.4142135623732");
  CHECK(mdm({"verify", sand, folder.write("changed.json", changed)}).exit_code == 2);
}

TEST_CASE("phi: a spread is verified") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", tied), answer = folder / "answer.json";
  REQUIRE(mdm({"solve", sand, "--spread", "--format", "json", "-o", answer}).exit_code == 0);
  CHECK(mdm({"verify", sand, answer}).exit_code == 0);
  CHECK(mdm({"export", sand, "--spread", "--to", "csv"}).exit_code == 0);
}

TEST_CASE("phi: mdm convert rounds, with a note, and the answer is another") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", tied), mm = folder / "mm.csv";
  const Outcome converted = mdm({"convert", sand, "-o", mm});
  CHECK(converted.exit_code == 0);
  CHECK(contains(converted.err, "rounded to 15 significant digits in mm: phi '-1.5', '-0.5'"));
  CHECK(contains(read_file(mm), "2.82842712474619,1\n"));
  CHECK(contains(mdm({"solve", mm}).out, "9 particles"));
  CHECK(contains(mdm({"solve", sand}).out, "10 particles"));
}

TEST_CASE("phi: what needs rational masses is refused with the remedy") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", tied);
  for (const Arguments &arguments :
       {Arguments{"solve", sand, "--tolerance", "retained:1%"}, Arguments{"published", "fixed-size", sand},
        Arguments{"generate", "--curve", sand, "--classes", "4", "--min-per-class", "2"},
        Arguments{"solve", sand, "--vipr", folder / "x.vipr"},
        Arguments{"solve", folder.write("fine.csv", "size_phi,mass\n-1,0\n0.0001,1\n")}}) {
    const Outcome refused = mdm(arguments);
    INFO(arguments[0]);
    CHECK(refused.exit_code == 2);
    CHECK(contains(refused.err, "mdm convert"));
  }
  CHECK(mdm({"solve", sand, "--tolerance", "retained:1%", "--law", "power:2"}).exit_code == 0);
}

TEST_CASE("phi: VIPR takes openings whose ratios are rational") {
  const TemporaryFolder folder;
  const std::string halves = folder.write("halves.csv", "size_phi,mass\n-1.5,0\n-0.5,3\n0.5,2\n");
  CHECK(mdm({"solve", halves, "--vipr", folder / "x.vipr"}).exit_code == 0);
}

TEST_CASE("phi: a cut is named by the printed opening") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", tied);
  CHECK(mdm({"solve", sand, "--cut-below", "2.82842712474619"}).exit_code == 0);
  const Outcome refused = mdm({"solve", sand, "--cut-below", "2.8284271247"});
  CHECK(refused.exit_code == 2);
  CHECK(contains(refused.err, "the sieves are 1, 1.4142135623731, 2, 2.82842712474619, 4"));
}

TEST_CASE("phi: samples of decimals and of phi are judged exactly") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", "size_phi,mass\n-1.5,0\n-0.5,1\n");
  const auto verdict = [&](const std::string &sample) {
    return mdm({"verify", sand, folder.write("sample.csv", sample)}).exit_code;
  };
  CHECK(verdict("size_mm,quantity\n2.828427124746190,1\n") == 0);
  CHECK(verdict("size_mm,quantity\n2.828427124746191,1\n") == 1); // above 2^1.5
  CHECK(verdict("size_phi,quantity\n-0.5,1\n") == 1);             // passes the lower sieve
  const Outcome own =
      mdm({"verify", sand, folder.write("own.csv", "size_phi,quantity\n-1.5,1\n"), "--format", "json"});
  CHECK(Json::parse(own.out).at("conditions").at("describes").at("holds") == true); // passes its own opening
}

TEST_CASE("phi: descriptions, pictures and the trade-off take irrational openings") {
  const TemporaryFolder folder;
  const std::string sand = folder.write("sand.csv", tied);
  const Outcome described = mdm({"describe", sand, "--format", "json"});
  REQUIRE(described.exit_code == 0);
  const Json json = Json::parse(described.out);
  CHECK(json.at("passing").at(0).at("size") == "1");
  CHECK(json.at("passing").at(1).at("size") == Json({"1.41421356237309", "1.4142135623731"}));
  CHECK(json.at("D50").is_array());
  CHECK(mdm({"plot", sand, "--match", "-o", folder / "x.svg"}).exit_code == 0);
  const Outcome tradeoff = mdm({"tradeoff", sand, "--tolerances", "0"});
  CHECK(contains(tradeoff.out, "2.82842712474619"));
}

} // namespace phi_test
