// Specifications, of files and those that come with the program.

#include "catch.hpp"

#include <mdm/judge/specification.hpp>

#include <algorithm>
#include <array>

namespace specification_test {

using namespace mdm;

TEST_CASE("every specification that comes with the program can be read and says its source",
          "[specification]") {
  const std::vector<std::string> names = shipped_specifications();
  CHECK(names.size() == 17);
  const std::array<const char *, 4> sources = {"ASTM", "AASHTO", "EN 12620", "Iowa DOT"};
  for (const std::string &name : names) {
    INFO(name);
    const std::optional<Specification> s = shipped_specification(name);
    REQUIRE(s);
    CHECK(s->id == name);
    REQUIRE_FALSE(s->about.empty());
    CHECK(std::any_of(sources.begin(), sources.end(), [&s](const char *source) {
      return s->about.front().find(source) != std::string::npos;
    }));
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

TEST_CASE("EN 12620 has its limits for coarse aggregate at the sieves of the basic sets", "[specification]") {
  const Specification s = *shipped_specification("en12620-8-16");
  REQUIRE(s.sieves.size() == 5);
  CHECK(s.sieves[0].size == 4); // d / 2
  CHECK(s.sieves[0].most == 5);
  CHECK(s.sieves[1].most == 20);
  CHECK(s.sieves[2].least == 85);
  CHECK(s.sieves[3].size == ratio(224, 10)); // 1.4 D
  CHECK(s.sieves[3].least == 98);
  CHECK(s.sieves[4].size == ratio(315, 10)); // 2 D
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

} // namespace specification_test
