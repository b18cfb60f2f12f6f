// What a sheet states of its sample: units, containers, numbers in two cells, places beside the table.

#include "sheet.hpp"

namespace stated_masses_test {

using namespace mdm;
using namespace mdm::test;

TEST_CASE("kilograms need no blank before them") {
  CHECK(contains(refusal(header + "4,0g\n2,1.2kg\n1,300g\n"), "sand.csv:3: '1.2kg' is in another unit"));
  CHECK(contains(refusal(header + "4,0\n2,12\nPan,2.5KG\n"), "sand.csv:4: '2.5KG' is in another unit"));
  CHECK(masses("Sieve (mm),Mass retained (kg)\n4,0\n2,1.2kg\n1,0.3\n") == "0.3 1.2 0");
}

TEST_CASE("a mass in pounds, ounces or milligrams is refused") {
  for (const std::string stated : {"Wash loss (lb),0.15", "Wash loss [lbs],0.15", "Wash loss,0.15,lb",
                                   "Wash loss (oz): 2.5", "Wash loss,70,mg"}) {
    INFO(stated);
    CHECK(contains(refusal(stated + "\n" + header + rows), "write it in g or kg"));
  }
  CHECK(contains(refusal(header + rows + "Pan (lb),0.15\n"), "'Pan (lb)' is in another unit of mass"));
}

TEST_CASE("a stated mass that the rows have only within their rounding is told with both") {
  const auto note = [](const std::string &stated) {
    return read("Initial dry mass (g)," + stated + "\n" + header + rows).notes().back();
  };
  CHECK(note("430") == "The masses add up to 430 as 'Initial dry mass (g)' says.");
  CHECK(note("431") ==
        "The masses add up to 430, 'Initial dry mass (g)' says 431: their rounding may account for it.");
}

TEST_CASE("a tare is taken off the mass before washing and after it") {
  const std::string tare = "Tare (g),40\n", before = "Tare + dry soil before wash (g),540\n",
                    after = "Tare + dry soil after wash (g),470\n";
  CHECK(masses(tare + before + after + header + rows) == "70 130 300 0");
  CHECK(masses(tare + "Mass of tare + dry soil (g),540\nMass of tare + washed dry soil (g),470\n" + header +
               rows) == "70 130 300 0");
  CHECK(contains(refusal(tare + after + header + rows), "nothing of what was washed out"));
  CHECK(contains(refusal(before + after + header + rows), "sand.csv:2: "));
  CHECK(contains(refusal(before + after + header + rows), "the mass of its container, which is not given"));
}

TEST_CASE("the number of a container is no mass") {
  CHECK(masses("Tin no.,3\nMass of tin + dry soil (g),463\nMass of tin (g),33\n" + header + rows) ==
        "130 300 0");
  CHECK(contains(refusal("Dish No.,12\nMass of dish (g),12\nDish + dry soil (g),562\n" + header + rows),
                 "says"));
}

TEST_CASE("a number that may go on in the next cell is refused") {
  for (const std::string stated :
       {"Wash loss: 1,200 g", "Wash loss (g),1,200", "Wash loss (g),70,5", "Wash loss (g): 1,200.5"}) {
    INFO(stated);
    CHECK(contains(refusal(stated + "\n" + header + rows), "which may be one"));
  }
  CHECK(masses("Wash loss (g),70,14 %\n" + header + rows) == "70 130 300 0");
  CHECK(masses("Wash loss (g),70,,14\n" + header + rows) == "70 130 300 0");
}

TEST_CASE("what is stated beside a sieve is not overlooked") {
  CHECK(contains(
      refusal("Sieve (mm),Mass retained (g),,Operator,JS\n4,0,,Dry mass before wash (g),500\n2,300,,,\n"),
      "sand.csv:2: 'Dry mass before wash (g)' is beside the row '4'"));
  const std::string remarks = "Sieve (mm),Mass retained (g),Remarks\n4,0,\n2,300,";
  CHECK(contains(refusal(remarks + "Wash loss: 70 g\n"), "sand.csv:3: 'Wash loss' is beside the row '2'"));
  CHECK(contains(refusal(remarks + "Initial mass 505 g\n"), "is beside the row '2'"));
  for (const std::string harmless : {"wet", "dry", "3 grains", "moist", "checked"}) {
    INFO(harmless);
    CHECK(masses(remarks + harmless + "\n") == "300 0");
  }
}

TEST_CASE("words of rinsing are words of washing") {
  for (const std::string label : {"Rinsing loss", "Spülverlust", "Ausgespült", "Decant loss"}) {
    INFO(label);
    CHECK(masses(label + " (g),70\n" + header + rows) == "70 130 300 0");
  }
  CHECK(contains(refusal("Slimes (g),70\n" + header + rows), "sand.csv:1: "));
}

TEST_CASE("a part that stands for the whole is no table, whatever its words") {
  for (const std::string words :
       {"100 g out of 800 g passing 2 mm were sieved", "Sample halved below 2 mm", "Factor = 8"}) {
    INFO(words);
    CHECK(contains(refusal(words + "\n" + header + rows), "may be of a part of the sample"));
  }
  CHECK(contains(refusal("Gesamteinwaage (g),1500\n" + header + rows), "says 1500"));
}

TEST_CASE("the row of the pan is compared in every column") {
  const std::string shares = "Sieve (mm),Mass retained (g),% retained\n4,0,0\n2,60,60\n1,30,30\nPan,10,";
  CHECK(masses(shares + "10\n") == "10 30 60 0");
  CHECK(masses(shares + "10.3\n") == "10 30 60 0"); // what sieving may lose
  CHECK(contains(refusal(shares + "25\n"),
                 "25 percent pass the finest sieve by the column '% retained', 10 by"));
  const std::string sums =
      "Sieve (mm),Mass retained (g),Cumulative % retained\n4,0,0\n2,60,60\n1,30,90\nPan,10,";
  CHECK(masses(sums + "100\n") == "10 30 60 0");
  CHECK(contains(refusal(sums + "130\n"), "ends at 130 percent"));
}

TEST_CASE("columns that pass under other words are compared") {
  const std::string german = "Siebweite (mm);Rückstand (g);Summe der Siebdurchgänge (%)\n4;0;100\n2;57;43\n";
  CHECK(masses(german + "1;40;3\n") == "3 40 57 0");
  CHECK(contains(refusal(german + "1;40;30\n"), "30"));
  for (const std::string name : {"% smaller", "% through", "Under (%)", "CPFT"}) {
    INFO(name);
    CHECK(contains(refusal("Sieve (mm),Mass retained (g)," + name + "\n4,0,100\n2,57,80\n1,40,3\n"), name));
  }
}

TEST_CASE("a column that says by unknown words that something passes the finest sieve is not overlooked") {
  const std::string sheet = "Sieve (mm),Mass retained (g),Cumulative (%)\n4,0,100\n2,57,43\n1,40,3\n";
  CHECK(contains(refusal(sheet), "something passes the finest sieve by the column 'Cumulative (%)'"));
  CHECK(masses(sheet + "Pan,3,0\n") == "3 40 57 0");
}

TEST_CASE("a second column of sieves may be where the mass was retained") {
  for (const std::string name : {"Retained on (mm)", "Lower size (mm)", "Lower limit (mm)"}) {
    INFO(name);
    CHECK(
        contains(refusal("Sieve size (mm)," + name + ",Mass (g)\n8,4,0\n4,2,30\n2,1,50\n"), "has sizes too"));
  }
}

TEST_CASE("inches beside names of sieves are names, too") {
  const Gradation g = read("Sieve (in),Mass retained (g)\n2,0\n1-1/2,30\n1,40\n3/4,50\nNo. 4,20\n");
  CHECK(text(g.sizes()) == "4.75 19 25 37.5 50");
  CHECK(has_note(g, "1 in is 25 mm"));
  const Gradation converted = read("Sieve (in),Mass retained (g)\n2,0\n1,40\n0.5,20\n");
  CHECK(text(converted.sizes()) == "12.7 25.4 50.8");
  CHECK(has_note(converted, "were converted to mm"));
}

TEST_CASE("cumulative percent that are at most 1 may be fractions") {
  CHECK(contains(refusal("Sieve (mm),Cumulative % retained\n4,0\n2,0.3\n1,0.97\n"),
                 "may be percent or fractions"));
  Reading asked;
  asked.kind = "cumulative_retained_percent";
  CHECK(text(read_gradation("Sieve (mm),Cumulative % retained\n4,0\n2,0.3\n1,0.97\n", "sand.csv", asked)
                 .masses()) == "99.03 0.67 0.3 0");
}

} // namespace stated_masses_test
