// Extended XYZ.

#include "support.hpp"

namespace extxyz_test {

using namespace mdm;
using namespace mdm::test;

namespace {

const std::string properties = "Properties=species:S:1:pos:R:3:radius:R:1";

/// A file with this number in its first line.
std::string frame(const std::string &number, const std::string &comment,
                  const std::vector<std::string> &rows) {
  std::string text = number + "\n" + comment + "\n";
  for (const std::string &row : rows)
    text += row + "\n";
  return text;
}

const std::string two = frame("2", properties, {"Si 0 0 0 0.5", "Si 1 0 0 0.25"});

} // namespace

TEST_CASE("extended XYZ: radii in the unit of the gradation") {
  const Result result = read(two);
  CHECK(result.particles == "1 0.5");
  CHECK(result.format == ParticleFormat::extxyz);
  REQUIRE(result.notes.size() == 1);
  CHECK(contains(result.notes[0], "radii in mm."));
  CHECK(
      read("\xEF\xBB\xBF 2 \r\n" + properties + "\r\nSi 0\t0 0 .5\r\n  Si 1 0 0 25e-2 \r\n\r\n").particles ==
      "1 0.5");
  ParticleOptions options;
  options.unit = SizeUnit::m;
  options.meaning = SizeMeaning::diameter;
  CHECK(read(two, options).particles == "500 250");
  CHECK(read(two, options).notes.empty());
}

TEST_CASE("extended XYZ: Properties say which column the radius is") {
  const auto one = [](const std::string &comment, const std::string &row) {
    return read(frame("1", comment, {row})).particles;
  };
  CHECK(one("Properties=radius:R:1", "1") == "2");
  CHECK(one("Properties=radius:R:1:pos:R:3", "1 7 7 7") == "2");
  CHECK(one("Properties=id:I:1:type:I:1:pos:R:3:radius:R:1:fixed:L:1", "7 7 7 7 7 1 T") == "2");
  CHECK(one("Properties=pos:R:3:radius:I:1:species:S:1", "7 7 7 1 Si") == "2");
  CHECK(one("Lattice=\"9 0 0 0 9 0 0 0 9\" " + properties + " Time=0.1 pbc=\"T T T\"", "Si 7 7 7 1") == "2");
  CHECK(one("\tProperties=\"pos:R:3:radius:R:1\"", "7 7 7 1") == "2");
  // What stands in quotes is the value of another key.
  CHECK(one(R"(note="a \" Properties=pos:R:3" Properties=radius:R:1)", "1") == "2");
}

TEST_CASE("extended XYZ: a number above other lines is a diameter") {
  CHECK(read("2\n").particles == "2");
  CHECK(read("2\n").format == ParticleFormat::diameters);
  CHECK(read("2\n3\n").particles == "2 3");
  CHECK(read("2\n# Properties of sand\n\n3\n").particles == "2 3");
  CHECK(contains(refusal("1\na molecule\nO 0 0 0\n"), "file:2: the line is not one number"));
  CHECK(contains(refusal("2.5\n" + properties + "\n"), "file:2: 'Properties="));
  CHECK(contains(refusal("0\n"), "file:1: diameter '0' is not above 0"));
}

TEST_CASE("extended XYZ: a comment that names no column of radii is refused") {
  const auto comment = [](const std::string &text) {
    return refusal(frame("1", text, {"Si 0 0 0 1"}), from(ParticleFormat::extxyz));
  };
  CHECK(contains(comment(""), "file:2: there is no Properties= in the comment: write for example Prop"));
  CHECK(contains(comment("sand=\"" + properties + "\""), "file:2: there is no Properties="));
  CHECK(contains(comment("Properties="), "file:2: there is no radius among the Properties ''"));
  CHECK(contains(comment("Properties=species:S:1:pos:R:3"),
                 "file:2: there is no radius among the Properties 'species:S:1:pos:R:3': add radius:R:1"));
  CHECK(contains(comment("Properties=radius:R:3"), "file:2: property 'radius' is not one number a particle"));
  CHECK(contains(comment("Properties=radius:S:1"), "file:2: property 'radius' is not one number a particle"));
  CHECK(contains(comment("Properties=radius:R:1:radius:R:1"), "file:2: property 'radius' is there twice"));
  for (const char *property : {"pos", "pos:R", "pos:R:", "pos:R:0", "pos:R:-1", "pos:R:x", "pos::3",
                               "pos:X:3", "pos:RR:3", "pos:R:3.0", "pos:R:99999999999999999999"})
    CHECK(contains(comment("Properties=radius:R:1:" + std::string(property)),
                   "file:2: property 'pos' is not name:type:columns"));
  CHECK(contains(comment("Properties=:R:1"), "file:2: property '' is not name:type:columns"));
  for (const char *columns : {"1000", "4611686018427387904"})
    CHECK(contains(comment("Properties=radius:R:1:pos:R:" + std::string(columns)),
                   "file:2: the Properties have more than 1000 columns"));
}

TEST_CASE("extended XYZ: broken files") {
  const auto broken = [](const std::string &number, const std::vector<std::string> &rows) {
    return refusal(frame(number, properties, rows), from(ParticleFormat::extxyz));
  };
  const std::string good = "Si 0 0 0 1";
  CHECK(contains(broken("many", {good}), "file:1: 'many' is no number of particles"));
  CHECK(contains(broken("", {good}), "file:1: '' is no number of particles"));
  CHECK(contains(broken("-1", {good}), "file:1: '-1' is no number of particles"));
  CHECK(contains(broken("0", {}), "file:2: there are no particles"));
  CHECK(contains(broken("3", {good, good}), "file:4: the file ends after 2 of 3 particles"));
  CHECK(contains(broken("1", {good, good}), "file:4: there are more particles than the 1 of the first line"));
  CHECK(contains(refusal(two + two), "file:5: there are more particles than the 2 of the first line"));
  CHECK(contains(broken("2", {good, "Si 0 0 1"}), "file:4: the line has 4 values, the Properties have 5"));
  CHECK(contains(broken("2", {good, good + " 1"}), "file:4: the line has 6 values, the Properties have 5"));
  CHECK(contains(broken("2", {good, "Si 0 0 0 0"}), "file:4: radius '0' is not above 0"));
  CHECK(contains(broken("2", {good, "Si 0 0 0 -1"}), "file:4: radius '-1' is not above 0"));
  CHECK(contains(broken("2", {good, "Si 0 0 0 nan"}), "file:4: radius 'nan' is not a number"));
  CHECK(contains(refusal("", from(ParticleFormat::extxyz)), "file:1: the file ends above"));
  CHECK(contains(refusal("2\n", from(ParticleFormat::extxyz)), "file:1: the file ends above"));
  check_truncations(two, from(ParticleFormat::extxyz));
}

} // namespace extxyz_test
