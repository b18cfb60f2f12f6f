#include "gradation/coulter_reader.hpp"
#include "support.hpp"

namespace coulter_reader_test {

using namespace mdm;
using namespace mdm::test;

TEST_CASE("Coulter: heights between diameters, the last of none") {
  const Gradation g =
      read("[Version]\r\nx=1\r\n[#Bindiam]\r\n0.4\r\n0.5\r\n0.6\r\n[Binunits]\r\nBinunits=um\r\n"
           "[#Binheight]\r\n1.5\r\n98.5\r\n0\r\n[end]\r\n");
  CHECK(g.unit() == SizeUnit::um);
  CHECK(text(g.sizes()) == "0.4 0.5 0.6");
  CHECK(text(g.masses()) == "1.5 98.5 0");
}

TEST_CASE("Coulter: a last height that is not 0 is noted and left") {
  const Gradation g = read("[#Bindiam]\n1\n2\n[#Binheight]\n1.5\n0.25\n");
  CHECK(text(g.masses()) == "1.5 0");
  CHECK(contains(g.notes().back(), "It is not 0 but 0.25."));
}

TEST_CASE("Coulter: what is wrong is refused") {
  CHECK(contains(refusal("[#Bindiam]\n1\n2\n[#Binheight]\n1.5\n"),
                 "[#Bindiam] has 2 numbers, [#Binheight] has 1"));
  CHECK(contains(refusal("[#Bindiam]\n1\n2\n"), "[#Binheight] has 0"));
  CHECK(contains(refusal("[#Bindiam]\n1\n[#Bindiam]\n"), "sand.csv:3: [#Bindiam] is there twice"));
  CHECK(contains(refusal("[#Bindiam]\n1\nx\n[#Binheight]\n"), "sand.csv:3: 'x' is not a number"));
  CHECK(contains(refusal("[#Bindiam]\n1\n2\n3\n[#Binheight]\n40\n7\n0\n"), "the heights are whole numbers"));
}

} // namespace coulter_reader_test
