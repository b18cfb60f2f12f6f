#include "support.hpp"

namespace write_gradation_test {

using namespace mdm;
using namespace mdm::test;

namespace {
const Reading rounded_phi{.phi = PhiReading::rounded};
} // namespace

TEST_CASE("Canonical CSV and JSON") {
  const Gradation g = read("sieve,passing_percent\nNo. 4,100\n\"#200\",4.10\n");
  CHECK(gradation_csv(g) == "size_mm,mass\n0,4.1\n0.075,95.9\n4.75,0\n");
  CHECK(gradation_json(g) ==
        "{\"id\": \"sand\", \"unit\": \"mm\", \"sizes\": [\"0\", \"0.075\", \"4.75\"], \"masses\": [\"4.1\", "
        "\"95.9\", \"0\"]}\n");
}

TEST_CASE("What is written reads back equal") {
  const std::vector<std::string> contents = {
      "size_um,mass,tolerance_percent,factor\n1,1,0.5,2.65\n2,0.25,0,1\n3,0,1,1\n",
      "size_m,retained_percent,factor\n1e-3,12.5,2\n2e-3,0,3\n",
      "size_phi,passing_percent\n-1,100\n0.5,40\n1000,0\n",
      "size_phi,mass\n-1000,0\n-0.5,1e400\n999.5,1e-400\n",
      "size_mm,mass\n1," + std::string(1000, '3') + "e400\n2,1." + std::string(999, '3') + "e-400\n3,0\n",
      "size_mm,mass\n1,0." + std::string(998, '0') + "1e-400\n2,1\n3,0\n"};
  for (const std::string &content : contents) {
    const Gradation g = read_gradation(content, "dir/sand.csv", rounded_phi);
    if (content.find("333") != std::string::npos) { // 1400 digits before the point
      CHECK(contains(message_of([&g] { gradation_csv(g); }), "cannot be written to a file"));
      continue;
    }
    CHECK(equal(g, read(gradation_csv(g))));
    CHECK(equal(g, read(gradation_json(g))));
  }
}

TEST_CASE("A third has no decimal and is not written") {
  Gradation::Data data;
  data.sizes = {1, 2};
  data.masses = {ratio(1, 3), 0};
  CHECK(contains(message_of([&data] { gradation_csv(Gradation(data)); }), "cannot be written to a file"));
}

TEST_CASE("Any id is written as JSON") {
  for (const std::string id : {"a \"b\" \\ c", "line\nfeed \x7F", "\xC3\xA4", "\xC2\x85\xC2\xA0", ""}) {
    Gradation::Data data;
    data.id = id;
    data.sizes = {1, 2};
    data.masses = {1, 0};
    CHECK(read_json_gradation(gradation_json(Gradation(data)), "line 1", "1").id() == id);
  }
  Gradation::Data data;
  data.id = "\xFF";
  data.sizes = {1, 2};
  data.masses = {1, 0};
  CHECK(read(gradation_json(Gradation(data))).id() == "\xEF\xBF\xBD");
}

} // namespace write_gradation_test
