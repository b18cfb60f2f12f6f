#include "support.hpp"

using namespace mdm;
using namespace mdm::test;

TEST_CASE("CSV of particles: sizes and quantities, in the unit of the header") {
  CHECK(read("size_mm,quantity\n1.5,3\n0.25,1\n").particles == "1.5*3 0.25");
  CHECK(read("size_um,quantity\n75,2\n").particles == "0.075*2");
  CHECK(read("size_m,quantity\n75e-6,2\n").particles == "0.075*2");
  CHECK(read("size_in,quantity\n0.5,2\n").particles == "12.7*2");
  CHECK(read("size_phi,quantity\n-1,3\n2,1\n").particles == "2*3 0.25");
  CHECK(read("size_phi,quantity\n-1,3\n2,1\n").notes.empty());
  CHECK(read("size_phi;quantity\n-0,5;3\n-1,5;3\n").particles == "1.4142135623731*3 2.82842712474619*3");
  CHECK(read("size_phi;quantity\n-0,5;3\n-1,5;3\n").notes.empty());
  const char *const sieves = "sieve,quantity\nNo. 200,2\n#4,1\n# a comment\n3/8 in,7\n1.18 mm,1\n";
  CHECK(read(sieves).particles == "0.075*2 4.75 9.5*7 1.18");
  CHECK(read("size_mm,quantity\n1,2\n").format == ParticleFormat::csv);
  CHECK(read("size_mm,quantity\n1,2\n").notes.empty());
  CHECK(read("\xEF\xBB\xBFsize_mm;quantity\r\n# comment\r\n\r\n1,5;2\r\n").particles == "1.5*2");
  CHECK(read("size_mm,quantity\n\"1\",\"123456789012345678901234567890\"\n").particles ==
        "1*123456789012345678901234567890");
  CHECK(read("size_mm,quantity\n2,0\n3,1\n").particles == "3");
  ParticleOptions radius;
  radius.meaning = SizeMeaning::radius;
  CHECK(read("size_mm,quantity\n1.5,3\n", radius).particles == "3*3");
}

TEST_CASE("CSV of particles: what is wrong is refused with its line") {
  CHECK(contains(refusal("size_mm,quantity\n1,2\nx,3\n"), "file:3: diameter 'x' is not a number"));
  CHECK(contains(refusal("size_mm,quantity\n0,2\n"), "file:2: diameter '0' is not above 0"));
  CHECK(contains(refusal("size_mm,quantity\n-1,2\n"), "file:2: diameter '-1' is not above 0"));
  CHECK(contains(refusal("size_mm,quantity\n1,2.5\n"), "file:2: quantity '2.5' is not a whole number"));
  CHECK(contains(refusal("size_mm,quantity\n1,-2\n"), "file:2: quantity '-2' is not a whole number"));
  CHECK(contains(refusal("size_mm,quantity\n1\n"), "file:2: the row has 1 fields"));
  CHECK(contains(refusal("size_mm,quantity\n1,5,2\n"), "decimal commas"));
  CHECK(contains(refusal("size_mm,quantity\n\"1,2\n"), "file:2: a quoted field"));
  CHECK(contains(refusal("size_mm,count\n1,2\n"), "file:1: the columns are not"));
  CHECK(contains(refusal("size_ft,quantity\n1,2\n"), "file:1: first column 'size_ft' is unknown"));
  CHECK(contains(refusal("quantity,size_mm\n1,2\n"),
                 "file:1: first column 'quantity' is unknown: use one of size"));
  CHECK(contains(refusal("Size_mm,quantity\n1,2\n"), "'Size_mm' is unknown: use one of size_mm"));
  CHECK(contains(refusal("Size_mm,quantity\n1,2\n"), "(in small letters)"));
  CHECK(contains(refusal("diameter_mm,quantity\n1,2\n"), "'diameter_mm' is unknown: use one of size_mm"));
  CHECK(contains(refusal("size_mm,Quantity\n1,2\n"), "not a size and 'quantity', in this order"));
  CHECK(contains(refusal("sieve,quantity\npan,2\n"), "file:2: diameter 'pan' is not above 0"));
  CHECK(contains(refusal("sieve,quantity\nNo. 7777,2\n"), "file:2: diameter 'No. 7777'"));
  CHECK(contains(refusal("size_phi,quantity\n2000,2\n"), "file:2: diameter "));
  CHECK(contains(refusal("size_phi,quantity\n0.0001,2\n"), "file:2: diameter phi '0.0001' is no fraction"));
  CHECK(contains(refusal("size_mm,quantity\n"), "file:1: there are no particles"));
  CHECK(contains(refusal("lower_mm,upper_mm,mass,quantity,size_lo_mm,size_hi_mm\n"), "--format json"));
  CHECK(contains(refusal("1,2\n", from(ParticleFormat::csv)), "first column '1' is unknown"));
  CHECK(contains(refusal("# nothing\n", from(ParticleFormat::csv)), "file:1: there is no header"));
  ParticleOptions unit;
  unit.unit = LengthUnit::m;
  CHECK(contains(refusal("size_mm,quantity\n1,2\n", unit), "leave out --size-unit"));
}
