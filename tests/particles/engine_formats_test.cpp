// Files of engines with formats of their own.

#include "replaced.hpp"
#include "support.hpp"

namespace engine_formats_test {

using namespace mdm;
using namespace mdm::test;
using mdm_test::replaced;

namespace {

const std::string geometry =
    "LSMGeometry 1.2\nBoundingBox 0 0 0 10 10 10\nPeriodicBoundaries 0 0 0\nDimension 3D\n"
    "BeginParticles\nSimple\n2\n1 1 1 0.5 0 3\n2.5 1 1 .25 1 4\nEndParticles\n"
    "BeginConnect\n0\nEndConnect\n";
const std::string snapshot = "2\n1 1 1 0.5 0 3 0.52 1 1 1\n2.5 1 1 .25 1 4 0.06 2 1 1\n0\nTMIG 0\n";
const std::string lethe = "p_x; p_y; p_z; v_x; v_y; v_z; w_x; w_y; w_z; diameters;\n"
                          "0.0; 0.0; 0.0; 0.0; 0.0; 0.0; 0.0; 0.0; 0.0;       0.2;\n"
                          "1.0; 2.0; 3.0; 0.0; 0.0; 0.0; 0.0; 0.0; 0.0;       .3;\n";
const std::string kratos =
    "Begin ModelPartData\n// VARIABLE_NAME value\nEnd ModelPartData\n\n"
    "Begin Properties 0\nEnd Properties\n\n"
    "Begin Nodes // of spheres\n 7 0 0 0.5\n9 -1e-3 0 2\nEnd Nodes\n\n"
    "Begin Elements SphericParticle3D// GUI group identifier: DEM\n1 0 7\n2 0 9\nEnd Elements\n\n"
    "Begin NodalData RADIUS // GUI group\n7 0 0.5\n9 0 0.25\nEnd NodalData\n\n"
    "Begin SubModelPart grains\n  Begin SubModelPartNodes\n  7\n  End SubModelPartNodes\n"
    "End SubModelPart\n";

} // namespace

TEST_CASE("ESyS-Particle: radii of a geometry and of a snapshot, in m") {
  for (const std::string &content : {geometry, snapshot}) {
    const Result result = read(content);
    CHECK(result.format == ParticleFormat::esys);
    CHECK(result.particles == "1000 500");
    REQUIRE(result.notes.size() == 1);
    CHECK(contains(result.notes[0], "radii in m"));
    ParticleOptions options;
    options.unit = SizeUnit::mm;
    CHECK(read(content, options).particles == "1 0.5");
  }
}

TEST_CASE("ESyS-Particle: what is damaged is refused with its line") {
  CHECK(contains(refusal(replaced(geometry, "1 1 1 0.5", "1 1 1 0")), "file:8: radius '0' is not above 0"));
  CHECK(contains(refusal(replaced(geometry, "1 1 1 0.5", "1 1 1 nan")), "file:8: 'nan' is not a number"));
  CHECK(contains(refusal(replaced(geometry, "1 1 1 0.5", "1 inf 1 1")), "file:8: 'inf' is not a number"));
  CHECK(contains(refusal(replaced(geometry, "\n2\n", "\n3\n")), "file:10: the line has 1 numbers"));
  CHECK(
      contains(refusal(replaced(geometry, "\n2\n", "\n1\n")), "file:9: there are more particles than the 1"));
  CHECK(contains(refusal(replaced(geometry, "\n2\n", "\ntwo\n")), "file:7: the number of particles is not"));
  CHECK(contains(refusal(replaced(geometry, "0.5 0 3", "0.5 0")), "file:8: the line has 5 numbers"));
  CHECK(contains(refusal(replaced(snapshot, "2\n", "1\n")), "file:3: there are more particles than the 1"));
  CHECK(contains(refusal(replaced(snapshot, "2\n", "3\n")), "file:4: the line has 1 numbers"));
  CHECK(contains(refusal("2\n1 1 1 0.5 0 3 0.52\n"), "file:2: the file ends after 1 of 2 particles"));
  CHECK(contains(refusal("0\n", from(ParticleFormat::esys)), "there are no particles"));
  const std::string upto = geometry.substr(0, geometry.find("EndParticles") + 13);
  check_truncations(upto, from(ParticleFormat::esys));
}

TEST_CASE("Lethe: diameters of an insertion file, found by its names") {
  CHECK(read(lethe).format == ParticleFormat::lethe);
  CHECK(read(lethe).particles == "200 300");
  CHECK(read("p_x; p_y; p_z; v_x; v_y; v_z; w_x; w_y; w_z; diameters; fem_force_x;\n"
             "0;0;0;0;0;0;0;0;0;1e-3;5\n")
            .particles == "1");
  CHECK(contains(refusal(replaced(lethe, "diameters", "diam")), "file:1: there is not one column diameters"));
  CHECK(contains(refusal(replaced(lethe, "v_x", "p_x")), "file:1: there is not one column p_x"));
  CHECK(
      contains(refusal(replaced(lethe, "0.2;", "")), "file:2: the line has 9 values, there are 10 columns"));
  CHECK(contains(refusal(replaced(lethe, ".3;", "-.3;")), "file:3: diameter '-.3' is not above 0"));
  CHECK(contains(refusal(replaced(lethe, "2.0;", "nan;")), "file:3: 'nan' is not a number"));
  CHECK(contains(refusal(lethe.substr(0, lethe.find('\n') + 1)), "there are no particles"));
}

TEST_CASE("Kratos: radii of the nodes of a model part") {
  CHECK(read(kratos).format == ParticleFormat::kratos);
  CHECK(read(kratos).particles == "1000 500");
  CHECK(contains(refusal(replaced(kratos, "9 0 0.25\n", "")),
                 "there are 2 particles among the Elements, and 1"));
  CHECK(contains(refusal(replaced(kratos, "9 0 0.25", "8 0 0.25")), "there is no node 8"));
  CHECK(contains(refusal(replaced(kratos, "9 0 0.25", "7 0 0.25")), "node 7 has a radius above"));
  CHECK(contains(refusal(replaced(kratos, "9 0 0.25", "9 0 0")), "radius '0' is not above 0"));
  CHECK(contains(refusal(replaced(kratos, "9 -1e-3", "9 nan")), "is not a node's number with x y z"));
  CHECK(contains(refusal(replaced(kratos, "1 0 7", "1 0")), "is not a particle's number, its properties"));
  CHECK(contains(refusal(replaced(kratos, "2 0 9", "2 0 x")), "the number of a node is not a whole number"));
  CHECK(contains(refusal(kratos.substr(0, kratos.find("End NodalData"))), "without its End: is it cut off?"));
  CHECK(contains(refusal("Begin Nodes\nEnd Nodes\nEnd Nodes\n"), "a block ends that did not begin"));
}

TEST_CASE("DEM-Engine: radii of spheres, and of clumps by the names of their types") {
  const std::string clumps = "X,Y,Z,Qw,Qx,Qy,Qz,clump_type\n1,2,3,1,0,0,0,r0.5\n1,2,5e0,1,0,0,0,r2.5e-1\n";
  const std::string spheres = "X,Y,Z,r,absv\n1,2,3,0.5,0\n1,2,5,.25,0\n";
  for (const std::string &content : {clumps, spheres}) {
    CHECK(read(content).format == ParticleFormat::dem_engine);
    CHECK(read(content).particles == "1000 500");
    REQUIRE(read(content).notes.size() == 1);
    CHECK(read(content).notes.front() == "The sizes were taken as radii in m.");
  }
  CHECK(contains(refusal(replaced(clumps, "r0.5", "0001")),
                 "file:2: clump_type '0001' does not tell a radius"));
  CHECK(contains(refusal(replaced(clumps, "r0.5", "rock")), "clump_type 'rock' does not tell a radius"));
  CHECK(contains(refusal(replaced(clumps, "r0.5", "r-1")), "file:2: radius '-1' is not above 0"));
  CHECK(contains(refusal(replaced(clumps, "clump_type", "type")), "there is not one column clump_type"));
  CHECK(contains(refusal(replaced(clumps, "Qw", "X")), "file:1: there is not one column X"));
  CHECK(
      contains(refusal(replaced(clumps, ",r2.5e-1", "")), "file:3: the row has 7 fields, and the header 8"));
  CHECK(contains(refusal(replaced(spheres, "1,2,5,", "1,2,nan,")), "file:3: 'nan' is not a number"));
  CHECK(contains(refusal(replaced(spheres, "1,2,5,", "1,2,\"5,")), "file:3: a quoted field does not end"));
  CHECK(contains(refusal(clumps.substr(0, clumps.find('\n') + 1)), "there are no particles"));
}

TEST_CASE("MUSEN: radii of the spheres of a scene as text, at their last time") {
  const std::string scene =
      "0 0 1 14 5  23 KEY 24 0 1e+300 2 0 12 0 0 0 15 0 0 0 16 1 1 1 18 0 20 0 0 0 31 2 2 2 0\n"
      "0 1 1 1 5 0.5 0.5 23 KEY 24 0 1e+300 2 0 12 0 0 .5 15 0 0 0 18 0 36 0 0 0 0 0 0 0 0 0 2 1 12 0 0 1\n"
      "0 2 1 1 5 0.25 0.3 23 KEY 24 0 1e+300 2 0 12 0 0 3 2 1 12 0 0 2.5\n"
      "22 -1 -1 -1 1 1 5\n32 KEY Glass 0 2500 7 5e+10\n33 KEY KEY 200 0.9\n";
  CHECK(read(scene).format == ParticleFormat::musen);
  CHECK(read(scene).particles == "1000 500");
  CHECK(read(replaced(scene, "0.3 23 KEY 24 0 1e+300", "0.3 23 KEY 24 0 0.5")).particles == "1000");
  CHECK(read(replaced(scene, "0.3 23 KEY 24 0 1e+300", "0.3 23 KEY 24 1.5 2")).particles == "1000");
  CHECK(read("0 1 1 1 5 0.5 0.5 23 KEY\n").particles == "1000");
  CHECK(contains(refusal(replaced(scene, "0.25 0.3", "0 0.3")), "file:3: radius '0' is not above 0"));
  CHECK(contains(refusal(replaced(scene, "0 2 1 1 5", "0 2 1 1 23")), "file:3: there is '23' and not 5"));
  CHECK(contains(refusal(replaced(scene, "18 0 36", "99 0 36")), "file:2: 99 is no property of a sphere"));
  CHECK(contains(refusal(replaced(scene, "12 0 0 2.5", "12 0 0")), "file:3: the line ends inside an object"));
  CHECK(contains(refusal(replaced(scene, "12 0 0 2.5", "12 0 0 x")), "file:3: 'x' is not a number"));
  CHECK(contains(refusal(replaced(scene, "1 1 5 0.25", "1 x 5 0.25")),
                 "the type of an object 'x' is not a whole"));
  CHECK(contains(refusal(scene.substr(0, scene.find('\n') + 1)), "there are no particles"));
  CHECK(read("0 0 1 1 5 7\n").format == ParticleFormat::xyzr);
}

TEST_CASE("PFC: balls in CSV with its column names") {
  const std::string balls =
      "EVENT_LABEL,PFC_BALL_LOCX,PFC_BALL_LOCY,PFC_BALL_LOCZ,PFC_BALL_RADIUS,PFC_BALL_ATTR\n"
      "1,0,0,0.1,0.5,1\n2,3,0,0.1,0.25,1\n";
  CHECK(read(balls).format == ParticleFormat::csv);
  CHECK(read(balls).particles == "1000 500"); // m, as mdm export writes them
  CHECK(contains(read(balls).notes.at(0), "radii in m"));
  ParticleOptions options;
  options.unit = SizeUnit::mm;
  CHECK(read(balls, options).particles == "1 0.5");
  CHECK(contains(refusal(replaced(balls, "0.25,1", "0.25")), "file:3: the row has 5 fields"));
}

TEST_CASE("PhasicFlow: the sizes of a particlesDict, by their ranges") {
  const std::string dict = "// sand\nobjectName particlesDict;\nsetFields\n{\n"
                           "    // diameter 0.002\n    selector1\n    {\n"
                           "      stridedRangeInfo { begin 0; end 3; stride 1; }\n    }\n"
                           "    // diameter 1e-3\n      stridedRangeInfo { begin 3; end 10; stride 1; }\n}\n";
  CHECK(read(dict).format == ParticleFormat::phasicflow);
  CHECK(read(dict).particles == "2*3 1*7");
  CHECK(contains(refusal(replaced(dict, "begin 3;", "begin 4;")), "file:11: the range is not one from 3 on"));
  CHECK(contains(refusal(replaced(dict, "end 10;", "end 3;")), "file:11: the range is not one from 3 on"));
  CHECK(contains(refusal(replaced(dict, "end 3;", "end x;")), "file:8: the range is not one from 0 on"));
  CHECK(
      contains(refusal(replaced(dict, "stride 1; }\n    }", "stride 2; }\n    }")), "file:8: the range is"));
  CHECK(contains(refusal(replaced(dict, "// diameter 0.002", "")), "file:8: the range is not one from 0 on"));
  CHECK(contains(refusal(replaced(dict, "0.002", "-1")), "file:8: diameter '-1' is not above 0"));
  CHECK(contains(refusal(dict.substr(0, dict.rfind("stridedRangeInfo"))),
                 "the range of diameter '1e-3' is missing"));
  CHECK(contains(refusal("objectName particlesDict;\n"), "there are no particles"));
}

} // namespace engine_formats_test
