#include "gradation/material_gradation.hpp"
#include "support.hpp"

#include <mdm/number/decimal.hpp>

namespace material_gradation_test {

using namespace mdm;
using namespace mdm::test;

namespace {

const std::string beach =
    "size_mm,mass,factor,material\n0.5,3,2.65,quartz\n1,5,2.65,quartz\n2,0,2.65,quartz\n"
    "0.5,1,2.75,shell\n2,1,2.75,shell\n4,0,2.75,shell\n";

Gradation read_beach(const std::string &content) {
  return read_material_gradation(content, "beach.csv");
}

std::string refusal_of(const std::string &content) {
  return message_of([&] { read_beach(content); });
}

std::vector<std::string> rows(const Gradation &g) {
  std::vector<std::string> texts;
  for (std::size_t j = 0; j <= g.classes(); ++j)
    texts.push_back(g.material(j) + " " + to_decimal(g.sizes()[j]) + " " + to_decimal(g.mass(j)) + " " +
                    to_decimal(g.factor(j)));
  return texts;
}

} // namespace

TEST_CASE("a gradation of several materials has the rows of one behind those of another") {
  const Gradation g = read_beach(beach);
  CHECK(g.id() == "beach");
  CHECK(rows(g) == std::vector<std::string>{"quartz 0.5 3 2.65", "quartz 1 5 2.65", "quartz 2 0 2.65",
                                            "shell 0.5 1 2.75", "shell 2 1 2.75", "shell 4 0 2.75"});
  CHECK(g.is_class(1));
  CHECK_FALSE(g.is_class(2));
  CHECK(g.is_class(3));
  CHECK_FALSE(g.is_class(5));
  CHECK(g.coarsest() == 4);
}

TEST_CASE("materials ascend by the bytes of their names, whatever the order of the rows") {
  const std::string shuffled =
      "# a beach\nsize_mm;retained_g;material;factor\n4;0;shell;2,75\n1;5;quartz;2,65\n0,5;1;\"shell\";2,75\n"
      "2;1;shell;2,75\n2;0;quartz;2,65\n0,5;3;quartz;2,65\n";
  CHECK(rows(read_beach(shuffled)) == rows(read_beach(beach)));
  const std::string names = "size_mm,mass,material\n1,1,b\n2,0,b\n1,1,B\n2,0,B\n1,1,\xC3\xA9\n2,0,\xC3\xA9\n";
  const Gradation g = read_beach(names);
  CHECK(g.material(0) == "B");
  CHECK(g.material(2) == "b");
  CHECK(g.material(4) == "\xC3\xA9");
}

TEST_CASE("phi of all materials has one root") {
  const Gradation g = read_beach("size_phi,mass,material\n0.5,1,a\n0,0,a\n1,1,b\n-0.25,0,b\n");
  CHECK(g.root() == 4);
  CHECK(g.powers() == std::vector<Rational>{ratio(1, 4), 1, ratio(1, 16), 2});
}

TEST_CASE("sizes of several materials are multiplied all") {
  const Gradation g = read_beach(beach).scaled(2);
  CHECK(g.material(3) == "shell");
  CHECK(g.sizes()[3] == 1);
}

TEST_CASE("each material is complete by itself") {
  CHECK(refusal_of("size_mm,mass,material\n1,1,a\n2,0,a\n1,1,b\n2,3,b\n") ==
        "beach.csv:5: the largest sieve, 2 mm, has mass 3, not 0: add a row for a larger sieve with mass 0 "
        "(of the material 'b')");
  CHECK(contains(refusal_of("size_mm,mass,material\n1,1,a\n2,0,a\n4,0,b\n"),
                 "beach.csv:4: a gradation needs at least two rows below the header, there are 1 (of the "
                 "material 'b')"));
  CHECK(contains(refusal_of("size_mm,mass,material\n1,1,a\n2,0,a\n1,0,b\n4,0,b\n"),
                 "no row has a mass above 0: write what each sieve retains (of the material 'b')"));
  CHECK(contains(refusal_of("size_mm,mass,material\n1,1,a\n2,0,a\n1,1,a\n"),
                 "beach.csv:4: size 1 mm repeats that of line 2: leave one out (of the material 'a')"));
  CHECK(contains(refusal_of("size_mm,mass,material,factor\n1,1,a,1\n2,0,a,0\n"),
                 "beach.csv:3: factor 0 is not above 0"));
  CHECK(contains(refusal_of("size_mm,mass,material\n"), "there is no row below the header"));
}

TEST_CASE("a material has a name") {
  for (const std::string &name : {std::string(), std::string("\" a\""), std::string(101, 'a')})
    CHECK(contains(refusal_of("size_mm,mass,material\n1,1," + name + "\n2,0," + name + "\n"),
                   "beach.csv:2: material '"));
}

TEST_CASE("shares and tolerances of several materials have no meaning") {
  for (const std::string column : {"retained_percent", "retained_fraction", "passing_percent",
                                   "passing_fraction", "cumulative_retained_percent"})
    CHECK(contains(refusal_of("size_mm," + column + ",material\n1,1,a\n2,0,a\n"),
                   "beach.csv:1: " + column + " is a part of a whole"));
  CHECK(contains(refusal_of("size_mm,mass,tolerance_percent,material\n1,1,1,a\n2,0,1,a\n"),
                 "tolerance_percent has no use beside material"));
  CHECK(contains(refusal_of("size_mm,mass,material,material\n1,1,a,a\n2,0,a,a\n"), "is there twice"));
}

TEST_CASE("a column of materials is told by its name") {
  CHECK(is_material_gradation("\xEF\xBB\xBF# a\nsize_mm,mass,material\n"));
  CHECK(is_material_gradation("sieve,passing_percent,material\n"));
  CHECK_FALSE(is_material_gradation("size_mm,mass,factor\n"));
  CHECK(is_material_gradation("material,size_mm,mass\n")); // which the reader refuses
  CHECK_FALSE(is_material_gradation("size_mm\n"));
  CHECK_FALSE(is_material_gradation("{\"id\": \"material\"}"));
}

TEST_CASE("options of reading do not make several materials one") {
  Reading reading;
  reading.kind = "mass";
  const std::string apart = "size_mm,mass,material\n1,1,a\n2,0,a\n4,1,b\n8,0,b\n";
  CHECK(contains(message_of([&] { read_gradation(apart, "beach.csv", reading); }),
                 "column material is of a gradation of several materials"));
}

TEST_CASE("the reader of one material refuses several and names the commands") {
  CHECK(contains(message_of([] { read_gradation(beach, "beach.csv"); }),
                 "beach.csv:1: column material is of a gradation of several materials: mdm solve, batch, "
                 "verify and export take it"));
}

} // namespace material_gradation_test
