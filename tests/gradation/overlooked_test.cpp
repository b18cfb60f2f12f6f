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
    CHECK(contains(refusal(name + ",Retained (g)\nNo. 5,0\nNo. 10,20\n"), "may not be a sieve of ASTM"));
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

TEST_CASE("a column that speaks of the sample's mass agrees with the masses, or is refused") {
  const std::string header = "Sieve (mm),Mass retained (g),";
  for (const std::string name :
       {"Corrected (g)", "Combined", "Cum. wt. %", "Cum %", "%", "% acumulado", "Mass x factor (g)"}) {
    INFO(name);
    CHECK(contains(refusal(header + name + "\n8,0.0,0.0\n4,12.2,14.3\n2,55.0,58.1\nPan,3.0,4.1\n"),
                   "sand.csv:1: the column '" + name +
                       "' has other masses or shares than 'Mass retained (g)'"));
  }
  // In one reading they agree: as cumulative ones, as what passes.
  CHECK(masses(header + "Cum %\n8,0,0\n4,25,25\n2,50,75\nPan,25,100\n") == "25 50 25 0");
  CHECK(masses(header + "%\n8,0,100\n4,25,75\n2,50,25\nPan,25,0\n") == "25 50 25 0");
  CHECK(contains(refusal(header + "%\n8,0,100\n4,25,75\n2,50,35\nPan,25,0\n"), "other masses"));
  CHECK(contains(refusal(header + "Corrected (g)\n8,0,0\n4,25,50\n2,50,100\nPan,25,50\n"), "other masses"));
  CHECK(contains(refusal("Sieve (mm),% passing,% of total\n8,100,100\n4,80,60\n2,50,37.5\n"),
                 "other masses or shares"));
  // What is of no sample, what is constant, and words.
  for (const std::string name : {"Target (%)", "Max (%)", "Ash (%)", "Remarks"})
    CHECK(masses(header + name + "\n8,0.0,1.0\n4,12.0,14.3\n2,55.0,58.1\n") == "55 12 0");
  CHECK(masses(header + "Tolerance %\n8,0.0,5\n4,12.0,5\n2,55.0,5\n") == "55 12 0");
  CHECK(masses(header + "Corrected\n8,0.0,no\n4,12.0,yes\n2,55.0,no\n") == "55 12 0");
}

TEST_CASE("a header among the rows brings no new column of masses") {
  const std::string coarse = "Sieve (mm),Retained (g)\n16,0\n8,600\n\n";
  for (const std::string name : {"% passing", "Wash loss (g)", "Corrected (g)", "% of total"}) {
    INFO(name);
    CHECK(contains(refusal(coarse + "Sieve (mm),Retained (g)," + name + "\n4,50,75\n2,50,50\nPan,40,0\n"),
                   "sand.csv:5: a second table begins, with a column '" + name + "' that the first has not"));
  }
  const Gradation g = read(coarse + "Sieve (mm),Retained (g),Time\n4,50,10:30\n2,50,10:40\nPan,40,\n");
  CHECK(text(g.masses()) == "40 50 50 600 0");
  CHECK(has_note(g, "The rows below a second header, in line 5, were read as those of the same sample."));
  CHECK(contains(refusal(coarse + "Sieve (mm),Retained (g),\n4,50,75\n"), "is in a column without a name"));
}

TEST_CASE("decimals behind a comma do not fall into the last column") {
  const std::string header = "Sieb (mm),Rückstand (g),Bemerkung\n";
  CHECK(contains(refusal(header + "8,0,0\n4,12,3\n2,55,1\nPan,3,1\n"),
                 "'55' and '1' in the columns 'Rückstand (g)' and 'Bemerkung' may be one number"));
  CHECK(contains(refusal(header + "8,0\n4,12,25\n2,55,1\nPan,3\n"), "decimal comma"));
  CHECK(contains(refusal("Sieb (mm),Durchgang (%),Soll\n8,100,0\n4,97,5\n2,86,5\n"), "decimal comma"));
  CHECK(masses(header + "8,0,\n4,12,3\n2,55,\nPan,3,\n") == "3 55 12 0");
  CHECK(masses(header + "8,0,\n4,12.3,3\n2,55,1\nPan,3,1\n") == "3 55 12.3 0");
  CHECK(masses("Sieve (mm),Retained (g),No.\n8,0,9\n4,12,10\n2,55,11\nPan,3,12\n") == "3 55 12 0");
  CHECK(text(read("Phi,Weight (g),Note\n-1,0,1\n0,120.4,2\n1,180.2,3\n").masses()) == "180.2 120.4 0");
  CHECK(contains(refusal("Sieve (mm),Retained (g),Note\n2,0,1\n0,6,20\n0,3,30\n"), "may be"));
}

