// Names of ISO 14688-2:2004, beside the corners of the fields of its diagram (Annex B, Figure B.1), and at
// limits.

#include "catch.hpp"
#include "soil.hpp"
#include "soil/iso_14688.hpp"

#include <array>
#include <set>

namespace iso_14688_test {

using namespace mdm;
using grading_test::curve;

namespace {

/// Percents of fines, sand and gravel.
using Place = std::array<int, 3>;

/// A field of the triangle; a corner at 42 stands for one at 42.5. What fines are
/// called in it: as a noun (N), silty or clayey (A), or not at all.
struct Field {
  std::vector<Place> corners;
  char fines;
  std::string before, after; ///< the symbol of the fines
};

const std::vector<Field> fields = {
    {{{100, 0, 0}, {80, 20, 0}, {60, 20, 20}, {80, 0, 20}}, 'N', "", ""},
    {{{80, 20, 0}, {40, 60, 0}, {40, 40, 20}, {60, 20, 20}}, 'N', "sa", ""},
    {{{80, 0, 20}, {60, 20, 20}, {40, 20, 40}, {40, 0, 60}}, 'N', "gr", ""},
    {{{60, 20, 20}, {40, 40, 20}, {40, 30, 30}}, 'N', "grsa", ""},
    {{{60, 20, 20}, {40, 30, 30}, {40, 20, 40}}, 'N', "sagr", ""},
    {{{40, 0, 60}, {40, 20, 40}, {15, 20, 65}, {15, 0, 85}}, 'A', "", "Gr"},
    {{{40, 60, 0}, {15, 85, 0}, {15, 65, 20}, {40, 40, 20}}, 'A', "", "Sa"},
    {{{40, 20, 40}, {20, 40, 40}, {15, 42, 42}, {15, 20, 65}}, 'A', "sa", "Gr"},
    {{{40, 40, 20}, {15, 65, 20}, {15, 42, 42}, {20, 40, 40}}, 'A', "gr", "Sa"},
    {{{40, 40, 20}, {20, 40, 40}, {40, 30, 30}}, 'A', "grsa", "S"},
    {{{40, 30, 30}, {20, 40, 40}, {40, 20, 40}}, 'A', "sagr", "S"},
    {{{15, 85, 0}, {0, 100, 0}, {0, 80, 20}, {15, 65, 20}}, '-', "", "Sa"},
    {{{15, 20, 65}, {0, 20, 80}, {0, 0, 100}, {15, 0, 85}}, '-', "", "Gr"},
    {{{15, 65, 20}, {0, 80, 20}, {0, 50, 50}, {15, 42, 42}}, '-', "gr", "Sa"},
    {{{15, 42, 42}, {0, 50, 50}, {0, 20, 80}, {15, 20, 65}}, '-', "sa", "Gr"}};

/// Twice a corner: 42 stands for 42.5.
std::array<int, 2> doubled(const Place &corner) {
  return {2 * corner[0], corner[1] == 42 ? 85 : 2 * corner[1]};
}

/// True if the field, which is convex, holds the place, its border included.
bool holds(const Field &field, const Place &place) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < field.corners.size(); ++i) {
    const auto a = doubled(field.corners[i]), b = doubled(field.corners[(i + 1) % field.corners.size()]);
    const std::array<int, 2> p = {2 * place[0], 2 * place[1]};
    const int turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    left += turn >= 0;
    right += turn <= 0;
  }
  const int sides = static_cast<int>(field.corners.size());
  return left == sides || right == sides;
}

/// The symbol of a field where clay is this part of the fines; "-" where the diagram has none.
std::string symbol_in(const Field &field, int clay_of_fines) {
  if (field.fines == 'A')
    return field.before + (clay_of_fines < 20 ? "si" : "cl") + field.after;
  if (field.fines == '-')
    return field.before + field.after;
  const std::string noun = clay_of_fines < 10   ? "Si"
                           : clay_of_fines < 20 ? "clSi"
                           : clay_of_fines < 40 ? "siCl"
                                                : "Cl";
  return field.before.size() == 4 && noun.size() == 4 ? "-" : field.before + noun;
}

