// mdm convert: every format to canonical CSV and JSON, with the same answer.

#include "answer.hpp"

namespace convert_test {

using namespace cli_test;

namespace {

/// Classes and quantities of the answer to a file.
Json classes(const std::string &path, Arguments options = {}) {
  options.insert(options.begin(), path);
  return solve_json(options).at("classes");
}

/// Converts to CSV, that to JSON, that to CSV: the answers agree and the two CSV files are the same bytes.
void check_round_trip(const std::string &path, const Arguments &options = {}) {
  INFO(path);
  const TemporaryFolder folder;
  const std::string csv = folder / "a.csv", json = folder / "b.json", back = folder / "c.csv";
  const auto converted = [](const std::string &from, const std::string &to, const Arguments &more) {
    Arguments arguments{"convert", from, "-o", to, "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = mdm(arguments);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.empty());
  };
  converted(path, csv, options);
  converted(csv, json, {});
  converted(json, back, {});
  CHECK(read_file(csv).find(',') != std::string::npos);
  CHECK(Json::accept(read_file(json)));
  CHECK(read_file(back) == read_file(csv));
  const Json expected = classes(path, options);
  CHECK(classes(csv) == expected);
  CHECK(classes(json) == expected);

  // The checker reads the canonical files as well.
  CHECK(mdm({"solve", csv, "--proof", folder / "proof"}).exit_code == 0);
  CHECK(mdm_check(csv, folder / "proof").exit_code == 0);
  CHECK(mdm_check(json, folder / "proof").exit_code == 0);
}

const std::string ags =
    "\"GROUP\",\"GRAT\"\r\n"
    "\"HEADING\",\"LOCA_ID\",\"SAMP_TOP\",\"SAMP_REF\",\"SAMP_TYPE\",\"SAMP_ID\",\"SPEC_REF\",\"SPEC_DPTH\","
    "\"GRAT_SIZE\",\"GRAT_PERP\",\"GRAT_TYPE\",\"GRAT_REM\",\"FILE_FSET\"\r\n"
    "\"UNIT\",\"\",\"m\",\"\",\"\",\"\",\"\",\"m\",\"mm\",\"%\",\"\",\"\",\"\"\r\n"
    "\"TYPE\",\"ID\",\"2DP\",\"X\",\"PA\",\"ID\",\"X\",\"2DP\",\"3SF\",\"0DP\",\"PA\",\"X\",\"X\"\r\n";

std::string ags_rows(const std::string &location, const std::string &fine) {
  std::string text;
  for (const std::string &row :
       {std::string("\"3.35\",\"100\""), std::string("\"1.18\",\"60\""), "\"0.063\",\"" + fine + "\""})
    text += "\"DATA\",\"" + location + "\",\"24.55\",\"24\",\"U\",\"A1\",\"1a\",\"24.55\"," + row +
            ",\"WS\",\"\",\"\"\r\n";
  return text;
}

} // namespace

TEST_CASE("real gradations survive conversion", "[cli]") {
  for (const char *name : {"athabasca-sand", "c778-graded-sand", "cen-standard-sand", "hostun-rf-sand",
                           "limestone-pfc", "ottawa-f65-sand"})
    check_round_trip(example(name));
}

TEST_CASE("every column of sizes and masses survives conversion", "[cli]") {
  const TemporaryFolder folder;
  for (const char *text :
       {"size_um,retained_g\n75,1.5\n150,2.25\n300,0\n",
        "size_m,retained_fraction\n0.001,0.25\n0.002,0.75\n0.004,0\n",
        "size_in,retained_percent\n0.375,40\n0.75,60\n1,0\n", "size_phi,mass\n2,3\n1,2\n0,1\n-1,0\n",
        "sieve,passing_percent\n3/8\",100\n\"#4\",80\nNo. 200,10\npan,0\n",
        "sieve,passing_percent\nTyler 65 mesh,20\nTyler 28,100\n",
        "size_mm,cumulative_retained_percent\n1,100\n2,60\n3,0\n", "size_mm,passing_fraction\n1,0.125\n2,1\n",
        "\xEF\xBB\xBFsize_mm;mass\r\n1,5;2,25\r\n2,5;0\r\n", "size_mm,mass,factor\n1,2,2.65\n2,1,1\n3,0,1\n",
        "size_mm,mass\n3,0\n1,1e-30\n2,123456789012345678901234567890\n",
        "{\"sizes\":[\"3\",\"2\",\"1\"],\"masses\":[0,1.5,2],\"unit\":\"um\"}",
        "{\"sizes\":[1,2,3],\"masses\":[1,1,0],\"factors\":[1,\"2.5\",1],\"id\":\"x\"}"})
    check_round_trip(folder.write("given", text));
}

TEST_CASE("the format follows --format, then the name of the output", "[cli]") {
  const std::string sand = example("hostun-rf-sand");
  CHECK(mdm({"convert", sand}).out.find("size_mm,") != std::string::npos);
  CHECK(Json::accept(mdm({"convert", sand, "--format", "json"}).out));
  const TemporaryFolder folder;
  CHECK(mdm({"convert", sand, "-o", folder / "a.json", "--format", "csv"}).exit_code == 0);
  CHECK_FALSE(Json::accept(read_file(folder / "a.json")));
}

TEST_CASE("a gradation is not converted in place", "[cli]") {
  const TemporaryFolder folder;
  const std::string path = folder.write("sand.csv", read_file(example("athabasca-sand")));
  CHECK(mdm({"convert", path, "-o", path}).exit_code == 2);
  CHECK(classes(path) == classes(example("athabasca-sand")));
  CHECK(folder.entries() == 1);
}

TEST_CASE("AGS4 converts, one specimen of several by its id", "[cli]") {
  const TemporaryFolder folder;
  check_round_trip(folder.write("one.ags", ags + ags_rows("BH1", "8")));
  const std::string many = folder.write("many.ags", ags + ags_rows("BH1", "8") + ags_rows("BH2", "20"));
  check_round_trip(many, {"--specimen-id", "BH2"});
  CHECK(classes(many, {"--specimen-id", "BH1"}) != classes(many, {"--specimen-id", "BH2"}));
  check_refused(mdm({"convert", many}), "--specimen-id");
  check_refused(mdm({"solve", many}), "BH2");
  check_refused(mdm({"convert", many, "--specimen-id", "BH3"}), "BH3");
}

TEST_CASE("the proof of an AGS4 file comes with a gradation that the checker reads", "[cli]") {
  const TemporaryFolder folder;
  const std::string site = folder.write("site.ags", ags + ags_rows("BH1", "8") + ags_rows("BH2", "20"));
  const std::string proof = folder / "proof";
  const Outcome outcome = mdm({"solve", site, "--specimen-id", "BH1", "--proof", proof});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find(proof + ".gradation.csv") != std::string::npos);
  CHECK(mdm_check(proof + ".gradation.csv", proof).exit_code == 0);
  CHECK(mdm_check(site, proof).exit_code == 2);
}

TEST_CASE("notes go to standard error and --quiet drops them", "[cli]") {
  const TemporaryFolder folder;
  const std::string path = folder.write("g.csv", "size_mm,passing_percent\n1,10\n2,100\n");
  const Outcome outcome = mdm({"convert", path});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.find("pan") != std::string::npos);
  const Outcome quiet = mdm({"convert", path, "--quiet"});
  CHECK(quiet.out == outcome.out);
  CHECK(quiet.err.empty());
}

