#include "support.hpp"

namespace particle_csv_test {

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
  const char *const sieves = "sieve,quantity\nNo. 200,2\n\"#4\",1\n# a comment\n3/8 in,7\n1.18 mm,1\n";
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

TEST_CASE(
    "CSV of particles: diameters or radii, a particle a row where there is no quantity, beside places") {
  CHECK(read("quantity,size_mm\n3,1.5\n").particles == "1.5*3");
  CHECK(read("diameter_um\n75\n150\n").particles == "0.075 0.15");
  CHECK(read("radius_mm,quantity\n1.5,2\n").particles == "3*2");
  CHECK(read("id,type,radius_mm,count\n7,1,1.5,2\n").particles == "3*2");
  CHECK(read("x,y,z,r\n0,0,0,0.5\n1,0,0,1\n").particles == "1 2");
  CHECK(read("x_m,y_m,z_m,diameter_m\n0,0,0,0.005\n").particles == "5");
  CHECK(read("x;y;z;d\n0;0;0;0,5\n").particles == "0.5");
  CHECK(read("x\ty\tz\tr\n0\t0\t0\t0.5\n").particles == "1");
  ParticleOptions metres;
  metres.unit = SizeUnit::m;
  CHECK(read("x,y,z,r\n0,0,0,0.0005\n", metres).particles == "1");
}

TEST_CASE("CSV of particles: the rows that solve and generate write give ranges of sizes") {
  CHECK(read("class,size_lo,size_hi\n1,0.5,0.6\n2,1,1\n").particles == "[0.5,0.6] [1,1]");
  CHECK(read("lower_mm,upper_mm,size_lo_mm,size_hi_mm\n1,2,1.5,1.6\n").particles == "[1.5,1.6]");
  CHECK(read("lower_um,upper_um,size_lo_um,size_hi_um\n1000,2000,1000,1001\n").particles == "(1,1.001]");
  CHECK(
      read("lower_mm,upper_mm,mass,quantity,size_lo_mm,size_hi_mm\n1,2,0,0,,\n2,4,1,3,2.5,2.6\n").particles ==
      "[2.5,2.6]*3");
}

TEST_CASE("CSV of particles: what is wrong is refused with its line") {
  CHECK(contains(refusal("size_mm,quantity\n1,2\nx,3\n"), "file:3: diameter 'x' is not a number"));
  CHECK(contains(refusal("size_mm,quantity\n0,2\n"), "file:2: diameter '0' is not above 0"));
  CHECK(contains(refusal("size_mm,quantity\n-1,2\n"), "file:2: diameter '-1' is not above 0"));
  CHECK(contains(refusal("size_mm,quantity\n1,2.5\n"), "file:2: quantity '2.5' is not a whole number"));
  CHECK(contains(refusal("size_mm,quantity\n1,-2\n"), "file:2: quantity '-2' is not a whole number"));
  CHECK(contains(refusal("size_mm,quantity\n1\n"), "file:2: the row has 1 fields, and the header 2"));
  CHECK(contains(refusal("size_mm,quantity\n1,5,2\n"), "decimal commas"));
  CHECK(contains(refusal("size_mm,quantity\n\"1,2\n"), "file:2: a quoted field"));
  CHECK(contains(refusal("size_mm,amount\n1,2\n"), "file:1: column 'amount' is unknown"));
  CHECK(contains(refusal("size_ft,quantity\n1,2\n"), "file:1: column 'size_ft' is unknown"));
  CHECK(contains(refusal("Size_mm,quantity\n1,2\n"), "column 'Size_mm' is unknown"));
  CHECK(contains(refusal("size_mm,Quantity\n1,2\n"), "column 'Quantity' is unknown"));
  CHECK(contains(refusal("quantity,x\n1,2\n"), "there is no column of sizes"));
  CHECK(contains(refusal("size_mm,radius_mm\n1,2\n"), "column 'radius_mm': there is one of this meaning"));
  CHECK(contains(refusal("size_lo_mm,quantity\n1,2\n"), "of size_lo and size_hi one is missing"));
  CHECK(contains(refusal("size_mm,size_lo_mm,size_hi_mm\n1,1,2\n"), "there are a size and its bounds"));
  CHECK(contains(refusal("size_lo_mm,size_hi_mm\n2,1\n"), "file:2: a size between '2' and '1' is none"));
  CHECK(contains(refusal("size_lo_mm,size_hi_mm\n0,0\n"), "file:2: a size between '0' and '0' is none"));
  CHECK(contains(refusal("size_lo_mm,size_hi_mm\n1,x\n"), "file:2: size 'x' is not a number"));
  CHECK(contains(refusal("sieve,quantity\npan,2\n"), "file:2: diameter 'pan' is not above 0"));
  CHECK(contains(refusal("sieve,quantity\nNo. 7777,2\n"), "file:2: diameter 'No. 7777'"));
  CHECK(contains(refusal("size_phi,quantity\n2000,2\n"), "file:2: diameter "));
  CHECK(contains(refusal("size_phi,quantity\n0.0001,2\n"), "file:2: diameter phi '0.0001' is no fraction"));
  CHECK(contains(refusal("size_mm,quantity\n"), "file:1: there are no particles"));
  CHECK(
      contains(refusal("lower_mm,upper_mm,mass,quantity,size_lo_mm,size_hi_mm\n"), "there are no particles"));
  CHECK(contains(refusal("1,2\n", from(ParticleFormat::csv)), "column '1' is unknown"));
  CHECK(contains(refusal("# nothing\n", from(ParticleFormat::csv)), "file:1: there is no header"));
  ParticleOptions unit;
  unit.unit = SizeUnit::m;
  CHECK(contains(refusal("size_mm,quantity\n1,2\n", unit), "leave out --size-unit"));
}

TEST_CASE("a comment of a sample that may be a sieve is refused") {
  CHECK(
      contains(refusal("size_mm,quantity\n4.75,2\n#4,50\n"), "file:3: '#4,50' may be a sieve or a comment"));
  CHECK(contains(refusal("#4,50\nsize_mm,quantity\n4.75,2\n"), "write '# ' before a comment"));
  CHECK(contains(refusal("sieve,quantity\n#200,2\n"), "write No. 4 for a sieve"));
  CHECK(contains(refusal("sieve,quantity\nNo. 200,2\n# 4,50\n"), "begin a comment with a word"));
  CHECK(read("size_mm,quantity\n# 4 boxes\n#of sand\n4.75,2\n").particles == "4.75*2");
}

TEST_CASE("a comment that names the columns of a list of spheres is no table") {
  CHECK(read("# x y z r in m\n0 0 0.1 0.002\n").particles == "4");
  CHECK(read("# x y z r in m; box 1 2 3, repeated in x y z\n0 0 0.1 0.002\n").particles == "4");
}

TEST_CASE("two tables of particles side by side are refused as such") {
  CHECK(contains(refusal("size_mm,quantity,,size_mm,quantity\n1,2,,3,4\n"),
                 "file:1: a column has no name: give one"));
  CHECK(contains(refusal("size_mm,quantity,size_mm,quantity\n1,2,3,4\n"),
                 "file:1: column 'size_mm': there is one"));
  CHECK(contains(refusal("size_mm\tquantity\tsize_mm\tquantity\n1\t2\t3\t4\n"),
                 "file:1: column 'size_mm': there"));
  CHECK(contains(refusal("size_mm quantity size_mm quantity\n1 2 3 4\n"),
                 "file:2: the line above names columns"));
}

TEST_CASE("CSV of ParaView: Points are places, and columns that are not known are passed over with a note") {
  const std::string table = "\"Points:0\",\"Points:1\",\"Points:2\",\"Radius\",\"velocity:0\",\"mass\"\n"
                            "1,2,3,0.5,7,8\n4,5,6,0.25,7,8\n";
  const Result result = read(table);
  CHECK(result.particles == "1 0.5");
  CHECK(result.format == ParticleFormat::csv);
  CHECK(result.notes.at(0) == "Columns that were passed over: 'velocity:0'.");
  CHECK(read("Points_0,Points_1,Points_2,diameter\n1,2,3,0.5\n").particles == "0.5");
  ParticleOptions csv;
  csv.format = ParticleFormat::csv;
  CHECK(contains(refusal("Points:0,Points:1,Points:2,mass\n1,2,3,4\n", csv), "there is no column of sizes"));
  CHECK(contains(refusal("Points:0,Points:1,Points:2,radius,Radius\n1,2,3,4,4\n"),
                 "there is one of this meaning before"));
  CHECK(contains(refusal("Points:0,Points:1,Points:2,radius\n1,2,x,4\n"), "file:2"));
}

TEST_CASE("CSV: a column of sizes that is named, among others") {
  ParticleOptions options;
  options.size_column = "c_r";
  options.meaning = SizeMeaning::radius;
  const Result result = read("tag,c_r,radius,mass\na,1,9,5\nb,2,9,5\n", options);
  CHECK(result.particles == "2 4");
  CHECK(result.notes.at(0) == "Columns that were passed over: 'tag', 'radius'.");
  options.size_column = "grain_um";
  CHECK(read("grain_um,x\n500,1\n", options).particles == "1");
  CHECK(contains(refusal("tag,size_mm\na,1\n", options), "there is no column 'grain_um'"));
  CHECK(contains(refusal("1\n1\n", options), "is for dumps, CSV and VTK"));
}

} // namespace particle_csv_test
