// Table 1 of Arnold's paper comes out of its 2,750 gradations.

#include "catch.hpp"
#include "soil/indices.hpp"
#include "soil/uscs.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <fstream>
#include <map>

namespace suite_test {

using namespace mdm;

namespace {

/// The least and the largest of many values.
struct Range {
  std::optional<Real> least, most;

  void add(const Real &y) {
    if (!least || compare(y, *least) == Order::less)
      least = y;
    if (!most || compare(y, *most) == Order::greater)
      most = y;
  }
  std::string text() const { return rounded(*least, 3) + " to " + rounded(*most, 4); }
};

} // namespace

TEST_CASE("Table 1") {
  std::ifstream suite(MDM_SUITE);
  REQUIRE(suite);
  Range c_u, c_c, i_gs, i_c, smallest_class;
  std::map<std::string, int> groups;
  int count = 0;
  for (std::string line; std::getline(suite, line); ++count) {
    const GradingCurve curve(read_json_gradation(line, "suite", ""));
    c_u.add(uniformity(curve)->real());
    c_c.add(curvature(curve)->real());
    i_gs.add(*grain_size_index(curve));
    i_c.add(*curvature_index(curve));
    smallest_class.add(Real(curve.mass(0) * 100));
    ++groups[classify_uscs(curve)->symbol];
  }
  CHECK(count == 2750);
  CHECK(c_u.text() == "1.17 to 214.5");
  CHECK(c_c.text() == "0.200 to 25.47");
  CHECK(i_gs.text() == "0.0349 to 0.6000");
  CHECK(i_c.text() == "0.293 to 1.574");
  // The paper's "percent fines", rounded there to 0.4 and 34.
  CHECK(smallest_class.text() == "0.432 to 34.41");
  CHECK(groups == std::map<std::string, int>{{"GP", 874},
                                             {"GP-GM", 3},
                                             {"GW", 578},
                                             {"GW-GM", 3},
                                             {"SM", 14},
                                             {"SP", 867},
                                             {"SP-SM", 90},
                                             {"SW", 280},
                                             {"SW-SM", 41}});
}

} // namespace suite_test
