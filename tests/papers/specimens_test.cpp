#include "catch.hpp"
#include "files.hpp"
#include "papers/specimens.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <sstream>

namespace specimens_test {

using namespace mdm;

namespace {

std::vector<std::string> split(const std::string &text, char at) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, at);)
    parts.push_back(part);
  return parts;
}

Gradation sand() {
  const std::string path = MDM_SOURCE_DIR "/examples/gradations/athabasca-sand.csv";
  return read_gradation(mdm_test::read_file(path), path);
}

void check_refused(const std::string &content, const std::string &part) {
  try {
    read_specimens(content, "specimens.csv");
    FAIL("accepted: " << content);
  } catch (const InputError &e) {
    CHECK(std::string(e.what()).find(part) != std::string::npos);
  }
}

} // namespace

TEST_CASE("the published specimens have 1.33 to 1.55 times the least number of particles") {
  const std::string path = MDM_SOURCE_DIR "/examples/specimens/zeraati-2025.csv";
  const std::vector<Specimen> specimens = read_specimens(mdm_test::read_file(path), path);
  REQUIRE(specimens.size() == 14);
  CHECK(least_specimen(sand(), specimens[0]) == 69221);
  for (const Specimen &s : specimens) {
    const Rational r = ratio(s.reported, least_specimen(sand(), s));
    CHECK(r > ratio(133, 100));
    CHECK(r < ratio(155, 100));
  }
  const std::vector<std::string> lines = split(specimens_csv(sand(), specimens), '\n');
  REQUIRE(lines.size() == 15);
  CHECK(lines[1] == "50,5,24.4,0.683,103075,69221,1.48907");
}

TEST_CASE("a broken table of specimens is refused with its line") {
  const std::string header = "diameter_mm,scale_factor,height_mm,void_ratio,particles\n";
  const std::string columns = "diameter_mm,scale_factor,height_mm,void_ratio,particles";
  check_refused("", "specimens.csv:1: there is no specimen: give a header row and below it a row for each: " +
                        columns);
  check_refused(header, "specimens.csv:1: there is no specimen: give a row for each: " + columns);
  check_refused("# source\ndiameter,height\n1,2\n", "specimens.csv:2: the header is not that of specimens");
  check_refused(header + "1,2,3,0.5\n", "specimens.csv:2: 4 columns");
  check_refused(header + "1,2,x,0.5,7\n", "specimens.csv:2: height_mm");
  check_refused(header + "1,0,3,0.5,7\n", "scale_factor: '0' is not positive");
  check_refused(header + "1,2,3,-0.5,7\n", "void_ratio: '-0.5' is not 0 or more");
  check_refused(header + "1,2,3,0.5,0\n", "particles: '0'");
  CHECK(read_specimens(header + "1,2,3,0,7\n", "specimens.csv").size() == 1);
}

} // namespace specimens_test
