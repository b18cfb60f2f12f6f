// The textures of Shepard and of the USDA, beside their definitions class by class. Folk's are tested with
// the sediment.

#include "catch.hpp"
#include "soil.hpp"
#include "soil/texture.hpp"

namespace texture_test {

using namespace mdm;
using grading_test::curve;

namespace {

std::string shepard(int sand, int silt, int clay) {
  return *texture(TextureSystem::shepard, curve({{"0.0001", "0"},
                                                 {"0.00390625", std::to_string(clay)},
                                                 {"0.0625", std::to_string(clay + silt)},
                                                 {"2", std::to_string(clay + silt + sand)}}));
}

/// Of percents of all, as much coarser than 2 mm as is left.
Available<std::string> usda(int sand, int silt, int clay) {
  return texture(TextureSystem::usda, curve({{"0.0001", "0"},
                                             {"0.002", std::to_string(clay)},
                                             {"0.05", std::to_string(clay + silt)},
                                             {"2", std::to_string(clay + silt + sand)},
                                             {"64", "100"}}));
}

/// The Soil Survey Manual, class by class; of two that meet the first.
std::string by_manual(int sand, int silt, int clay) {
  const int fine = 2 * silt + 3 * clay, fines = silt + 2 * clay; // twice silt + 1.5 clay
  if (fine < 30)
    return "sand";
  if (fine >= 30 && fines < 30)
    return "loamy sand";
  if ((clay >= 7 && clay < 20 && sand > 52 && fines >= 30) || (clay < 7 && silt < 50 && fines >= 30))
    return "sandy loam";
  if (clay >= 7 && clay < 27 && silt >= 28 && silt < 50 && sand <= 52)
    return "loam";
  if ((silt >= 50 && clay >= 12 && clay < 27) || (silt >= 50 && silt < 80 && clay < 12))
    return "silt loam";
  if (silt >= 80 && clay < 12)
    return "silt";
  if (clay >= 20 && clay < 35 && silt < 28 && sand > 45)
    return "sandy clay loam";
  if (clay >= 27 && clay < 40 && sand > 20 && sand <= 45)
    return "clay loam";
  if (clay >= 27 && clay < 40 && sand <= 20)
    return "silty clay loam";
  if (clay >= 35 && sand > 45)
    return "sandy clay";
  if (clay >= 40 && silt >= 40)
    return "silty clay";
  return clay >= 40 && sand <= 45 && silt < 40 ? "clay" : "none";
}

} // namespace

TEST_CASE("textures of the USDA are those of its manual", "[texture]") {
  for (int clay = 0; clay <= 100; ++clay)
    for (int silt = 0; clay + silt <= 100; ++silt) {
      CAPTURE(clay, silt);
      CHECK(*usda(100 - clay - silt, silt, clay) == by_manual(100 - clay - silt, silt, clay));
    }
}

TEST_CASE("textures of the USDA leave out what is coarser than sand", "[texture]") {
  CHECK(*usda(20, 20, 10) == "loam"); // 40, 40, 20 percent of it
  CHECK(*usda(9, 0, 1) == "loamy sand");
  CHECK_FALSE(usda(0, 0, 0));
}

TEST_CASE("textures of Shepard, at their limits too", "[texture]") {
  CHECK(shepard(75, 15, 10) == "sand");
  CHECK(shepard(74, 16, 10) == "silty sand");
  CHECK(shepard(10, 15, 75) == "clay");
  CHECK(shepard(10, 75, 15) == "silt");
  CHECK(shepard(20, 20, 60) == "sand-silt-clay");
  CHECK(shepard(19, 21, 60) == "silty clay");
  CHECK(shepard(21, 19, 60) == "sandy clay");
  CHECK(shepard(60, 21, 19) == "silty sand");
  CHECK(shepard(60, 19, 21) == "clayey sand");
  CHECK(shepard(45, 50, 5) == "sandy silt");
  CHECK(shepard(5, 50, 45) == "clayey silt");
  CHECK(shepard(50, 50, 0) == "silty sand"); // of equal ones the coarser is the noun
}

TEST_CASE("a texture is not available where a pan hides a share", "[texture]") {
  const GradingCurve sand = curve({{"0", "0"}, {"0.0625", "10"}, {"2", "100"}});
  CHECK(*texture(TextureSystem::folk, sand) == "sand"); // nine times the mud
  CHECK_FALSE(texture(TextureSystem::shepard, sand));
  CHECK(texture(TextureSystem::usda, sand).why().reason == "below 0.0625 mm, the finest sieve");
}

} // namespace texture_test
