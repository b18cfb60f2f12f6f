// The same gradation, written in every way, is the same gradation.

#include "support.hpp"

namespace equivalence_test {

using namespace mdm;
using namespace mdm::test;

namespace {

/// Masses divided by their sum.
std::vector<Rational> shares(const Gradation &g) {
  Rational sum = 0;
  for (const Rational &mass : g.masses())
    sum += mass;
  std::vector<Rational> all;
  for (const Rational &mass : g.masses())
    all.push_back(mass / sum);
  return all;
}

} // namespace

TEST_CASE("All columns and formats give the same sizes in mm and the same shares") {
  const std::vector<std::string> contents = {
      "size_mm,mass\n0,1\n0.5,4\n2,5\n4,0\n",
      "size_mm,retained_g\n4,0\n2,250\n0.5,200\npan,50\n",
      "size_mm;retained_percent\n0,5;40\npan;10,0\n4;0\n2;50\n",
      "sieve,retained_fraction\n2 mm,0.5\n500 um,0.4\n4 mm,0\nPan,.1\n",
      "size_phi,passing_percent\n-2,100\n-1,50\n1,10\n",
      "size_phi,passing_fraction\n-2,1\n-1,0.5\n1,0.1\npan,0\n",
      "sieve,cumulative_retained_percent\nNo. 5,0\n\"#10\",50\nTyler 32 mesh,90\n",
      "{\"sizes\":[4,2,0.5,0],\"masses\":[0,5,4,1]}",
      "{\"masses\":[\"1\",\"4\",\"5\",\"0\"],\"sizes\":[\"0\",\"0.5\",\"2\",\"4\"],\"unit\":\"mm\"}",
      "\"GROUP\",\"GRAT\"\n\"HEADING\",\"LOCA_ID\",\"GRAT_SIZE\",\"GRAT_PERP\"\n\"UNIT\",\"\",\"mm\",\"%\"\n"
      "\"DATA\",\"A\",\"4\",\"100\"\n\"DATA\",\"A\",\"2\",\"50\"\n\"DATA\",\"A\",\"0.5\",\"10\"\n"};
  for (const std::string &content : contents) {
    INFO(content);
    const Gradation g = read(content);
    CHECK(text(g.sizes()) == "0 0.5 2 4");
    CHECK(text(shares(g)) == "0.1 0.4 0.5 0");
    CHECK(equal(g, read(gradation_csv(g))));
    CHECK(equal(g, read(gradation_json(g))));
  }
}

TEST_CASE("Inches, micrometres and metres are the same sizes") {
  const Gradation mm = read("size_mm,mass\n25.4,1\n50.8,0\n");
  CHECK(read("size_in,mass\n1,1\n2,0\n").sizes() == mm.sizes());
  CHECK(read("size_um,mass\n25400,1\n50800,0\n").scaled(ratio(1, 1000)).sizes() == mm.sizes());
  CHECK(read("size_m,mass\n0.0254,1\n0.0508,0\n").scaled(1000).sizes() == mm.sizes());
  CHECK(read("{\"unit\":\"in\",\"sizes\":[1,2],\"masses\":[1,0]}").sizes() == mm.sizes());
}

} // namespace equivalence_test
