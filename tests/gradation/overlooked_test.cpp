// Numbers of a sheet that stand where no column or row of the table is: read, or refused.

#include "sheet.hpp"

#include <mdm/gradation/envelope.hpp>

namespace overlooked_test {

using namespace mdm;
using namespace mdm::test;

TEST_CASE("masses in g and in kg do not stand in one table") {
  CHECK(contains(
      refusal("Sieve (mm),Mass retained (kg)\n63,0\n31.5,1.2\nSieve (mm),Mass retained (g)\n8,500\n"),
      "a second table begins"));
  CHECK(
      contains(refusal("Sieve (mm),Mass retained (kg)\n4,0\n2,1.5\nPan (g),300\n"), "another unit of mass"));
  CHECK(contains(refusal("Sieve (mm),Mass retained (kg)\n4,0\n2,1.5\nWash loss (g),300\n"),
                 "another unit of mass"));
  CHECK(masses("Sieve (mm),Mass retained (g)\n4,0\n2,1.5\nPan (g),300\n") == "300 1.5 0");
  const std::string units = "Sieve,Mass retained\nmm,kg\n4,0\n2,1.5\n";
  CHECK(contains(refusal(units + "1,1500 g\n"), "another unit of mass"));
  CHECK(contains(refusal(units + "1,1\nWash loss,300 g\n"), "another unit of mass"));
  CHECK(masses("Wash loss (g),300\n" + units + "1,1\n") == "0.3 1 1.5 0");
}

TEST_CASE("cells below no name, or right of the table, are not overlooked") {
  CHECK(contains(refusal("Sieve (mm);Retained (g);;\n4;0;;Wash loss (g);70\n"), "sand.csv:2: "));
  CHECK(contains(refusal("Sieve (mm),Retained (g),\n4,0,0\n2,10,20\n"),
                 "sand.csv:2: '0' is in a column without"));
  CHECK(masses("Sieve (mm),Retained (g),\n4,0,wet\n2,10,\n") == "10 0");
  CHECK(masses(",Sieve (mm),Retained (g)\n0,4,0\n1,2,10\n") == "10 0"); // an index of rows
  CHECK(masses(",Sieve (mm),Retained (g)\n1,4,0\n2,2,10\n") == "10 0");
  CHECK(contains(refusal("Sieve (mm),Retained (g),Wash loss (g)\n4,0,70\n2,10,\n"),
                 "'70' in the column 'Wash loss (g)'"));
  CHECK(contains(refusal("Sieve (mm),Retained (g),Pan (g)\n4,0,\n2,10,7\n"), "'7' in the column 'Pan (g)'"));
  CHECK(contains(refusal("Sieve (mm),Mass (g),Tare (g)\n4,400,400\n2,410,400\n"), "is weighed too"));
  CHECK(masses("Sieve (mm),Mass retained (g),Remark\n4,0,\n2,10,7\n") == "10 0");
}

TEST_CASE("masses that are stated in one cell with their words are read, or refused") {
  for (const std::string stated : {"Wash loss 70 g", "Wash loss: 70 g", "Wash loss (g),70",
                                   "Dry mass before washing 500 g\nDry mass after washing 430 g",
                                   "M1: total dry mass (g),500\nM2: dry mass after washing (g),430",
                                   "70,wash loss (g)", "0.07,wash loss (kg)"}) {
    INFO(stated);
    CHECK(masses(stated + "\n" + header + rows) == "70 130 300 0");
  }
  for (const std::string unclear : {"Wash loss: 70 g (14%)", "Wash loss: approx. 70 g", "Wash loss,70*",
                                    "Wash loss,~70", "Wash loss (g),70 - 80"}) {
    INFO(unclear);
    CHECK(contains(refusal(unclear + "\n" + header + rows), "sand.csv:1: "));
  }
  CHECK(masses("Dry mass M1 [g],430\n" + header + rows) == "130 300 0");
  CHECK(contains(refusal("Dry mass M1 [g],500\n" + header + rows), "500"));
  CHECK(masses("Start: 10:30\n" + header + rows) == "130 300 0");
  CHECK(masses("Start,08.03.2024\n" + header + rows) == "130 300 0");
  CHECK(masses("Sieved 12 March 2024\n" + header + rows) == "130 300 0");
}

TEST_CASE("a second table below other words is not added up") {
  CHECK(contains(refusal("Coarse fraction\n" + header + "16,0\n8,1200\n\nFine fraction (riffled)\n" + header +
                         "2,120\n"),
                 "a second table begins below 'Fine fraction (riffled)'"));
  CHECK(contains(refusal("Sample A\n" + header + "16,0\n8,120\n\nSample B\n" + header + "2,120\n"),
                 "below 'Sample B'"));
  const std::string passing = "Sieve (mm),% passing\n";
  CHECK(contains(refusal("Sample A\n" + passing + "16,100\n8,80\n\nSample B\n" + passing + "2,60\n"),
                 "below 'Sample B'"));
  CHECK(masses(passing + "16,100\n8,80\n\nHydrometer\n" + passing + "0.02,60\n") == "60 20 20 0");
  CHECK(contains(refusal(passing + "4,100\n2,80\n\nD values\n0.48,30\n0.23,10\n"), "below 'D values'"));
}

TEST_CASE("a sieve below an empty row is a sieve, whatever stands beside it") {
  const std::string passing = "Sieve (mm),% passing\n4,100\n2,80\n\n1,50\n";
  for (const std::string value : {"20*", "n.d.", "<1", ""}) {
    INFO(value);
    CHECK(contains(refusal(passing + "0.5," + value + "\n"), "sand.csv:6: "));
  }
  CHECK(contains(refusal(header + "4,0\n2,100\n\nFines,30.5\n"), "what passed the finest one"));
  CHECK(masses("Siebweite (mm);R\u00fcckstand (g)\n4;0\n2;100\n\nBlindboden;30,5\n") == "30.5 100 0");
  CHECK(masses(header + rows + "\nChecked by A. B.\n") == "130 300 0");
}

TEST_CASE("limits below an empty row are limits") {
  const std::string limits = "Sieve (mm),Lower,Upper\n9.5,100,100\n4.75,95,100\n\n";
  const auto refused = [](const std::string &content) {
    return message_of([&] { read_envelope(content, "sand.csv"); });
  };
  CHECK(contains(refused(limits + "0.15,0*,1*\n"), "0*"));
  CHECK(contains(refused("Sieve (mm),Lower,Upper\n9.5,100,100\n4.75,95,\n"), "has no value in the column"));
  const Envelope e = read_envelope(limits + "Fineness modulus,2.3,3.1\n", "sand.csv");
  CHECK(e.sizes.size() == 2);
  CHECK(contains(e.notes.back(), "left out: 'Fineness modulus'"));
}

TEST_CASE("sieve numbers of other series are not those of ASTM") {
  for (const std::string name : {"BS sieve No.", "British Standard sieve", "IS sieve No."}) {
    INFO(name);
    CHECK(contains(refusal(name + ",Retained (g)\nNo. 5,0\nNo. 10,20\n"), "is not a sieve of ASTM"));
  }
  CHECK(masses("BS sieve,Retained (g)\n4 mm,0\n2 mm,20\n") == "20 0");
  CHECK(masses("US sieve No.,Retained (g)\nNo. 5,0\nNo. 10,20\n") == "20 0");
}

TEST_CASE("sieves in a row: empty cells behind a row change nothing") {
  const std::string sieves = "Sieve (mm),16,8,4\nRetained (g),0,80,50\n";
  CHECK(masses(sieves + "Wash loss (g),20,,\n") == "20 50 80 0");
  CHECK(masses(sieves + "Pan (g),20,,\n") == masses(sieves + "Pan (g),20\n"));
}

TEST_CASE("a size with a decimal comma between commas is not a size and a mass") {
  CHECK(contains(refusal("Siebweite (mm),R\u00fcckstand (g),Bemerkung\n4,0,\n0,063,30\n"), "decimal commas"));
}

} // namespace overlooked_test
