// Samples with materials, judged by mdm verify.

#include "answer.hpp"

namespace material_verify_test {

using namespace cli_test;

namespace {

/// 3 grains of quartz of 2 mm have 3 * 8 * 2.65 = 63.6, one of shell of 3 mm has 27 * 2.75 = 74.25.
const std::string beach = "size_mm,mass,factor,material\n1,63.6,2.65,quartz\n2,0,2.65,quartz\n"
                          "1.5,74.25,2.75,shell\n3,0,2.75,shell\n";
const std::string grains = "size_mm,quantity,material\n3,1,shell\n2,3,quartz\n";

struct Judge {
  TemporaryFolder folder;
  std::string gradation = folder.write("beach.csv", beach);

  Outcome verdict(const std::string &sample, Arguments options = {}) const {
    options.insert(options.begin(), {"verify", gradation, folder.write("grains.csv", sample)});
    return mdm(options);
  }
};

} // namespace

TEST_CASE("each particle is judged in the classes of its material", "[cli]") {
  const Judge judge;
  const Outcome exact = judge.verdict(grains);
  CHECK(exact.exit_code == 0);
  CHECK(contains(exact.out, "matches exactly"));
  CHECK(contains(exact.out, "quartz"));
  CHECK(judge.verdict("material,diameter_um,count\nshell,3000,2\nquartz,2000,6\n").exit_code == 0);
  // Without the material both sizes would be in a class.
  const Outcome swapped = judge.verdict("size_mm,quantity,material\n2,1,shell\n2,3,quartz\n");
  CHECK(swapped.exit_code == 1);
  CHECK(contains(swapped.out, "does not match"));
}

TEST_CASE("shares are of the mass of all materials, with their factors", "[cli]") {
  const Judge judge;
  const Json report =
      Json::parse(judge.verdict("size_mm,material\n2,quartz\n2,shell\n", {"--format", "json"}).out);
  REQUIRE(report["classes"].size() == 2);
  CHECK(report["classes"][0]["material"] == "quartz");
  CHECK(report["classes"][0]["found"] == "53/108"); // 8 * 2.65 of 8 * (2.65 + 2.75)
  CHECK(report["classes"][1]["found"] == "55/108");
  CHECK(report["classes"][0]["target"] == "424/919");
  CHECK(report["worst_class"] == "1");
}

TEST_CASE("particles of the wrong material are outside or in the wrong class", "[cli]") {
  const Judge judge;
  const Outcome large = judge.verdict("size_mm,quantity,material\n3,1,quartz\n2,3,quartz\n3,1,shell\n");
  CHECK(large.exit_code == 1);
  CHECK(contains(large.out, "1 particle outside all classes"));
  CHECK(contains(large.out, "larger than the largest opening of their material, the first of 3 mm"));
  const Outcome small = judge.verdict(grains + "1.5,1,shell\n");
  CHECK(contains(small.out, "not larger than the finest opening of their material, the first of 1.5 mm"));
  const Outcome foreign = judge.verdict(grains + "2,4,mica\n2,1,Quartz\n", {"--tolerance", "100%"});
  CHECK(foreign.exit_code == 1);
  CHECK(contains(foreign.out,
                 "5 particles of materials that the gradation does not have, the first of 'mica'"));
  const Json report = Json::parse(judge.verdict(grains + "2,4,mica\n", {"--format", "json"}).out);
  CHECK(report["outside"]["other_materials"] == "4");
}

TEST_CASE("tolerances on shares of several materials", "[cli]") {
  const Judge judge;
  const std::string near = "size_mm,quantity,material\n3,10,shell\n2,31,quartz\n";
  CHECK(judge.verdict(near).exit_code == 1);
  // 31 * 21.2 of 31 * 21.2 + 10 * 74.25 is 46.95 %, and 46.14 % are asked for.
  CHECK(judge.verdict(near, {"--tolerance", "0.82%"}).exit_code == 0);
  CHECK(judge.verdict(near, {"--tolerance", "0.80%"}).exit_code == 1);
  CHECK(judge.verdict(near, {"--tolerance", "total:1.64%"}).exit_code == 0);
  CHECK(judge.verdict(near, {"--tolerance", "total:1.60%"}).exit_code == 1);
  check_refused(judge.verdict(near, {"--tolerance", "passing:1%"}), "use retained:E% or total:E%");
}

TEST_CASE("answers to several materials are judged", "[cli]") {
  const Judge judge;
  const std::string wide = judge.folder.write(
      "wide.csv", "size_mm,mass,factor,material\n0.5,3,2.65,quartz\n1,5,2.65,quartz\n2,0,2.65,quartz\n"
                  "0.5,1,2.75,shell\n2,1,2.75,shell\n4,0,2.75,shell\n");
  for (const std::string law : {"sphere", "power:5/2"}) {
    const std::string answer = judge.folder / "answer.json", csv = judge.folder / "answer.csv";
    CHECK(mdm({"solve", wide, "--law", law, "-o", answer}).exit_code == 0);
    const Outcome exact = mdm({"verify", wide, answer, "--law", law});
    INFO(exact.out);
    CHECK(exact.exit_code == 0);
    CHECK(contains(exact.out, "matches exactly"));
    CHECK(mdm({"solve", wide, "--law", law, "-o", csv}).exit_code == 0);
    CHECK(mdm({"verify", wide, csv, "--law", law, "--tolerance", "1e-9%"}).exit_code == 0);
    check_refused(mdm({"verify", judge.gradation, answer, "--law", law}), "is none of the gradation");
  }
  const std::string plain = judge.folder.write("plain.csv", "size_mm,mass\n1,1\n2,0\n");
  const std::string of_one = judge.folder / "one.json";
  CHECK(mdm({"solve", plain, "-o", of_one}).exit_code == 0);
  check_refused(mdm({"verify", wide, of_one}), "its classes have no materials");
}

TEST_CASE("samples without materials, and materials without a gradation of them, are refused", "[cli]") {
  const Judge judge;
  check_refused(judge.verdict("size_mm,quantity\n3,1\n2,3\n"), "give CSV with a column material");
  check_refused(judge.verdict("size_mm,quantity,material,material\n3,1,shell,shell\n"),
                "there is one of this meaning before");
  check_refused(judge.verdict("0 0 0 1\n", {"--from", "xyzr"}), "give CSV with a column material");
  const std::string plain = judge.folder.write("plain.csv", "size_mm,mass\n1,1\n2,0\n");
  check_refused(mdm({"verify", plain, judge.folder.write("g.csv", grains)}),
                "g.csv:2: material 'shell': particles with materials are for mdm verify");
}

TEST_CASE("what says nothing of samples of several materials is refused", "[cli]") {
  const Judge judge;
  const std::string band =
      judge.folder.write("band.csv", "size_mm,passing_min_percent,passing_max_percent\n2,0,100\n");
  for (const Arguments &options : std::vector<Arguments>{{"--band", band},
                                                         {"--cut-below", "1"},
                                                         {"--pan-size", "0.1"},
                                                         {"--packing"},
                                                         {"--over-time"},
                                                         {"--proof", judge.folder / "a.proof"},
                                                         {"--unit", "mm"}})
    check_refused(judge.verdict(grains, options), options.front() + ": it is of gradations of one material");
}

} // namespace material_verify_test
