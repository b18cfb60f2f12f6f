// VTK's XML, as LIGGGHTS and ParaView write points.

#include "files.hpp"
#include "replaced.hpp"
#include "support.hpp"

namespace vtp_test {

using namespace mdm;
using namespace mdm::test;
using mdm_test::replaced;

namespace {

std::string points() {
  return mdm_test::read_file(std::string(MDM_SOURCE_DIR) + "/tests/fuzz/particles/points.vtp");
}

/// The message that refuses the points with a change.
std::string broken(const std::string &part, const std::string &by) {
  return refusal(replaced(points(), part, by), from(ParticleFormat::vtp));
}

} // namespace

TEST_CASE("VTK's XML: the radii of the points, told by the content") {
  const Result result = read(points());
  CHECK(result.format == ParticleFormat::vtp);
  CHECK(result.particles == "1 2");
  CHECK(contains(result.notes.at(0), "m"));
  const std::string one_line = "<VTKFile type='UnstructuredGrid'><UnstructuredGrid><Piece NumberOfPoints='1'>"
                               "<PointData><DataArray Name='diameter' format='ascii'>0.003</DataArray>"
                               "</PointData><Points><DataArray format='ascii'>0 0 0</DataArray></Points>"
                               "</Piece></UnstructuredGrid></VTKFile>";
  CHECK(read(one_line).particles == "3");
}

TEST_CASE("VTK's XML: the pieces of several processes") {
  const std::string all = points(), begin = "    <Piece", end = "    </Piece>\n";
  const std::string piece = all.substr(all.find(begin), all.find(end) + end.size() - all.find(begin));
  const std::string other =
      replaced(replaced(piece, "          1 2\n", "          3 4\n"), "0.0005 0.001\n", "2 3\n");
  CHECK(read(replaced(all, piece, piece + "<Piece NumberOfPoints='0'></Piece>\n" + other)).particles ==
        "1 2 4000 6000");
  CHECK(contains(refusal(replaced(all, piece, piece + piece)), "id 1"));
}

TEST_CASE("VTK's XML: radii and diameters agree, or one is named") {
  const std::string radius = "<DataArray type=\"Float64\" Name=\"radius\"";
  const auto with_diameters = [&](const std::string &numbers) {
    return replaced(points(), radius,
                    "<DataArray Name=\"diameter\" format=\"ascii\">" + numbers + "</DataArray>\n" + radius);
  };
  CHECK(read(with_diameters("0.001 0.002")).particles == "1 2");
  CHECK(contains(refusal(with_diameters("0.001 0.003")), "file:"));
  ParticleOptions options;
  options.meaning = SizeMeaning::radius;
  CHECK(contains(refusal(with_diameters("0.001 0.002"), options), "--radius and --diameter choose none"));
  options.size_column = "c_r";
  const std::string named = replaced(points(), "Name=\"radius\"", "Name=\"c_r\"");
  CHECK(read(named, options).particles == "1 2");
  CHECK(contains(refusal(named), "file:4: the points of the piece have no array radius or diameter"));
}

TEST_CASE("VTK's XML: broken files") {
  CHECK(contains(broken("0.0005 0.001\n", "0.0005\n"),
                 "file:12: the array 'radius' has 1 numbers, and 2 points have 2"));
  CHECK(contains(broken("0.005 0.006\n", "0.005\n"), "file:17: the array 'Points' has 5 numbers"));
  CHECK(contains(broken("0.0005 0.001\n", "0.0005 nan\n"), "file:12: "));
  CHECK(contains(broken("          1 2\n", "          1 1\n"), "id 1"));
  CHECK(contains(broken("\"Points\" NumberOfComponents=\"3\" format=\"ascii\"",
                        "\"Points\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\""),
                 "file:17: the array 'Points' is not ASCII: write the file with the data mode Ascii"));
  CHECK(contains(broken("NumberOfPoints=\"2\"", "NumberOfPoints=\"two\""), "file:4: the piece has no"));
  CHECK(contains(broken("<VTKFile type=\"PolyData\"", "<VTKFile type=\"ImageData\""), "file:2: it is not"));
  CHECK(contains(broken("Name=\"type\"", "Name=\"id\""), "file:9: there are several arrays 'id'"));
  CHECK(contains(refusal("<VTKFile type='PolyData'><PolyData/></VTKFile>\n"), "there are no particles"));
  check_truncations(points(), from(ParticleFormat::vtp));
}

} // namespace vtp_test
