#include "particles/material_table.hpp"
#include "support.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>

namespace material_table_test {

using namespace mdm;
using namespace mdm::test;

namespace {

/// Classes 1, 2 and 4; class 3 has no grains.
ParticleSet three_classes() {
  return particle_set(solve(read_gradation("size_mm,mass\n0.1,1\n0.2,1\n0.4,0\n0.6,1\n1,0\n", "sand.csv")));
}

const GrainMaterial others{{5000000, ratio(1, 4)}, 0.5, 0.4};

std::vector<GrainMaterial> materials(const std::string &text) {
  return read_materials(text, "m.csv", three_classes(), others);
}

std::string material_refusal(const std::string &text) {
  try {
    materials(text);
  } catch (const InputError &error) {
    return error.what();
  }
  FAIL("no InputError");
  return {};
}

} // namespace

TEST_CASE("a material for each class, by its number, in any order") {
  const std::vector<GrainMaterial> m = materials("# of a "
                                                 "study\nclass,young_modulus,poisson,friction,restitution\n4,"
                                                 "1e7,0.3,0.7,0.8\n\n1,2e6,0,0,0.05\n2,3e6,0.5,10,1\n");
  REQUIRE(m.size() == 3);
  CHECK(m[0].elasticity.young == 2000000);
  CHECK(m[1].elasticity.poisson == ratio(1, 2));
  CHECK(m[1].friction == 10);
  CHECK(m[2].elasticity.young == 10000000);
  CHECK(m[2].restitution == 0.8);
}

TEST_CASE("a material by the lower sieve; what has no column is that of the others") {
  const std::vector<GrainMaterial> m = materials("lower_mm,friction\n0.1,0.1\n0.2,0.2\n0.6,0.6\n");
  REQUIRE(m.size() == 3);
  CHECK(m[2].friction == 0.6);
  CHECK(m[2].elasticity.young == 5000000);
  CHECK(m[2].restitution == 0.5);
}

TEST_CASE("materials that make no sense are refused with their line") {
  CHECK(contains(material_refusal(""), "m.csv:1: there is no header"));
  CHECK(contains(material_refusal("size,friction\n1,0.1\n"), "m.csv:1: 'size' is no first column"));
  CHECK(contains(material_refusal("class\n1\n"), "m.csv:1: there are no values"));
  CHECK(contains(material_refusal("class,colour\n1,1\n"), "m.csv:1: 'colour' is no column"));
  CHECK(contains(material_refusal("class,friction,friction\n1,1,1\n"),
                 "m.csv:1: 'friction' is no column, or there twice"));
  CHECK(contains(material_refusal("class,friction\n1,0.1\n2,0.1\n"),
                 "class 4 (0.6 mm, 1 mm] has grains, but no row"));
  CHECK(contains(material_refusal("class,friction\n1,0.1\n3,0.1\n"),
                 "m.csv:3: class '3' is no class with grains"));
  CHECK(contains(material_refusal("class,friction\n1,0.1\n1,0.1\n"),
                 "m.csv:3: class 1 has a row already, line 2"));
  CHECK(contains(material_refusal("class,friction\n1,-0.1\n"),
                 "m.csv:2: friction: '-0.1' is not from 0 to 10"));
  CHECK(
      contains(material_refusal("class,poisson\n1,0.51\n"), "m.csv:2: poisson: '0.51' is not from 0 to 0.5"));
  CHECK(contains(material_refusal("class,young_modulus\n1,0\n"),
                 "m.csv:2: young_modulus: '0' is not from 1 to 1e15"));
  CHECK(contains(material_refusal("class,restitution\n1,0\n"),
                 "m.csv:2: restitution: '0' is not from 0.05 to 1"));
  CHECK(contains(material_refusal("class,friction\n1,x\n"), "m.csv:2: friction: "));
  CHECK(
      contains(material_refusal("class,friction\n1,0.1,2\n"), "m.csv:2: the row has 3 fields, the header 2"));
}

} // namespace material_table_test
