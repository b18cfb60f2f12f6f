// Matches written for DEM codes by the library's public function.

#include "catch.hpp"

#include <mdm/ask/export.hpp>
#include <mdm/ask/verify.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <sstream>

namespace export_test {

using namespace mdm;

namespace {

Gradation sand() {
  return gradation_of({"1", "2", "3"}, {"2", "1", "0"});
}

} // namespace

TEST_CASE("a match is written in every format that is one file") {
  const Match match = solve(sand());
  const std::vector<std::string> formats = export_formats();
  CHECK(std::count(formats.begin(), formats.end(), "lammps") == 1);
  CHECK(std::count(formats.begin(), formats.end(), "phasicflow") == 0);
  for (const std::string &format : formats) {
    INFO(format);
    std::ostringstream out;
    export_particles(match, format, out);
    CHECK_FALSE(out.str().empty());
  }
}

TEST_CASE("what was written for a code matches within the rounding of its numbers") {
  for (const char *const format : {"lammps", "yade", "vtk", "csv"}) {
    INFO(format);
    std::stringstream file;
    ExportOptions options;
    options.unit = SizeUnit::m;
    export_particles(solve(sand()), format, file, options);
    Question asked;
    asked.tolerances = {parse_tolerance("retained:0.000001%")};
    SampleVerifier verifier(sand(), asked);
    verifier.read(file, "written", std::string(format) == "csv" ? std::nullopt : std::optional(SizeUnit::m));
    CHECK(verifier.verdict().is_match == true);
  }
}

TEST_CASE("an export that cannot be is refused") {
  const Match match = solve(sand());
  std::ostringstream out;
  CHECK_THROWS_WITH(export_particles(match, "lamps", out), Catch::Contains("use one of"));
  CHECK_THROWS_WITH(export_particles(match, "phasicflow", out), Catch::Contains("mdm export"));
  ExportOptions options;
  options.density = 0;
  CHECK_THROWS_AS(export_particles(match, "lammps", out, options), InputError);
  SolveOptions few;
  few.at_most = 1;
  Match none = solve(sand(), {}, few);
  none.sample.reset();
  CHECK_THROWS_WITH(export_particles(none, "csv", out), Catch::Contains("no match is known"));
  CHECK(out.str().empty());
}

} // namespace export_test
