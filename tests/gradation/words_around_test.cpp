// What decides how a table is read, and stands around it: lines above, a row of units, words beside a row, a
// column of samples, a second table. It is read, or the sheet is refused.

#include "sheet.hpp"

namespace words_around_test {

using namespace mdm;
using namespace mdm::test;

TEST_CASE("a line that begins with # and has a number is a row") {
  CHECK(contains(refusal(header + "4,0\n#N/A,250\n1,200\n"), "sand.csv:3: "));
  CHECK(masses("Flag," + header + ",4,0\n#,2,100\n,1,200\n") == "200 100 0");
  CHECK(masses("# sieved on 3 March\n" + header + "# nobody knows\n" + rows) == "130 300 0");
}

TEST_CASE("a table above the one that is read is not passed over") {
  const std::string pounds = "Sieve (mm),Mass retained (lb)\n63,0\n20,12\n10,8\n\n";
  CHECK(contains(refusal(pounds + header + rows),
                 "sand.csv:1: a table with 'Sieve (mm)' begins here and is not read"));
  CHECK(masses("Sieve,Soil\n" + header + rows) == "130 300 0");
}

TEST_CASE("rows of several samples are no stack of sieves") {
  const std::string rows_of_two = "A,20,0\nA,10,500\nB,4,0\nB,2,120\n";
  for (const std::string name : {"Sample", "Borehole", "Specimen ID", "Lab No. of sample", "Layer", "ID"}) {
    INFO(name);
    CHECK(
        contains(refusal(name + "," + header + rows_of_two), "names several samples or parts, 'A' and 'B'"));
  }
  CHECK(contains(refusal("Test," + header + "coarse,20,0\ncoarse,10,500\nfine,4,20\nfine,2,120\n"),
                 "'coarse' and 'fine'"));
  CHECK(
      masses(
          "Test,Sieve (mm),% passing\nsieve,20,100\nsieve,10,50\nhydrometer,0.02,40\nhydrometer,0.01,30\n") ==
      "30 10 10 50 0");
  CHECK(masses("Sample," + header + "A,20,0\nA,10,500\n") == "500 0");
  CHECK(masses("Sample No.," + header + "1,20,0\n2,10,500\n3,5,200\n") == "200 500 0");
  CHECK(contains(refusal(header + "Sample A,\n20,0\n10,500\nSample B,\n5,0\n2,100\n"), "'Sample B'"));
  CHECK(masses(header + "Sample A,\n20,0\n10,500\n") == "500 0");
}

TEST_CASE("a second stack that begins with an empty sieve is not added to the first") {
  CHECK(contains(refusal(header + "20,0\n10,500\n\n" + header + "5,0\n2,100\n"),
                 "begins with a sieve that retains nothing"));
  CHECK(masses(header + "20,0\n10,500\n\n" + header + "5,30\n2,100\n") == "100 30 500 0");
}

TEST_CASE("a percentage is no mass in a column of masses") {
  for (const std::string row :
       {"% passing 0.063,14.5", "Percent finer than No. 200,14.5", "Wash loss (%),14.5", "Loss (%),2.5"}) {
    INFO(row);
    CHECK(contains(refusal(header + "4,0\n2,300\n0.063,130\n" + row + "\n"), "is a percentage"));
  }
  CHECK(masses("Sieve (mm),Retained (%)\n4,0\n2,70\nPan (%),30\n") == "30 70 0");
}

TEST_CASE("what stands in a row of units is a unit, or is read") {
  const std::string names = "Sieve size,Mass retained,,,\n";
  CHECK(masses(names + "mm,g,,Wash loss (g),70\n" + rows) == "70 130 300 0");
  for (const std::string units : {"mm,lb", "mm,cumulative %", "mm,g (cumulative)", "mm,Sample B"}) {
    INFO(units);
    CHECK(contains(refusal(names + units + "\n" + rows), "which is no unit that is known"));
  }
  CHECK(contains(refusal("Size,Passing\n(um),(% by number)\n100,100\n50,60\n"), "(% by number)"));
  CHECK(masses("Size,Passing\n(um),(% by mass)\n100,100\n50,60\n") == "60 40 0");
}

TEST_CASE("what is said of the sample beside the table is read or refused") {
  CHECK(masses("Sieve (mm),Mass retained (g),,Wash loss (g),70\n" + rows) == "70 130 300 0");
  const std::string wide = "Sieve (mm),Mass retained (g),,,\n";
  for (const std::string row : {"Pan,5,,Wash loss (g),70", "Total,430,,Wash loss (g),70"}) {
    INFO(row);
    CHECK(contains(refusal(wide + rows + row + "\n"), "'Wash loss (g)' is beside the row"));
  }
  CHECK(masses("Sieve (mm),4,2,1\nMass retained (g),0,300,130\nOperator,AB,Wash loss (g),70\n") ==
        "70 130 300 0");
}

TEST_CASE("a remark beside a sieve is none of its words") {
  const std::string names = "Method,Sieve (mm),Mass retained (g)\ndry,4,0\ndry,2,100\n";
  CHECK(masses(names + "wet,0.063,50\n") == "50 100 0");
  for (const std::string word : {"wash", "Bottom"}) {
    INFO(word);
    CHECK(contains(refusal(names + word + ",0.063,50\n"), "is beside the size '0.063'"));
  }
  CHECK(masses(names + "Pan,0,50\n") == "50 100 0");
}

TEST_CASE("a tray among the sieves may be the pan") {
  CHECK(contains(refusal(header + rows + "Tray,35\n"), "may be the pan"));
  CHECK(masses(header + rows + "\nMass of tray (g),35\n") == "130 300 0");
}

TEST_CASE("shares by number are no masses, where a line above says so") {
  const std::string percent = "Diameter (um),Undersize (%)\n100,100\n50,60\n10,20\n";
  CHECK(contains(refusal("Distribution Base,Number\n" + percent), "by number"));
  for (const std::string words :
       {"Number distribution", "Anzahlverteilung", "Count distribution", "By number", "Number-%",
        "Verteilung: Q0", "Pebble count (Wolman)", "Intensity distribution (DLS)", "Weighted by: area",
        "Grid-by-number sampling"})
    CHECK(contains(refusal(words + "\n" + percent), "by number"));
  for (const std::string words : {"Sample number: 5", "Number of sieves,7", "Surface area 0.5 m2/g"})
    CHECK(masses(words + "\n" + percent) == masses(percent));
  CHECK(masses("Distribution Base,Volume\n" + percent) == masses(percent));
  CHECK(masses("Sample number,12\n" + percent) == masses(percent));
  const std::string exported = "Sample Name,Distribution Type,Result Between User Sizes um,,\n,,1,2,4\nS1,";
  CHECK(contains(refusal(exported + "Number,40.00,60.00,\n"), "'Number'"));
  CHECK(masses(exported + "Volume,40.00,60.00,\n") == "40 60 0");
  const std::string camsizer = "x [mm]\t\tp3 [%]\tQ3 [%]\n0\t0.1\t10.0\t10.0\n0.1\t0.2\t90.0\t100.0\n";
  CHECK(contains(refusal("Number distribution Q0\n" + camsizer), "by number"));
  CHECK(masses(camsizer) == "10 90 0");
}

TEST_CASE("a line above tells whose sieve numbers they are") {
  CHECK(contains(refusal("Sieve analysis (sieves to BS 410)\nSieve,Mass retained (g)\nNo. 7,0\nNo. 14,50\n"),
                 "may not be a sieve of ASTM"));
  CHECK(contains(refusal("Tyler standard screen scale\nSieve No.,Mass retained (g)\nNo. 8,0\nNo. 10,50\n"),
                 "may not be a sieve of ASTM"));
  CHECK(masses("This is a sieve analysis\nSieve,Mass retained (g)\nNo. 8,0\nNo. 10,50\n") == "50 0");
}

TEST_CASE("numbers of sieves and phi are compared with the openings beside them") {
  const std::string numbers = "Sieve No.,Opening (mm),Mass retained (g)\n4,4.75,0\n10,2,100\n";
  CHECK(contains(refusal(numbers + "200,0.425,200\n"), "is another sieve"));
  CHECK(masses(numbers + "40,0.425,200\n") == "200 100 0");
  CHECK(masses("Sieve No.,Opening (mm),Mass retained (g)\n1,4.75,0\n2,2,100\n3,1,20\n4,0.5,20\n") ==
        "20 20 100 0");
  const std::string phi = "phi,Size (mm),Mass retained (g)\n-2,4,0\n-1,2,100\n";
  CHECK(contains(refusal(phi + "1,0.25,200\n"), "is another sieve"));
  CHECK(masses(phi + "4,0.063,200\n") == "200 100 0");
}

TEST_CASE("a word above the header is a part of it") {
  CHECK(
      contains(refusal("Sieve,Cumulative,\n(mm),Retained (g)\n4,0\n2,10\n1,45\n"), "'Cumulative' is above"));
  CHECK(contains(refusal("Sieve,Cumulative,,\n(mm),Passing (g),Retained (g)\n4,0,0\n2,10,5\n"),
                 "'Cumulative' is above"));
  CHECK(masses("Sieve,Sample 7,\n(mm),Retained (g)\n4,0\n2,10\n1,45\n") == "45 10 0");
}

TEST_CASE("a second table of sieves in a row is not passed over") {
  CHECK(
      contains(refusal("Sieve (mm),20,10,5\nMass retained (g),0,100,200\n\nFine sieving\nSieve (mm),2,1,Pan\n"
                       "Mass retained (g),50,40,10\n"),
               "a second table of sieves in a row"));
}

TEST_CASE("a stated mass is read, whatever its label ends in") {
  for (const std::string stated :
       {"Wash loss through 63 um,70", "Washed through 1 mm: 70 g", "Loss on washing over 63 um,70",
        "Wash loss (g),:,70", "Wash loss,=,70,g", "Wash loss (g),W,70", "Wash loss (g),calc.,70",
        "Wash loss,M1,g,70", "Washed away,70.0", "Wash loss Wf,70", "Dry mass,Wash loss\n(g),(g)\n500,70",
        "Dry mass (g),500\nWash loss 14 %"}) {
    INFO(stated);
    CHECK(masses(stated + "\n" + header + rows) == "70 130 300 0");
  }
  CHECK(masses(header + rows + "Operator,,,Wash loss (g),70\n") == "70 130 300 0");
  for (const std::string unclear : {"Wash loss 70 g / dry mass 500 g", "Wash loss 70 g of 500 g",
                                    "What the wash took: 70 g", "Silt + clay: 70 g", "Wash loss,~70"}) {
    INFO(unclear);
    CHECK(contains(refusal(unclear + "\n" + header + rows), "sand.csv:1: "));
  }
}

TEST_CASE("fines and other masses beside a table without a pan may be what passes its finest sieve") {
  for (const std::string words :
       {"Fines,70", "Silt & clay,40", "Mud: 40 g", "Fraction < 0.063 mm: 40 g", "Colloids,4"}) {
    INFO(words);
    CHECK(contains(refusal(words + "\n" + header + rows), "sand.csv:1: "));
    CHECK(contains(refusal(header + rows + "\n" + words + "\n"), "sand.csv:"));
  }
  const Gradation g = read("Fines,70\n" + header + rows + "Pan,70\n");
  CHECK(std::any_of(g.notes().begin(), g.notes().end(),
                    [](const std::string &note) { return contains(note, "left out: 'Fines'"); }));
}

TEST_CASE("a total that is without a part of the rows says so") {
  const Gradation g = read(header + rows + "Pan,70\nTotal,430\n");
  CHECK(text(g.masses()) == "70 130 300 0");
  CHECK(std::any_of(g.notes().begin(), g.notes().end(), [](const std::string &note) {
    return contains(note, "'Total' says 430: that is what is on the sieves");
  }));
  CHECK(masses("Sieve (mm),Mass retained (g),Retained (%)\n4,0,0\n2,300,75\n1,100,25\nTotal,,100\n") ==
        "100 300 0");
}

TEST_CASE("a pan that is weighed with what is in it, and a class between two sieves, are no pan") {
  CHECK(contains(refusal("Mass of empty pan (g),100\n" + header + rows + "Mass of pan and soil (g),120\n"),
                 "sand.csv:6: "));
  CHECK(contains(refusal(header + "4,0\n2,100\n\"Passing 2 mm, retained 1 mm\",30\n"), "sand.csv:4: "));
  CHECK(masses(header + "4,0\n2,100\n1,5\nPassing 1 mm,30\n") == "30 5 100 0");
}

TEST_CASE("columns of two samples are refused, whatever tells them apart") {
  for (const auto &[first, second] :
       std::vector<std::pair<std::string, std::string>>{{"Mass retained A (g)", "Mass retained B (g)"},
                                                        {"Mass retained (g)", "Mass retained (g).1"},
                                                        {"Mass retained (g)", "Mass retained 2 (g)"},
                                                        {"R\u00fcckstand [g]", "R\u00fcckstand-2 [g]"}}) {
    INFO(second);
    CHECK(contains(refusal("Sieve (mm)," + first + "," + second + "\n4,0,0\n2,10,20\n"),
                   "may be of two samples"));
  }
  CHECK(masses("Sieve (mm),Tare weight (g),Weight retained (g)\n4,400,0\n2,400,10\n") == "10 0");
}

TEST_CASE("values that grow to 100 may be cumulative percent") {
  CHECK(contains(refusal("Sieve (mm),Retained\n4,0\n2,10\n1,45\n0.5,80\nPan,100\n"),
                 "as in a cumulative column"));
  CHECK(masses("Sieve (mm),Retained\n4,0\n2,50\n1,45\n0.5,80\nPan,100\n") == "100 80 45 50 0");
}

TEST_CASE("percent signs stand at all values or at none") {
  CHECK(contains(refusal("Sieve (mm),% passing\n4,100%\n2,60%\n1,25%\n0.063,0.035\n"), "write all alike"));
  CHECK(masses("Sieve (mm),% passing\n4,100%\n2,60%\n1,0\n") == "60 40 0");
}

TEST_CASE("a size 0 with a third number beside it may have a decimal comma") {
  CHECK(contains(refusal("Siebweite (mm),R\u00fcckstand (g),Bemerkung\n4,0,\n2,10,\n0,6,20\n"),
                 "decimal commas"));
}

TEST_CASE("spellings of sheets that are ordinary are read") {
  CHECK(masses("\"Sieve\n(mm)\",\"Mass retained\n(g)\"\n" + rows) == "130 300 0");
  CHECK(masses("Sieve size (in)\tMass retained (g)\n\"3/4\"\"\"\t0\n\"1/2\"\"\"\t10\n") == "10 0");
  CHECK(masses("Sieve size (in),Mass retained (g)\n3/4,0\n1/2,10\n") == "10 0");
  CHECK(masses("#,Sieve (mm),Mass retained (g)\n1,4,0\n2,2,10\n") == "10 0");
  CHECK(masses("phi,Mass retained (g)\n\u22122,0\n\u22121,10\n0,20\n") == "20 10 0");
  CHECK(masses("Sieve (mm),Mass retained (g),% passing\n4,0,100\n2,10,0\nFineness modulus,,3.10\n") ==
        "10 0");
  std::string wide = header;
  for (int i = 0; i < 1001; ++i)
    wide.insert(wide.size() - 1, ",x");
  CHECK(contains(refusal(wide + rows), "1000 cells or more"));
}

TEST_CASE("a loss beside percents is accounted for") {
  const std::string percents = "Sieve (mm),Percent passing\n4,100\n2,60\n1,20\n";
  CHECK(contains(refusal(percents + "Loss,50\n"), "'Loss' is 50 percent, more than 1: allow it with --loss"));
  CHECK(masses(percents + "Loss,0.4\n") == "20 40 40 0");
  CHECK(masses(percents + "Loss,0\n") == "20 40 40 0");
  CHECK(contains(refusal("Sieve (mm),Fraction passing\n4,1\n2,0.6\n1,0.2\nLoss,0.5\n"), "'Loss' is "));
}

TEST_CASE("a mass on a sieve outside the table is not passed over") {
  CHECK(contains(refusal(header + rows + "\nRetained on 8 mm: 500 g\n"),
                 "is a mass on a sieve, outside the table"));
  CHECK(contains(refusal("Oversize: 500 g\n" + header + rows), "is a mass on a sieve, outside the table"));
}

TEST_CASE("a wash loss below the table is used, and no note says that it is not") {
  const Gradation g = read(header + "4,0\n2,60\n1,20\nPan,5\nWash loss: 5\n");
  CHECK(text(g.masses()) == "10 20 60 0");
  for (const std::string &note : g.notes())
    CHECK_FALSE(contains(note, "left out"));
}

TEST_CASE("words of a split with a number above the table are not passed over") {
  const std::string stack = "31.5,0\n16,400\n8,300\n4,200\n2,50\n1,30\n0.5,10\nPan,10\n";
  for (const std::string line : {"Split factor 4", "Split: 1/4 below 4 mm", "Riffled at 4 mm: 100 g of 400 g",
                                 "Geteilt 1/4", "Fine fraction: 100 g of 400 g sieved"}) {
    INFO(line);
    CHECK(contains(refusal(line + "\n" + header + stack), "may be of a part of the sample"));
  }
  for (const std::string line : {"Split-spoon sample 3", "Reduced level 12.3", "Sample 4 of 7"})
    CHECK(masses(line + "\n" + header + stack) == "10 10 30 50 200 300 400 0");
}

TEST_CASE("a row of words among the rows of the table is named") {
  const std::string words = "oversize removed by hand\n";
  for (const std::string &sheet :
       {header + "4,0\n2,10\n" + words + "1,30\nPan,5\n", header + "4,0\n2,10\n1,30\n" + words + "Pan,5\n"}) {
    INFO(sheet);
    CHECK(contains(refusal(sheet), "'oversize removed by hand' is among the rows of the table"));
  }
  CHECK(masses(header + words + "4,0\n2,10\n1,30\nPan,5\n") == "5 30 10 0");
  CHECK(masses(header + "4,0\n2,10\n1,30\nPan,5\n" + words) == "5 30 10 0");
}

const std::string washed_stack = "8,0\n4,25\n2,80\n1,150\n0.5,120\n0.25,70\n0.125,35\n0.063,12\nPan,8\n";

TEST_CASE("a row with a number below an empty row is not passed over") {
  const std::string sieves = header + "4,0\n2,80\n1,150\n\n";
  for (const std::string row :
       {"Catch pan,50", "Undersize,50", "Tray,50", "Fundo,50", "#200 wet,30\nPan,8", "N200,30\nPan,8",
        "Retained on 0.063,30\nPan,8", "Pan content,50", "Test sieve 0.063,30\nPan,8", "Number 230,30\nPan,8",
        "d 0.063 mm,12", "D 63,12", "d=0.063,12", "D 2 - 4 mm,12", "d > 4 mm,12", "Passing by difference,50",
        "Lab tray,50"}) {
    INFO(row);
    CHECK_FALSE(refusal(sieves + row + "\n").empty());
  }
  for (const std::string row : {"D10,0.15", "D10 (mm),0.15", "d 10,0.15", "D60/D10,4", "F.M.,2.9", "FM,2.9",
                                "Cu,4.3", "Moisture content (%),4.2", "Page,1", "Total,230"})
    CHECK(masses(sieves + row + "\n") == "150 80 0");
}

TEST_CASE("an index before the label of a row below an empty one hides nothing") {
  const std::string table = "No.,Sieve (mm),Mass retained (g)\n1,4,0\n2,2,80\n3,1,150\n\n";
  for (const std::string row : {"4,Catch pan,50", "4,Fines,50", "4,Sieve 0.063,30"})
    CHECK_FALSE(refusal(table + row + "\n").empty());
  CHECK(masses(table + "4,Pan,50\n") == "50 150 80 0");
  CHECK(masses(table + "4,Median (mm),1.2\n") == "150 80 0");
}

TEST_CASE("shares of soils and sums below a table hide no mass") {
  const std::string percents = "Sieve (mm),% passing\n4,100\n2,80\n1,50\n0.063,2\n\n";
  for (const std::string row :
       {"Gravel (%),20", "Sand,78", "Fines (%),2", "Gs,2.65", "Sand equivalent,70", "D10 (mm),0.24"})
    CHECK(masses(percents + row + "\n") == "2 48 30 20 0");
  const std::string weights = header + "4,0\n2,80\n1,150\nPan,20\n\n";
  for (const std::string row : {"Gravel (%),20", "Silt (%),8", ",250"})
    CHECK(masses(weights + row + "\n") == "20 150 80 0");
  CHECK_FALSE(refusal(weights + ",251\n").empty());
  CHECK_FALSE(refusal(header + "4,0\n2,80\n1,150\n\nSilt (%),8\n").empty());
}

TEST_CASE("a block to the right below the first is not passed over") {
  const std::string first = header + "4,0\n2,80\n1,150\n\n";
  CHECK(contains(refusal(first + ",,,Sieve size (mm),Mass retained (g)\n,,,0.5,120\n,,,0.25,70\n"),
                 "beside the columns"));
  CHECK(contains(refusal(first + ",,,0.5,120\n"), "beside the columns"));
  CHECK(masses(first + "D10,,0.2,D60,1.1\n") == "150 80 0");
}

TEST_CASE("a washed sample is not what was washed out") {
  for (const std::string line :
       {"Washed sample (g): 500", "Washed soil: 500 g", "Wash residue,500", "Washed sample,500",
        "Muestra lavada (g),500", "Washed: 500 g", "Total washed (g),500"}) {
    INFO(line);
    CHECK(contains(refusal(line + "\n" + header + washed_stack), "'Dry mass after wash'") !=
          contains(refusal(line + "\n" + header + washed_stack), "write Wash loss, or a row Pan"));
  }
  for (const std::string line : {"Wash loss: 70 g", "Washing: 70 g", "Lavage: 70 g", "Washed out,70"})
    CHECK(masses(line + "\n" + header + washed_stack) == "78 12 35 70 120 150 80 25 0");
  CHECK(contains(
      refusal("Dry mass before washing: 494 g\nDry mass after washing: 500 g\n" + header + washed_stack),
      "gains nothing by washing"));
}

TEST_CASE("a wet sieve among the rows is no moist mass") {
  for (const std::string row :
       {"Wet sieve 0.063,30", "Wet loss,70", "Wet #200,12", "Nass 0.063,12", "Damp fines,70"})
    CHECK(contains(refusal(header + "4,0\n2,80\n1,150\n" + row + "\nPan,8\n"), "is no sieve"));
}

TEST_CASE("a stated number that is cut between its thousands is refused") {
  for (const std::string line : {"Wash loss 1 234.5 g", "Wash loss 1 234 g", "Wash loss 1'234.5 g"})
    CHECK(contains(refusal(line + "\n" + header + washed_stack), "is not a number"));
  CHECK(masses("Wash loss 63 um (g),70\n" + header + washed_stack) == "78 12 35 70 120 150 80 25 0");
}

TEST_CASE("a stated mass that is more than all rows is not passed over") {
  for (const std::string lines : {"M1 = 570 g\nM2 = 500 g", "M1 (g),570\nM2 (g),500",
                                  "Dry mass (before): 570 g\nDry mass (after): 500 g"})
    CHECK(contains(refusal(lines + "\n" + header + washed_stack), "more than the 500 of all rows"));
  CHECK(masses("Mass of tin + wet soil (g),700\n" + header + washed_stack) == "8 12 35 70 120 150 80 25 0");
}

TEST_CASE("a mass above the table whose label is in the row above it is not passed over") {
  CHECK(contains(refusal("M1 (g),M2 (g)\n570,500\n" + header + washed_stack),
                 "'M1 (g)' is 570, more than the 500 of all rows"));
}

TEST_CASE("a cell above the header of values may say that they are others") {
  const std::string percents = "Sieve (mm),Percent passing\n4,100\n2,80\n1,20\n";
  for (const std::string words : {",Number", ",Counts", ",Cumulative retained"})
    CHECK(contains(refusal(words + "\n" + percents), "is above the header 'Percent passing'"));
  CHECK(contains(refusal(",Wet mass\n" + header + rows), "is above the header"));
  CHECK(contains(refusal("Cumulative,\nMass retained (g),Sieve (mm)\n0,4\n300,2\n430,1\n"),
                 "is above the header 'Mass retained (g)'"));
  CHECK(masses(",Sample A\n" + percents) == masses(percents));
}

TEST_CASE("words that say that values are cumulative are not passed over") {
  for (const std::string words :
       {"Results are cumulative", "The retained masses are cumulative", "Die Rueckstaende sind kumuliert"}) {
    CHECK(contains(refusal(words + "\n" + header + washed_stack), "say --kind cumulative if it is"));
    CHECK(contains(refusal(header + washed_stack + "\n" + words + "\n"), "say --kind cumulative if it is"));
  }
  for (const std::string words : {"Cumulative particle size distribution", "Masses are not cumulative"})
    CHECK(masses(words + "\n" + header + washed_stack) == "8 12 35 70 120 150 80 25 0");
}

TEST_CASE("a part that was sieved for the whole is told by its fraction") {
  for (const std::string words : {"1/4 of passing sieved", "Remark,1/8 of the fines"})
    CHECK(contains(refusal(words + "\n" + header + washed_stack), "--split"));
}

TEST_CASE("what was washed through a coarser sieve than the finest need not pass that") {
  CHECK(contains(refusal("Material finer than 75 um by washing: 70 g\n" + header + washed_stack),
                 "is coarser"));
  CHECK(masses("Material finer than 63 um by washing: 70 g\n" + header + washed_stack) ==
        "78 12 35 70 120 150 80 25 0");
}

TEST_CASE("a second block beside the first is not passed over") {
  CHECK(contains(
      refusal("Sieve size (mm),Mass retained (g),,Size 2 (mm),Mass 2 (g)\n8,0,,0.25,70\n4,25,,0.125,35\n"
              "2,80,,0.063,12\n1,150,,Pan,8\n0.5,120,,,\n"),
      "'Pan' is in the column 'Size 2 (mm)'"));
}

TEST_CASE("units beside masses are one, and a stated kg needs a unit in the table") {
  for (const std::string columns : {"Mass retained,", "Mass retained (g),Unit"})
    CHECK(contains(refusal("Sieve (mm)," + columns + "\n8,0,g\n4,25,g\n1,0.15,kg\n0.5,245,g\n"),
                   "write all alike"));
  CHECK(masses("Sieve (mm),Mass retained,Unit\n8,0,g\n4,25,g\n1,5,g\n") == "5 25 0");
  CHECK(contains(refusal("Wash loss: 0.07 kg\nSieve (mm),Weight retained\n4,0\n2,0.105\nPan,0.008\n"),
                 "has no unit of mass"));
  CHECK(masses("Wash loss: 70 g\nSieve (mm),Weight retained\n4,0\n2,105\nPan,8\n") == "78 105 0");
}

TEST_CASE("a column of corrected masses, or of a split, is not passed over") {
  for (const std::string names :
       {"Factor,Corrected (g)", "Multiplier,Total (g)", "Dilution,Final", "Split,Whole (g)"})
    CHECK(contains(refusal("Sieve (mm),Mass retained (g)," + names +
                           "\n4,0,1,0\n2,80,1,80\n1,150,1,150\n0.5,12,10,120\nPan,0.8,10,8\n"),
                   "--columns SIZE,VALUE"));
  CHECK(masses("Sieve (mm),Mass retained (g),Siebsumme\n4,0,0\n2,80,80\n1,150,230\nPan,1,231\n") ==
        "1 150 80 0");
}

TEST_CASE("a column of ranges, dates or names beside the values is not one of numbers") {
  for (const std::string other : {"Spec\n4,0,95-100\n2,80,90-100\n1,150,44-54\nPan,8,",
                                  "Date\n4,0,12.05.2020\n2,80,2020-05-12\n1,150,2020-05-12\nPan,8,",
                                  "Test id\n4,0,1-1\n2,80,1-2\n1,150,1-3\nPan,8,"})
    CHECK(masses("Sieve (mm),Mass retained (g)," + other + "\n") == "8 150 80 0");
}

TEST_CASE("a column beside sizes that are ranges has no row of the top") {
  CHECK(masses("Size,Retained (g),Other\n2-4 mm,10,7\n1-2 mm,20,8\n0.5-1 mm,5,9\n") == "5 20 10 0");
  CHECK(contains(refusal("Size,Retained (g),Corrected\n2-4 mm,10,10\n1-2 mm,20,20\n0.5-1 mm,5,50\n"),
                 "choose one with"));
}

TEST_CASE("percents of the whole beside those of a part are not passed over") {
  for (const std::string name : {"Combined (%)", "Whole sample (%)", "N' (%)", "Gesamt (%)"})
    CHECK(contains(refusal("Sieve (mm),% passing," + name +
                           "\n8,100,100\n4,95,95\n2,79,79\n1,60,49\n0.5,50,25\n0.063,3.2,1.6\n"),
                   "choose one with --columns"));
  CHECK(masses("Sieve (mm),% passing,Limit\n8,100,100\n4,95,90\n2,79,70\n1,60,60\n") == "60 19 16 5 0");
}

TEST_CASE("a second table of percents of a part is refused") {
  const std::string coarse = "Sieve (mm),% passing\n4,100\n1,90\n0.063,70\n\n",
                    fines = "Particle size (mm),% finer\n0.02,62\n0.002,20\n";
  for (const std::string words :
       {"Sedimentation of fraction < 63 um", "Hydrometer analysis of the fines", "Percent of fines",
        "Minus No. 230 material", "Schl\u00e4mmanalyse des Feinanteils",
        "S\u00e9dimentom\u00e9trie sur le passant \u00e0 63 \u00b5m", "Part 2"}) {
    INFO(words);
    CHECK(contains(refusal(coarse + words + "\n" + fines), "a second table begins below"));
  }
  CHECK(masses(coarse + "Hydrometer\n" + fines) == "20 42 8 20 10 0");
}

TEST_CASE("percent passing decides where neither masses nor percent retained have a pan") {
  CHECK(masses("Sieve size (mm),Retained (g),% retained,% passing\n8,0,0.0,100\n4,25,5.0,95\n2,80,16.0,79\n"
               "1,150,30.0,49\n0.5,100,20.0,29\n0.063,70,14.0,15\n") == "15 14 20 30 16 5 0");
}

TEST_CASE("words of a part that was sieved, tested or taken are not passed over") {
  for (const std::string line :
       {"Fine fraction sieved (g),24.5", "Aliquot sieved: 24.5 g", "Quarter taken: 24.5 g", "Fine factor,10",
        "Test portion of minus 1 mm: 24.5 g", "Ratio total/sieved fines: 10", "1/10 of minus 1 mm sieved",
        "Prise d'essai < 1 mm: 24.5 g", "Fraccion fina ensayada (g),24.5"}) {
    INFO(line);
    CHECK(contains(refusal(line + "\n" + header + washed_stack), "may be of a part of the sample"));
  }
  CHECK(masses("Prise d'essai: 500 g\n" + header + washed_stack) == "8 12 35 70 120 150 80 25 0");
}

TEST_CASE("a second header may have another unit") {
  CHECK(
      masses(header +
             "8,0\n4,25\n2,80\n1,150\n\nSieve size (\u00b5m),Mass retained (g)\n500,120\n250,70\nPan,8\n") ==
      "8 70 120 150 80 25 0");
  CHECK(masses("AS Sieve (mm),Mass retained (g)\n4,0\n2,10\n") == "10 0");
}

TEST_CASE("what a remark says of masses is read") {
  const std::string stack = "4,0\n2,10\n1,30\n0.5,40\n0.25,15\nPan,5\n";
  CHECK(masses("Anmerkung: Waschverlust 20 g\n\n" + header + stack) == "25 15 40 30 10 0");
  CHECK(masses(header + stack + "Remarks: wash loss 20 g\n") == "25 15 40 30 10 0");
  CHECK(contains(refusal(header + stack + "Note: initial mass 120 g\n"), "120"));
}

TEST_CASE("columns of more names are compared") {
  for (const std::string name : {"Massenanteil (%)", "R\u00fcckst. %"}) {
    INFO(name);
    CHECK(contains(
        refusal("Sieve (mm),Mass retained (g)," + name + "\n4,0,0\n2,10,20\n1,30,30\n0.5,40,30\nPan,20,20\n"),
        "correct one"));
  }
}

} // namespace words_around_test
