// Specifications, of files and those that come with the program.

#include "catch.hpp"

#include <mdm/judge/specification.hpp>

using namespace mdm;

TEST_CASE("every specification that comes with the program can be read and says its source",
          "[specification]") {
  const std::vector<std::string> names = shipped_specifications();
  CHECK(names.size() == 8);
  for (const std::string &name : names) {
    INFO(name);
    const std::optional<Specification> s = shipped_specification(name);
    REQUIRE(s);
    CHECK(s->id == name);
    REQUIRE_FALSE(s->about.empty());
    CHECK((s->about.front().find("ASTM") != std::string::npos ||
           s->about.front().find("AASHTO") != std::string::npos));
    CHECK(s->sieves.back().least == 100);
  }
  CHECK_FALSE(shipped_specification("no-such"));
}

TEST_CASE("ASTM C33 has its limits for fine aggregate", "[specification]") {
  const Specification s = *shipped_specification("astm-c33-fine");
  REQUIRE(s.sieves.size() == 7);
  CHECK(s.sieves[0].size == ratio(15, 100));
  CHECK(s.sieves[0].most == 10);
  CHECK(s.sieves[3].size == ratio(118, 100));
  CHECK(s.sieves[3].least == 50);
  CHECK(s.sieves[3].most == 85);
}

TEST_CASE("limits are in mm, whatever unit the file has", "[specification]") {
  const Specification s = read_specification(
      "# a road\n#  2020\nsize_um,passing_min_percent,passing_max_percent\n75,2,8\n", "road.csv");
  CHECK(s.id == "road");
  CHECK(s.about == std::vector<std::string>{"a road", "2020"});
  CHECK(s.sieves.front().size == ratio(75, 1000));
}

TEST_CASE("limits that no curve keeps are refused", "[specification]") {
  CHECK_THROWS_WITH(
      read_specification("size_mm,passing_min_percent,passing_max_percent\n1,60,70\n2,0,50\n", "limits.csv"),
      Catch::Contains("limits.csv: no curve keeps these limits") && Catch::Contains("at least 60 percent"));
  CHECK_THROWS_WITH(
      read_specification("size_mm,passing_min_percent,passing_max_percent\n1,60,50\n", "limits.csv"),
      Catch::Contains("no curve keeps"));
}