TEST_CASE("convert --dry-run shows what was understood and writes nothing", "[cli]") {
  const TemporaryFolder folder;
  const std::string path =
      folder.write("sand.txt", "Labor Nord\nSiebweite [mm];Durchgang [%]\n2,0;100\n0,063;4,5\n");
  const Outcome outcome = mdm({"convert", path, "--dry-run"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  for (const std::string part :
       {"sand.txt: text with ; between cells\n", "  sizes   column 'Siebweite [mm]', in mm\n",
        "  masses  column 'Durchgang [%]': percent passing\n", "  pan     yes, at size 0\n",
        "  check   mdm-check reads what mdm convert writes\n",
        "A pan of size 0 was added for the 4.5 percent", "\n\nsize_mm,mass\n0,4.5\n0.063,95.5\n2,0\n"})
    CHECK(outcome.out.find(part) != std::string::npos);
  CHECK(mdm({"convert", example("athabasca-sand"), "--dry-run"})
            .out.find("mdm-check reads the file as it is") != std::string::npos);
  check_refused(mdm({"convert", path, "--dry-run", "-o", folder / "x.csv"}), "--dry-run");
  CHECK(folder.entries() == 1);
}

TEST_CASE("convert --dry-run says in JSON what was understood", "[cli]") {
  const TemporaryFolder folder;
  const std::string path = folder.write("sand.txt", "Siebweite [um];Durchgang [%]\n2000;100\n63;4,5\n");
  const Json read = Json::parse(mdm({"convert", path, "--dry-run", "--format", "json"}).out);
  CHECK(read.at("schema") == "mdm-reading-1");
  CHECK(read.at("unit") == "um");
  CHECK(read.at("kind") == "passing_percent");
  CHECK(read.at("sizes") == "column 'Siebweite [um]', in um");
  CHECK(read.at("classes") == "2");
  CHECK(read.at("pan") == true);
  CHECK(read.at("canonical") == false);
  CHECK(read.at("notes").dump().find("A pan of size 0 was added") != std::string::npos);
  CHECK(mdm({"convert", path, "--dry-run", "-o", folder / "read.json"}).exit_code == 0);
  CHECK(Json::parse(read_file(folder / "read.json")) == read);
  // Half phi are no decimals, and are not rounded for it.
  const std::string phi = folder.write("phi.csv", "size_phi,mass\n-1,0\n-0.5,1\n0,2\n");
  const Json half = Json::parse(mdm({"convert", phi, "--dry-run", "--format", "json"}).out);
  CHECK(half.at("kind") == "mass");
  CHECK(half.at("notes").dump().find("rounded") == std::string::npos);
  check_refused(mdm({"convert", path, "--dry-run", "--format", "csv"}), "--dry-run");
}

TEST_CASE("every command reads a table with the options that say what it is", "[cli]") {
  const TemporaryFolder folder;
  const std::string path = folder.write("sand.txt", "d,P\n2,100\n1,40\n0.5,10\n0.1,0\n");
  const std::string canonical =
      folder.write("sand.csv", "size_mm,passing_percent\n2,100\n1,40\n0.5,10\n0.1,0\n");
  const Arguments options = {"--columns", "d,P", "--kind", "passing", "--unit", "mm"};
  for (const Arguments &command :
       {Arguments{"solve"}, Arguments{"describe"}, Arguments{"convert"}, Arguments{"published", "rounded"}}) {
    Arguments wide = command, plain = command;
    wide.push_back(path);
    wide.insert(wide.end(), options.begin(), options.end());
    plain.push_back(canonical);
    const Outcome ours = mdm(wide);
    CHECK(ours.exit_code == 0);
    CHECK(ours.exit_code == mdm(plain).exit_code);
    INFO(ours.err);
    if (command[0] == "convert")
      CHECK(ours.out == mdm(plain).out);
  }
  CHECK(classes(path, options) == classes(canonical));
  check_refused(mdm({"solve", path}), "--columns SIZE,VALUE");
  check_refused(mdm({"solve", "--band", canonical, "--round", "3"}),
                "--round: it is of the gradation's FILE");
  check_refused(mdm({"solve", canonical, "--round", "0"}), "--round");
}

TEST_CASE("a unit beside that of a file of particles is refused by the option's name", "[cli]") {
  const TemporaryFolder folder;
  check_refused(mdm({"convert", folder.write("r.csv", "radius_mm,quantity\n1,3\n"), "--unit", "mm"}),
                "the header names the unit: leave out --unit");
}

TEST_CASE("a rounded question is proved of the gradation that is written", "[cli]") {
  const TemporaryFolder folder;
  const std::string path = folder.write("sand.csv", "size_mm,mass\n1,0.30000000000000004\n2,0.7\n4,0\n");
  const std::string proof = folder / "proof";
  const Outcome dusty = mdm({"solve", path});
  CHECK(dusty.out.find("0.30000000000000004 beside 0.3") != std::string::npos);
  CHECK(dusty.out.find("--round 15") != std::string::npos);
  const Outcome outcome = mdm({"solve", path, "--round", "15", "--proof", proof});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("mdm-check " + proof + ".gradation.csv " + proof) != std::string::npos);
  CHECK(read_file(proof + ".gradation.csv") == "size_mm,mass\n1,0.3\n2,0.7\n4,0\n");
  CHECK(mdm_check(proof + ".gradation.csv", proof).exit_code == 0);
  CHECK(mdm({"solve", path, "--proof", proof}).out.find(".gradation.csv") == std::string::npos);
}

} // namespace convert_test