/// Clay in percent of the fines.
Available<Iso14688Name> name_of(const Place &place, int clay_of_fines) {
  const int clay = place[0] * clay_of_fines;
  return iso_14688_name(curve({{"0.0001", "0"},
                               {"0.002", std::to_string(clay / 100) + "." + (clay % 100 < 10 ? "0" : "") +
                                             std::to_string(clay % 100)},
                               {"0.063", std::to_string(place[0])},
                               {"2", std::to_string(place[0] + place[1])},
                               {"63", "100"}}));
}

std::string symbol_of(const Place &place, int clay_of_fines) {
  const Available<Iso14688Name> name = name_of(place, clay_of_fines);
  return name ? name->symbol : "-";
}

} // namespace

TEST_CASE("names of ISO 14688-2 are those of the fields of its diagram", "[iso_14688]") {
  unsigned inside = 0;
  for (const int clay_of_fines : {0, 9, 10, 19, 20, 39, 40, 100})
    for (int fines = 0; fines <= 100; ++fines)
      for (int sand = 0; fines + sand <= 100; ++sand) {
        const Place place = {fines, sand, 100 - fines - sand};
        CAPTURE(clay_of_fines, place);
        const std::string symbol = symbol_of(place, clay_of_fines);
        std::set<std::string> possible;
        for (const Field &field : fields)
          if (holds(field, place))
            possible.insert(symbol_in(field, clay_of_fines));
        inside += possible.size() == 1;
        CHECK(possible.count(symbol) == 1);
      }
  CHECK(inside > 8 * 4000);
}

TEST_CASE("names of ISO 14688-2 at a limit are those above it", "[iso_14688]") {
  CHECK(symbol_of({0, 20, 80}, 0) == "saGr");
  CHECK(symbol_of({0, 19, 81}, 0) == "Gr");
  CHECK(symbol_of({0, 50, 50}, 0) == "saGr"); // of equal ones gravel is the noun
  CHECK(symbol_of({14, 86, 0}, 100) == "Sa");
  CHECK(symbol_of({15, 85, 0}, 20) == "clSa");
  CHECK(symbol_of({15, 85, 0}, 19) == "siSa");
  CHECK(symbol_of({40, 60, 0}, 10) == "saclSi");
  CHECK(symbol_of({20, 40, 40}, 0) == "sasiGr");
  CHECK(symbol_of({40, 30, 30}, 0) == "sagrSi");
}

TEST_CASE("a name of ISO 14688-2 is also in words", "[iso_14688]") {
  CHECK(name_of({10, 30, 60}, 0)->words == "sandy gravel");
  CHECK(name_of({60, 30, 10}, 30)->words == "sandy silty clay");
  CHECK(name_of({35, 35, 30}, 50)->words == "gravelly sandy clayey soil");
}

TEST_CASE("cobbles are left out of a name of ISO 14688-2", "[iso_14688]") {
  const auto name = iso_14688_name(curve({{"0.063", "0"}, {"2", "15"}, {"63", "50"}, {"200", "100"}}));
  CHECK(name->symbol == "saGr"); // 30 % of sand, 70 % of gravel
  CHECK_FALSE(iso_14688_name(curve({{"63", "0"}, {"200", "100"}})));
}

TEST_CASE("a name of ISO 14688-2 needs clay only where fines are named", "[iso_14688]") {
  CHECK(iso_14688_name(curve({{"0", "0"}, {"0.063", "14"}, {"2", "100"}}))->symbol == "Sa");
  CHECK(iso_14688_name(curve({{"0", "0"}, {"0.063", "15"}, {"2", "100"}})).why().reason ==
        "below 0.063 mm, the finest sieve");
  CHECK_FALSE(iso_14688_name(curve({{"0", "0"}, {"0.125", "15"}, {"2", "100"}})));
}

} // namespace iso_14688_test