TEST_CASE("fines that a sentence or a percentage speaks of are not overlooked") {
  const std::string table = "Sieve (mm),Retained (g)\n2,0\n0.075,82.0\nPan,5.0\n";
  for (const std::string words : {"48.0 g of fines were washed out before sieving",
                                  "Note: 48.0 g washed through 0.075 mm are not in the table",
                                  "Nassabtrennung der Feinanteile: 48 g", "Feinteile ausgewaschen,48.0"}) {
    INFO(words);
    CHECK(contains(refusal(words + "\n" + table), "sand.csv:1: "));
    CHECK(contains(refusal(words + "\n" + table), "may be what passes the finest sieve"));
  }
  CHECK(contains(refusal("Fines content (%),9.6\n" + table),
                 "'Fines content (%)' is 9.6 percent, and only 5.75 pass"));
  CHECK(masses("Fines content (%),5.7\n" + table) == "5 82 0");
  CHECK(masses("Clay (%),2.5\n" + table) == "5 82 0");
  CHECK(masses("Fines content (%),9.6\nSieve (mm),Retained (g)\n2,0\n0.02,82.0\nPan,5.0\n") == "5 82 0");
}

TEST_CASE("masses of a water content are not the sample's") {
  CHECK(masses("Water content\nContainer,Wet mass (g),Dry mass (g)\n12,34.5,30.1\n\n" + header + rows) ==
        "130 300 0");
  CHECK(contains(refusal("Dry mass (g)\n30.1\n\n" + header + rows), "'Dry mass (g)' says 30.1"));
}

TEST_CASE("a number beside the pan, in a column of what was washed out, is not overlooked") {
  const std::string sieves = "8,0,\n4,17,\nPan,25,48\n";
  for (const std::string name :
       {"Wash loss (g)", "Washed fines (g)", "Fines (g)", "Waschverlust (g)", "Additional (g)"}) {
    INFO(name);
    CHECK(contains(refusal("Sieve (mm),Retained (g)," + name + "\n" + sieves),
                   "sand.csv:4: '48' in the column"));
  }
  CHECK(masses("Sieve (mm),Retained (g),Tin\n" + sieves) == "25 17 0");
}

TEST_CASE("a heading between two tables without an empty line is one of another part") {
  const std::string coarse = "Sieve (mm),Retained (g)\n8,0\n4,200\n2,400\n", fine = "1,43\n0.5,29\nPan,7\n";
  for (const std::string words :
       {"Fine sieving", "Second stage", "Feinsiebung (100 g)", "Sieving of the minus 2 mm"}) {
    INFO(words);
    const std::string message = refusal(coarse + words + "\nSieve (mm),Retained (g)\n" + fine);
    CHECK((contains(message, "begins below '" + words) ||
           contains(message, "'" + words + "' may be of a part")));
    CHECK(contains(refusal(coarse + words + "\n" + fine), "sand.csv:5: '" + words));
  }
  CHECK(masses(coarse + "Page 2\nSieve (mm),Retained (g)\n" + fine) == "7 29 43 400 200 0");
}

TEST_CASE("a factor or a water content of each row is not overlooked") {
  const std::string header = "Sieve (mm),Retained (g),";
  for (const std::string name : {"Factor", "Multiplier", "x", "Moisture (%)", "Faktor"}) {
    INFO(name);
    CHECK(contains(refusal(header + name + "\n8,0,1\n4,20,1\n2,7.5,4\n"), "differs from row to row"));
    CHECK(masses(header + name + "\n8,0,1\n4,20,1\n2,7.5,1\n") == "7.5 20 0");
  }
  CHECK(contains(refusal("Masses below 1 mm to be multiplied by 4\n" + header + "Note\n8,0,\n4,20,\n"),
                 "sand.csv:1: "));
}

TEST_CASE("shares of some 100 g have numbers of the masses, and agree") {
  CHECK(masses("Sieve (mm),Retained (g),%\n8,0.0,0.0\n4,7.1,7.1\n2,18.0,17.9\n1,75.2,75.0\n") ==
        "75.2 18 7.1 0");
  CHECK(masses("Sieve (mm),Retained (g),Cum. wt. %\n8,0,0\n4,20,10\n2,40,30\n1,60,60\n0.5,80,100\n") ==
        "80 60 40 20 0");
  CHECK(masses("Sieve (mm),Mass Retained (g),Cum. Mass (g)\n8,0,0\n4,20,20\n2,40,60\n") == "40 20 0");
  CHECK(contains(refusal("Sieve (mm),Mass Retained (g),Cum. Mass (g)\n8,0,0\n4,20,20\n2,40,70\n"),
                 "other masses"));
  CHECK(contains(refusal("Sieve (mm),Passing (%),Corr. (%)\n8,100,100\n4,80,90\n2,50,70\n"), "other masses"));
  CHECK(masses("Size (mm),Retained (g),Corrected (g)\n2-4,10,10\n1-2,20,20\n") == "20 10 0");
}

TEST_CASE("a table of water content with what was washed out is the sample's") {
  const std::string table = "Sieve (mm),Retained (g)\n4,0\n2,225\nPan,25\n";
  CHECK(masses("Container,Wet mass (g),Dry mass (g),Wash loss (g)\nA1,330,300,50\n\n" + table) == "75 225 0");
}

} // namespace overlooked_test
