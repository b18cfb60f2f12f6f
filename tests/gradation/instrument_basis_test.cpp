// Files of instruments and tables whose shares are not by volume, or are not of the whole sample.

#include "sheet.hpp"

namespace instrument_basis_test {

using namespace mdm;
using namespace mdm::test;

TEST_CASE("shares by number, surface or length are refused, whatever the sheet calls that") {
  const std::string table = "Size (\u00b5m),Undersize (%)\n1,0\n10,40\n100,100\n";
  for (const std::string line : {"Result units,Number", "Result type: number", "Verteilungsart: Anzahl",
                                 "Basis: Surface", "Distribution,Surface area", "Report by,Number"}) {
    INFO(line);
    CHECK(contains(refusal(line + "\n" + table), "by volume"));
  }
  for (const std::string line :
       {"Report number,12", "Sample type,Sand", "Number of tests: 3", "Specific surface area,0.5",
        "Result units,Volume", "Project report,Number,17", "Units,Length,mm", "Type,Length", "Units: Length"})
    CHECK(masses(line + "\n" + table) == "40 60 0");
}

TEST_CASE("Mastersizer: other units than volume, and shares that are not of all, are refused") {
  for (const std::string type : {"Result Units,", "Distribution Type,", "Result type,"})
    for (const std::string basis : {"Number", "Surface area", "Length"})
      CHECK(
          contains(refusal("Sample Name," + type +
                           "Result Between User Sizes (Sizes in um),,\n,,1,10,100\nA," + basis + ",40,60,\n"),
                   "by volume"));
  CHECK(contains(refusal("Sample Name,x,Result Between User Sizes (Sizes in um),,\n,,1,10,100\nA,5,40,55,\n"),
                 "add up to 95, not to 100"));
}

TEST_CASE("CAMSIZER: what is coarser than the last class is not dropped, nor a second table passed over") {
  const std::string head =
      "CAMSIZER\r\nSize class [mm]\tp3 [%]\tQ3 [%]\tSPHT3\r\n0.000\t0.063\t1.2\t1.2\t0.9\r\n";
  CHECK(contains(refusal(head + "0.063\t2.000\t45.0\t46.2\t0.9\r\n>2.000\t\t53.8\t100.0\t.9\r\n"),
                 "Q3 ends at 46.2"));
  const std::string whole = head + "0.063\t2.000\t98.8\t100.0\t0.9\r\n";
  CHECK(masses(whole) == "1.2 98.8 0");
  CHECK(contains(refusal(whole + whole), "a second table"));
}

TEST_CASE("Coulter: another basis or another unit in a section is refused") {
  const auto file = [](const std::string &lines) {
    return "[Version]\r\n" + lines + "[#Bindiam]\r\n0.4\r\n0.5\r\n0.6\r\n[#Binheight]\r\n1.5\r\n2.5\r\n0\r\n";
  };
  CHECK(contains(refusal(file("Distribution=Number\r\n")), "by volume"));
  CHECK(contains(refusal(file("[Binunits]\r\nBinunits=mm\r\n")), "are read in um"));
  CHECK(masses(file("[Binunits]\r\nBinunits=um\r\n")) == "1.5 2.5 0");
}

} // namespace instrument_basis_test
