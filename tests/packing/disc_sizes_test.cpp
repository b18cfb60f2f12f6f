#include "packing/support.hpp"

#include <mdm/number/decimal.hpp>

namespace disc_sizes_test {

using namespace mdm;
using namespace packing_test;

namespace {

const std::string head = "class,size_lo,size_hi\n";

std::string set(const std::string &sizes, const std::string &dimension = "2") {
  return R"({"schema":"mdm-generate-1","unit":"mm","dimension":")" + dimension + R"(","sizes":)" + sizes +
         "}";
}

} // namespace

TEST_CASE("sizes are read from the CSV and the JSON of a set") {
  const DiscSizes csv = read_disc_sizes(head + "1,1.249,1.25\n2,3,3\n", "a.csv");
  CHECK(csv.sizes == std::vector<DiscSize>{{125, 2}, {3, 0}});
  CHECK(csv.unit.empty());
  const DiscSizes json = read_disc_sizes(set(R"([["1.249","1.25"],"3","4/3"])"), "a.json");
  CHECK(json.unit == "mm");
  REQUIRE(json.sizes.size() == 3);
  CHECK(json.sizes[0] == DiscSize{125, 2});
  CHECK(json.sizes[2] == DiscSize{133333333333334, 14});
}

TEST_CASE("files of sizes are told from others") {
  CHECK(has_disc_sizes(head));
  CHECK(has_disc_sizes(set("[]")));
  CHECK_FALSE(has_disc_sizes("size_mm,mass\n1,2\n"));
  CHECK_FALSE(has_disc_sizes(R"({"id":"a","sizes":["1"]})"));
  CHECK_FALSE(has_disc_sizes(""));
}

TEST_CASE("sizes that cannot be packed are refused") {
  const auto refused = [](const std::string &text, const std::string &what) {
    CHECK(has(refusal([&] { read_disc_sizes(text, "a"); }), what));
  };
  refused(head, "no size");
  refused(head + "1,0,0\n", "a:2: ");
  refused(head + "1,2,1\n", "a:2: ");
  refused(head + "1,2\n", "a:2: ");
  refused(head + "1,1,1\n1,x,2\n", "a:3: ");
  refused(head + "1,1e18,1e18\n", "below 10^18");
  refused(set("[]"), "no size");
  refused(set(R"(["1"])", "3"), "spheres");
  refused(set(R"(["-1"])"), "above 0");
  refused(set(R"(["1/0"])"), "fraction");
  refused(set(R"([{}])"), "mdm-generate-1");
  refused(set("7"), "a: ");
}

TEST_CASE("radii are half the sizes, rounded up to the lattice") {
  CHECK(DiscSizes::radius({125, 2}, 3) == 625);
  CHECK(DiscSizes::radius({125, 2}, 2) == 63);
  CHECK(DiscSizes::radius({125, 2}, 0) == 1);
  CHECK(DiscSizes::radius({3, 0}, 1) == 15);
  CHECK_THROWS_AS(DiscSizes::radius({3, 0}, 40), InputError);
}

} // namespace disc_sizes_test
