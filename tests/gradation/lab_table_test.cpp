#include "gradation/lab_table.hpp"
#include "support.hpp"

namespace lab_table_test {

using namespace mdm;
using namespace mdm::test;

namespace {

Gradation read_with(const std::string &content, const Reading &reading) {
  return read_gradation(content, "sand.csv", reading);
}

std::string refusal_with(const std::string &content, const Reading &reading) {
  INFO(content);
  return message_of([&] { read_with(content, reading); });
}

Reading columns(const std::string &text) {
  Reading reading;
  reading.columns = text;
  return reading;
}

} // namespace

TEST_CASE("A sum that the rows have by their rounding alone is told with both numbers") {
  const Gradation g = read("Sieve (mm),Mass retained (g)\n0.4,0\n0.2,2\n0.1,1\nPan,0.5\nTotal,4.5\n");
  CHECK(
      g.notes().back() ==
      "The rows of 'Mass retained (g)' add up to 3.5, 'Total' says 4.5: their rounding may account for it.");
}

TEST_CASE("Openings of metres are refused unless the unit is said twice") {
  const std::string sheet = "Sieve (m),Mass retained (g)\n37.5,0\n19,120\n4.75,80\n";
  const std::string refused = refusal_with(sheet, {});
  CHECK(refused ==
        "sand.csv:2: the header 'Sieve (m)' gives an opening of 37.5 m: correct the unit in it, or say "
        "--unit m if it is right");
  Reading metres;
  metres.unit = "m";
  CHECK(read_with(sheet, metres).unit() == SizeUnit::m);
  CHECK(text(read("Sieve (m),Mass retained (g)\n2.5,0\n0.019,120\n0.00475,80\n").sizes()) ==
        "0.00475 0.019 2.5");
  CHECK(text(read("size_m,mass\n37.5,0\n19,120\n").sizes()) == "19 37.5"); // canonical
}

TEST_CASE("A sieve out of the order of the others is told") {
  const auto note = [](const std::string &third) {
    return read("Sieve (mm),Mass retained (g)\n9.5,0\n4.75,20\n" + third +
                ",60\n1.18,100\n0.6,150\nPan,10\n");
  };
  CHECK(has_note(note("0.236"), "The sieve in line 4 is out of the order"));
  CHECK(note("2.36").notes().size() == 1);
  // any order of all rows is one
  CHECK(read("Sieve (mm),Mass retained (g)\n0.6,150\n9.5,0\n1.18,100\n4.75,20\n2.36,60\nPan,10\n")
            .notes()
            .size() == 1);
  CHECK(read("Sieve (mm),Mass retained (g)\n0.6,150\n1.18,100\n2.36,60\n4.75,20\n9.5,0\nPan,10\n")
            .notes()
            .size() == 1);
}

TEST_CASE("Classes with what is above and below them") {
  CHECK(text(read("Size range (mm),Mass retained (g)\n>4.75,0\n4.75-2.36,60\n2.36-1.18,100\n<1.18,10\n")
                 .masses()) == "10 100 60 0");
  CHECK(text(read("Kornfraktion [mm];Rückstand [g]\n> 8;0,0\n8-4;60\n4-2;100\n< 2;10\n").masses()) ==
        "10 100 60 0");
  CHECK(contains(refusal("Kornfraktion [mm];Rückstand [g]\n8;0\n4;60\n2;100\nSchale;10\n"),
                 "is of classes, and its cells are single sizes"));
  CHECK(contains(refusal("Siebweite [mm];Rückstand [g]\n> 8;1\n8-4;60\n4-2;100\n< 2;10\n"),
                 "the largest sieve, 8 mm"));
  CHECK(contains(refusal("Siebweite [mm];Rückstand [g]\n> 16;0\n8-4;60\n4-2;100\n< 2;10\n"),
                 "write all alike"));
  CHECK(contains(refusal("Sieve (mm),Retained (g)\n>4.75,0\n2.36,60\n1.18,100\nPan,10\n"),
                 "'>4.75' is a range"));
  CHECK(contains(refusal("Sieve (mm),Retained (g)\n>,0\n4.75-2.36,60\n"),
                 "'>' is a range")); // found by fuzzing
  CHECK(contains(refusal("Size of it (mm),Retained (g)\n4.75,0\n2.36,60\n"),
                 "is not known to be a column of sieves"));
}

TEST_CASE("Cumulative masses without a unit are no percent") {
  const std::string sheet =
      "Sieve size (mm),Cumulative Wt. Retained\n25,0\n19,236.5\n9.5,1790.2\nPan,3425.0\n";
  CHECK(text(read(sheet).masses()) == "1634.8 1553.7 236.5 0");
}

TEST_CASE("A sum beside a mass of the sample is that of the rows") {
  const std::string table = "Sieve (mm),Mass retained (g)\n9.5,0\n4.75,290\n2.36,200\nPan,8\n";
  const Gradation g = read("Mass of sample 500 g\nSum of masses 498 g\n" + table);
  CHECK(has_note(g, "add up to 498 as 'Sum of masses' says"));
  CHECK(contains(refusal("Mass of sample 500 g\nSum of masses 480 g\n" + table), "'Sum of masses' says 480"));
  CHECK(has_note(read(table + "Losses,2\nTotal,500\n"), "'Total' says 500: that is with what was lost."));
}

TEST_CASE("Words of the pan, and a sieve with a degree sign") {
  for (const char *row : {"Siebpfanne", "Auffangboden", "Raccoglitore", "Matériau restant au fond P",
                          "Rückstand in der Auffangschale P"})
    CHECK(text(read("Sieve (mm),Retained (g)\n4,0\n0.063,30\n" + std::string(row) + ",7\n").masses()) ==
          "7 30 0");
  CHECK(text(read("Tamiz,Retenido (g)\nN°4,0\nN°200,30\nPasa N°200,7\n").masses()) == "7 30 0");
  CHECK(text(read("Sieve (mm),Retained (g)\n4,0\n2,30\nPan,7\nΣ =,37\n").masses()) == "7 30 0");
}

TEST_CASE("A limit that equals a mass by chance is no corrected mass") {
  CHECK(text(read("Sieve (mm),Mass retained (g),% passing spec min,% passing spec "
                  "max\n10,0,100,100\n5,20,89,100\n"
                  "2.36,60,60,100\n0.15,400,0,15\nPan,20,,\n")
                 .masses()) == "20 400 60 20 0");
}

TEST_CASE("A column of sums has any word for them") {
  for (const char *header : {"Rückstand aufsummiert (g)", "Trattenuti cumulati (g)", "Cum. retained (g)"})
    CHECK(text(read("Sieve (mm)," + std::string(header) + "\n4,0\n2,10\n1,30\nPan,60\n").masses()) ==
          "30 20 10 0");
}

TEST_CASE("A German sieving: titles, semicolons, decimal commas, pan and sum") {
  const Gradation g =
      read("Siebanalyse nach DIN EN 933-1\nProbe:;BK 3/2\n\nSiebweite [mm];Rückstand [g];Bemerkung\n"
           "2,0;0;\n0,63;12,4;\n0,063;30,1;feucht\nSchale;7,5;\nSumme;50,0;\n");
  CHECK(text(g.sizes()) == "0 0.063 0.63 2");
  CHECK(text(g.masses()) == "7.5 30.1 12.4 0");
  CHECK(g.unit() == SizeUnit::mm);
  CHECK(g.notes()[0] ==
        "Read as text with ; between cells: sizes from column 'Siebweite [mm]', in mm; masses from "
        "column 'Rückstand [g]': mass.");
  CHECK(g.notes()[1] == "The rows of 'Rückstand [g]' add up to 50 as 'Summe' says.");
  CHECK(g.notes()[2] == "Columns that were not used: 'Bemerkung'; --columns chooses others.");
  CHECK(g.notes().size() == 3);
}

TEST_CASE("An English sieving with tabs, percent signs and quoted cells") {
  const Gradation g =
      read("\"Sieve size (mm)\"\t\"Sample\"\t\"% passing\"\n4.75\tA\t100%\n\"0.075\"\tA\t4.5 %\n");
  CHECK(text(g.sizes()) == "0 0.075 4.75");
  CHECK(text(g.masses()) == "4.5 95.5 0");
}

TEST_CASE("A row of units, quoted commas, micrometres") {
  const Gradation g = read("Size,% Volume In\n(µm),\n\"0,5\",\"1,25\"\n1,\"98,75\"\n2,0\n");
  CHECK(g.unit() == SizeUnit::um);
  CHECK(text(g.sizes()) == "0.5 1 2");
  CHECK(text(g.masses()) == "1.25 98.75 0");
}

TEST_CASE("Names of sieves and cells with units") {
  const Gradation g = read("Sieve No.,Mass retained (g)\n3/8 in.,0\n#4,1\nNo. 200,2\n63 µm,3\nPan,4\n");
  CHECK(text(g.sizes()) == "0 0.063 0.075 4.75 9.5");
  CHECK(text(g.masses()) == "4 3 2 1 0");
}

TEST_CASE("The rows of a hydrometer below belong to the same curve") {
  const std::string sieves = "Sieve size (mm),Percent finer\n2,100\n0.075,40\n";
  CHECK(text(read(sieves + "0.02,21\n0.002,5\n").sizes()) == "0 0.002 0.02 0.075 2");
  CHECK(contains(refusal(sieves + "Hydrometer,\n0.02,21\n0.002,5\n"), "'Hydrometer' is among the rows"));
  CHECK(text(read(sieves + "\nHydrometer\nDiameter (µm),Percent finer\n20,21\n2,5\n").sizes()) ==
        "0 0.002 0.02 0.075 2");
  CHECK(contains(
      refusal(sieves + "\nSieve size (mm),Percent retained\n1,20\n"),
      "sand.csv:5: a second table begins, with 'Percent retained' where the first has 'Percent finer'"));
}

TEST_CASE("A column that is named needs no known header where this has a unit of length") {
  const std::string file = "Korngröße d [mm];Rückstand [g];n\n2;0;1\n1;3;2\n0,5;4;3\n";
  const Gradation g = read_with(file, columns("Korngröße d [mm],Rückstand [g]"));
  CHECK(text(g.sizes()) == "0.5 1 2");
  CHECK(text(g.masses()) == "4 3 0");
  CHECK(contains(message_of([&] { read_with(file, columns("n,Rückstand [g]")); }),
                 "does not say in known words what the column of sizes"));
}

TEST_CASE("Masses that never fall towards the fines are cumulative, or confirmed by something else") {
  const std::string rows = "\n4,0\n2,5\n1,9\n0.5,20\n0.25,31\n0.125,40\n";
  CHECK(contains(
      refusal("Opening (mm),Retained (g)" + rows),
      "no sieve retains less than the next coarser one, as in a cumulative column: say --kind cumulative if "
      "'Retained (g)' is one, else --kind retained"));
  CHECK(text(read("Opening (mm),Retained (g)" + rows + "Total,105\n").masses()) == "40 31 20 9 5 0");
  CHECK(read("Opening (mm),Retained (g)\n4,0\n2,5\n1,9\n0.5,20\n0.25,31\n0.125,30\n").notes().size() == 1);
}

TEST_CASE("A name and an opening of one row are of one sieve") {
  CHECK(text(read("Sieve,Opening (mm),Retained (g)\n1/2 in,12.7,0\nNo. 4,4.76,3\nNo. 200,0.074,1\n")
                 .masses()) == "1 3 0");
  CHECK(contains(
      refusal("Sieve,Opening (mm),Retained (g)\nNo. 4,4.75,0\nNo. 200,0.106,1\n"),
      "sand.csv:3: 'No. 200' in the column 'Sieve' is another sieve than '0.106' in 'Opening (mm)'"));
}

TEST_CASE("Of several columns mass retained comes first, and the note names the others") {
  const Gradation g = read("Sieve,Opening (mm),Retained (g),% retained,% passing\nNo. 4,4.75,0,0,100\n"
                           "No. 200,0.075,30,60,40\nPan,,20,40,\n");
  CHECK(text(g.masses()) == "20 30 0");
  CHECK(has_note(g, "Columns that were not used: 'Sieve'; --columns chooses others."));
  CHECK(text(read_with("Opening (mm),Retained (g),% passing\n4.75,0,100\n0.075,30,40\n", columns("1,3"))
                 .masses()) == "40 60 0");
  CHECK(contains(refusal("Size (mm),Passing (%),Finer (%)\n1,100,100\n0.5,3,4\n"),
                 "sand.csv:1: the columns 'Passing (%)' and 'Finer (%)' have one meaning"));
}

TEST_CASE("A pan without a value says nothing of what passes, but must have a mass") {
  CHECK(text(read("Size (mm),% passing\n2,100\n1,40\nPan,\n").masses()) == "40 60 0");
  CHECK(contains(refusal("Size (mm),Mass (g)\n2,0\n1,40\nPan,\n"),
                 "sand.csv:4: '' in the column 'Mass (g)' is not a number"));
}

TEST_CASE("Cumulative masses are taken apart") {
  const Gradation g = read("Sieve size (mm),Cumulative mass retained (g)\n2,0\n1,10\n0.5,25\npan,40\n");
  CHECK(text(g.masses()) == "15 15 10 0");
  CHECK(contains(refusal("Sieve size (mm),Cumulative mass retained (g)\n2,0\n1,10\n0.5,5\n"),
                 "sand.csv:4: cumulative mass 5 is below 10 of the next coarser sieve"));
}

TEST_CASE("One number whose sign stands between no thousands tells of all") {
  CHECK(text(read("Siebweite [mm];Rückstand [g]\n4;0\n2;1.250\n1;0.850\n").masses()) == "0.85 1.25 0");
  CHECK(text(read("Size (mm),Mass (g)\n4,0\n2,1.250\n1,850\n").masses()) == "850 1.25 0");
}

TEST_CASE("What is not certain is not guessed") {
  CHECK(contains(
      refusal("Sieve size,% passing\n2,100\n1,50\n"),
      "sand.csv:2: the size '2' has no unit, and neither has the column 'Sieve size': say it with --unit"));
  CHECK(contains(refusal("Size (mm),passing\n2,1\n1,0.5\n"),
                 "may be percent or fractions, its largest value is 1"));
  CHECK(contains(refusal("Size (mm),% retained\n2,0\n1,60\n0.5,100\n"),
                 "percent retained add up to 160: if '% retained' is cumulative, say --kind cumulative"));
  CHECK(contains(refusal("Size (mm)\tMass (g)\n2\t0\n1\t1,234\n"),
                 "the number '1,234' may have a decimal comma or thousands"));
  CHECK(contains(refusal("Siebweite [mm];Rückstand [g]\n4;0\n2;1.250\n1;850\nSchale;350\n"),
                 "the number '1.250' may have a decimal point or thousands"));
  CHECK(contains(refusal("Siebweite [µm];Rückstand [g]\n4.000;0\n2.000;20\n500;40\n"),
                 "the number '4.000' may have a decimal point or thousands"));
  CHECK(contains(refusal("Sieve No.,% passing\n4,100\n200,5\n"), "write No. 4 if it is one of ASTM"));
  CHECK(contains(refusal("Size (mm);Mass (g)\n2,5;0\n1.5;1\n"), "have different decimal signs"));
  const std::string unknown = refusal("Korn;Wert\n2;0\n1;3\n");
  CHECK(contains(unknown, "the file begins 'Korn | Wert', '2 | 0', '1 | 3'"));
  CHECK(contains(unknown, "--columns SIZE,VALUE"));
}

TEST_CASE("Lines beyond the file cannot be left out") {
  Reading most;
  most.skip = 100;
  CHECK(contains(refusal_with("Korn;Wert\n2;0\n1;3\n", most),
                 "--skip 100 leaves out all that is written in the file"));
}

TEST_CASE("The options say it") {
  Reading all = columns("Korn,Wert");
  all.unit = "mm";
  all.kind = "passing";
  CHECK(text(read_with("Titel\nKorn;x;Wert\n2;9;100\n1;9;40,5\n", all).masses()) == "40.5 59.5 0");
  all.columns = "1,3";
  CHECK(text(read_with("2;9;100\n1;9;40,5\n", all).masses()) == "40.5 59.5 0");
  all.skip = 2;
  CHECK(text(read_with("9;9;9\n8;8;8\n2;9;100\n1;9;40,5\n", all).masses()) == "40.5 59.5 0");
  Reading um;
  um.unit = "um";
  CHECK(read_with("Size,% passing\n2,100\n1,50\n", um).unit() == SizeUnit::um);
  Reading fraction;
  fraction.kind = "passing_fraction";
  CHECK(text(read_with("Size (mm),passing\n2,1\n1,0.5\n", fraction).masses()) == "0.5 0.5 0");
  Reading cumulative;
  cumulative.kind = "cumulative";
  CHECK(text(read_with("Size (mm),% retained\n2,0\n1,60\n0.5,100\n", cumulative).masses()) == "40 60 0");
}

TEST_CASE("Options that do not serve are refused") {
  const std::string table = "Size (mm),x\n2,100\n1,50\n";
  CHECK(contains(refusal_with(table, columns("1")), "--columns: '1' is not two columns"));
  CHECK(contains(refusal_with(table, columns("1,1")), "names one column twice"));
  CHECK(contains(refusal_with(table, columns("1,2")),
                 "'x' does not say in known words what the column of masses holds: add --kind"));
  CHECK(contains(refusal_with(table, columns("1,y")), "sand.csv:1: --columns: no header has '1,y'"));
  Reading reading;
  reading.kind = "weight";
  CHECK(contains(refusal_with(table, reading), "--kind: 'weight' is none of passing, retained"));
  reading.kind.reset();
  reading.unit = "km";
  CHECK(contains(refusal_with(table, reading), "--unit: 'km' is none of mm, um"));
  CHECK(contains(refusal_with("{\"sizes\":[1,2],\"masses\":[1,0]}", reading), "are for tables"));
  Reading sheet;
  sheet.sheet = "A";
  CHECK(contains(refusal_with(table, sheet), "--sheet is for workbooks"));
}

TEST_CASE("Rows that are wrong are refused with their line and what to do") {
  const std::string head = "Size (mm),Mass (g)\n4,0\n";
  CHECK(contains(refusal(head + "<0.1,5\n"),
                 "sand.csv:3: the row '<0.1' is of what passes 0.1 mm, and the finest sieve is 4 mm"));
  CHECK(contains(refusal(head + ">0.1,5\n"), "sand.csv:3: the size '>0.1' is a range"));
  CHECK(contains(refusal(head + "1,\n"),
                 "sand.csv:3: the size '1' has no value in the column 'Mass (g)': write 0"));
  CHECK(
      contains(refusal(head + "1,trace\n"), "sand.csv:3: 'trace' in the column 'Mass (g)' is not a number"));
  CHECK(contains(refusal(head + "D50,0.3\n"), "sand.csv:3: 'D50' is no sieve"));
  CHECK(contains(refusal(head + "1,5%\n"), "sand.csv:3: '5%' has another unit than the column 'Mass (g)'"));
  CHECK(contains(refusal(head + "0,5,3\n"),
                 "sand.csv:3: the row has more cells than the header, 2: '3' is beyond"));
  CHECK(contains(refusal(head + "1,2\n1,3\n"), "size 1 mm repeats that of line 3"));
  CHECK(contains(refusal("Size (mm),Mass (g)\n"), "there is no row with a size and a number"));
  CHECK(contains(refusal("Size (mm),Passing (g)\n1,2\n"), "the mass that passes is given"));
}

TEST_CASE("Below an empty row what has no size is left") {
  const Gradation g = read("Size (mm),Mass (g)\n2,0\n1,5\n\nD50,0.3\nCu,\nRemarks,none\n");
  CHECK(text(g.sizes()) == "1 2");
  CHECK(has_note(g, "Rows that are no sizes were left out: 'D50', 'Cu', 'Remarks'."));
}

TEST_CASE("A table of something else below is not taken for a part of the curve") {
  CHECK(contains(refusal("Size (mm),Mass (g)\n2,0\n1,5\n\nAge,Strength\n7,30\n28,41\n"),
                 "sand.csv:6: the row of '7' is below 'Age', which may begin another table"));
  CHECK(contains(refusal("Size (mm),Mass (g)\n2,0\n1,5\nAge,Strength\n"), "'Age' is no sieve"));
}

TEST_CASE("Below an empty row, too, nothing that looks like a size is left") {
  const std::string table = "Size (mm),Mass (g)\n2,0\n1,5\n\n";
  CHECK(contains(refusal(table + "<0.063,2\n"), "sand.csv:5: the row '<0.063' is of what passes 0.063 mm"));
  CHECK(contains(refusal(table + "0.02*,2\n"), "sand.csv:5: '0.02*' is no sieve"));
}

TEST_CASE("Cumulative masses are rounded before they are taken apart") {
  Reading two;
  two.round = 2;
  CHECK(text(read_with("Size (mm),Cumulative mass retained (g)\n2,0\n1,10.4\n0.5,99.6\n", two).masses()) ==
        "90 10 0");
}

TEST_CASE("Grams and kilograms do not go together") {
  CHECK(contains(refusal("Size (mm),Mass (g)\n2,0\n1,1.2 kg\n0.5,300 g\n"),
                 "sand.csv:3: '1.2 kg' is in another unit of mass than the column 'Mass (g)'"));
  CHECK(contains(refusal("Size (mm),Mass\n2,0\n1,1.2 kg\n0.5,300 g\n"),
                 "sand.csv:4: '300 g' is in another unit"));
  CHECK(text(read("Size (mm),Mass (kg)\n2,0\n1,1.2 kg\n0.5,3 kg\n").masses()) == "3 1.2 0");
}

TEST_CASE("Values with and without a unit do not go together") {
  CHECK(contains(refusal("Size (mm),Retained\n2,0\n1,0.45\n0.5,55%\n"),
                 "sand.csv:4: some values in the column"));
  CHECK(text(read("Size (mm),Retained\n2,0\n1,45%\n0.5,55%\n").masses()) == "55 45 0");
}

TEST_CASE("A total that the rows do not add up to is refused, unless a loss is allowed") {
  const std::string sheet = "Size (mm),Mass (g)\n2,0\n1,500.0\nTotal,501.0\n";
  Reading allowed;
  allowed.loss = 1;
  CHECK(contains(refusal(sheet), "sand.csv:4: the rows of 'Mass (g)' add up to 500, and 'Total' says 501, a "
                                 "difference of 0.2 percent of that"));
  CHECK(has_note(read_with(sheet, allowed),
                 "The rows of 'Mass (g)' add up to 500, 'Total' says 501: 0.2 percent "
                 "less; the rows are used."));
  CHECK(contains(refusal("Size (mm),Mass (g)\n2,0\n1,5.0\nTotal,6.0\n"),
                 "the rows of 'Mass (g)' add up to 5, and 'Total' says 6"));
}

TEST_CASE("Latin-1 and UTF-16 are read, and mdm-check reads neither") {
  const std::string latin = "Siebweite [mm];R\xFC"
                            "ckstand [g]\n2;0\n1;3,5\n";
  const UnderstoodGradation u = understand_gradation(latin, "sand.csv");
  CHECK(u.format == "text with ; between cells, Windows-1252 (Latin-1)");
  CHECK_FALSE(u.is_canonical);
  CHECK(u.masses == "column 'Rückstand [g]': mass");
  std::string wide = "\xFF\xFE";
  for (const char c : std::string("size_mm,mass\n1,1\n2,0\n"))
    wide += {c, '\0'};
  CHECK_FALSE(understand_gradation(wide, "sand.csv").is_canonical);
  CHECK(understand_gradation("size_mm,mass\n1,1\n2,0\n", "sand.csv").is_canonical);
}

TEST_CASE("Rounding takes the masses before anything else") {
  Reading three;
  three.round = 3;
  const Gradation g = read_with("size_mm,passing_percent\n1,33.3333\n2,99.99\n", three);
  CHECK(text(g.masses()) == "33.3 66.7 0");
  CHECK(g.roundings()[1] == ratio(5, 100));
  CHECK(has_note(g, "All percent passing values were taken to 3 significant digits; classes have their "
                    "differences."));
  CHECK(text(read_with("{\"sizes\":[1,2],\"masses\":[0.30000000000000004,0]}", three).masses()) == "0.3 0");
  CHECK(contains(
      refusal("size_mm,passing_fraction\n1,0.5\n2,0.9999999999999999\n"),
      "add a row for a larger sieve with fraction passing 1, or take all values to 15 digits with --round "
      "15"));
  CHECK(contains(refusal("size_mm,passing_percent\n1,50\n2,99.99\n"), "--round 3"));
}

TEST_CASE("An option that says otherwise than the header is refused") {
  Reading um, mm, passing, cumulative, percent, sieve;
  um.unit = "um";
  mm.unit = "mm";
  sieve.unit = "sieve";
  passing.kind = "passing";
  cumulative.kind = "cumulative";
  percent.kind = "retained_percent";
  const std::string rows = "\n2,0\n1,60\n0.5,40\n";
  for (const std::string header :
       {"Size (mm),Mass (g)", "size_mm,mass", "Siebweite in mm,Masse", "sieve (mm),retained_g"}) {
    CHECK(contains(refusal_with(header + rows, um), "sand.csv:1: --unit um: the column"));
    CHECK(contains(refusal_with(header + rows, um), "is in mm: leave the option out"));
    CHECK(text(read_with(header + rows, mm).masses()) == "40 60 0");
  }
  CHECK(contains(refusal_with("size_um,mass" + rows, mm), "--unit mm: the column 'size_um' is in um"));
  CHECK(contains(refusal_with("size_in,mass" + rows, mm), "--unit mm: the column 'size_in' is in in"));
  CHECK(contains(refusal_with("Size (mm),Mass (g)" + rows, sieve), "--unit sieve: the column"));
  CHECK(contains(refusal_with("Size,Mass\nmm,g" + rows, um), "is in mm: leave the option out"));
  CHECK(contains(refusal_with("Size (mm),Mass (g)" + rows, passing),
                 "sand.csv:1: --kind passing: the column 'Mass (g)' is what each sieve retains, in a mass"));
  CHECK(contains(refusal_with("size_mm,mass" + rows, passing), "--kind passing: the column 'mass'"));
  CHECK(contains(refusal_with("Size (mm),Mass (g)" + rows, percent), "--kind retained_percent"));
  CHECK(contains(refusal_with("Size (mm),Individual retained (g)" + rows, cumulative), "--kind cumulative"));
  CHECK(contains(refusal_with("Size (mm),Foo (g)" + rows, percent), "--kind retained_percent"));
  CHECK(text(read_with("Size (mm),Retained (g)\n2,0\n1,40\n0.5,60\n", cumulative).masses()) == "20 40 0");
  CHECK(text(read_with("Size (mm),Retained (g),Note\n2,0,a\n1,40,b\n0.5,60,c\n", cumulative).masses()) ==
        "20 40 0");
  Reading named = columns("D [mm],Foo");
  named.unit = "um";
  named.kind = "mass";
  CHECK(contains(refusal_with("D [mm],Foo" + rows, named), "--unit um: the column 'D [mm]' is in mm"));
}

TEST_CASE("A row of units that says otherwise than the header is refused") {
  CHECK(contains(refusal("Size (mm),Mass (g)\num,\n2,0\n1,60\n"),
                 "sand.csv:2: below the header 'Size (mm)' stands 'um', which is another unit"));
  CHECK(text(read("Size (mm),Mass (g)\nmm,g\n2,0\n1,60\n").masses()) == "60 0");
}

TEST_CASE("Micrometres below millimetres in one column are refused, with a hint") {
  const std::string hint = "if some are um and others mm, write the unit behind each";
  CHECK(contains(refusal("BS test sieve (mm),Mass retained (g)\n2,0\n1.18,5\n600,9\n300,20\n63,8\npan,1\n"),
                 "sand.csv:4: the sizes 1.18 and 600 follow each other in the column 'BS test sieve (mm)': " +
                     hint));
  CHECK(contains(refusal("Size (mm),Mass (g)\n63,1\n600,8\n1.18,20\n2,0\n"), hint));
  CHECK(text(read("BS test sieve (mm),Mass retained (g)\n2,0\n1.18,5\n600 um,9\n63 \u00B5m,8\n").sizes()) ==
        "0.063 0.6 1.18 2");
  CHECK(text(read("Size (mm),Mass (g)\n1,5\n4,0\n2,3\n0.5,1\n").sizes()) == "0.5 1 2 4");
  CHECK(text(read("Size (mm),Mass (g)\n31.5,5\n63,0\n16,3\n").sizes()) == "16 31.5 63");
  CHECK(text(read("Size (mm),Mass (g)\n63,0\n31.5,3\n2,4\n1,5\n").sizes()) == "1 2 31.5 63");
}

TEST_CASE("Ranges of sizes hold what their lower sieve retains") {
  const std::string h = "Sieve size (mm),Mass retained (g)\n";
  for (const std::string rows :
       {"4.75-2.36,10\n2.36-1.18,20\nPan,5\n", "2.36 - 4.75,10\n1.18 - 2.36,20\npan,5\n",
        "4.75 mm - 2.36 mm,10\n2.36 to 1.18 mm,20\n0-1.18,5\n",
        "4.75,0\n4.75\u20132.36,10\n2.36\u20131.18,20\npan,5\n"}) {
    INFO(rows);
    const Gradation g = read(h + rows);
    CHECK(text(g.sizes()) == "0 1.18 2.36 4.75");
    CHECK(text(g.masses()) == "5 20 10 0");
    CHECK(has_note(g, "Sizes are ranges: each mass stays on the lower sieve."));
  }
  CHECK(contains(refusal(h + "4.75-2.36,10\n2-1.18,20\n"),
                 "the range from 2.36 does not begin where the next finer one ends, at 2"));
  CHECK(contains(refusal(h + "4.75-2.36,10\n1.18,20\n"), "some sizes are ranges and this is none"));
  CHECK(contains(refusal("Sieve size (mm),% passing\n4.75-2.36,100\n2.36-1.18,20\n"),
                 "the sizes are ranges, but the values"));
  CHECK(contains(refusal("Siebweite (\u00B5m);Masse (g)\n4.750-2.360;10\n2.360-1.180;20\n"),
                 "may have a decimal point or thousands"));
  CHECK(text(read("Sieve,Mass (g)\nNo. 3-1/2,0\n#4,3\n").sizes()) == "4.75 5.6");
}

TEST_CASE("A table with its sieves in a row") {
  const Gradation g =
      read("Sample 7\nSieve size (mm),4.75,2.36,1.18,Pan\nMass retained (g),0,10,20.5,5\nNote,a\n");
  CHECK(text(g.sizes()) == "0 1.18 2.36 4.75");
  CHECK(text(g.masses()) == "5 20.5 10 0");
  CHECK(has_note(
      g, "Read as text with , between cells, sieves in a row: sizes from column 'Sieve size (mm)', in mm"));
  CHECK(text(read("Siebweite;mm;2,0;0,63;0,063\nDurchgang;%;100;40,5;3\n").masses()) == "3 37.5 59.5 0");
  CHECK(contains(
      refusal("Sieve size (mm),4.75,2.36\nMass retained (g),0,10\nSieve size (mm),1.18,0.6\nMass (g),3,4\n"),
      "sand.csv:1: the columns 'Sieve size (mm)' and 'Sieve size (mm)' have one meaning"));
  CHECK(contains(refusal("Sieve size (mm),4.75,2.36\nMass retained (g),0,10,20\n"),
                 "sand.csv:1: '' is no sieve"));
  CHECK(contains(refusal("Sieve size,4.75,2.36\nMass retained (g),0,10\n"), "the size '4.75' has no unit"));
}

TEST_CASE("Names of sieves as laboratories spell them") {
  const Gradation g = read("Sieve,Mass retained (g)\n1-in.,0\n3/4-in.,1\n\"3/8\"\"\",2\nNo. 4 "
                           "(4.75mm),3\nNo.10,5\n75 microns,4\n");
  CHECK(text(g.sizes()) == "0.075 2 4.75 9.5 19 25");
  CHECK(contains(refusal("Sieve,Mass retained (g)\n1-in.,0\nNo. 4 (2 mm),1\n"), "sand.csv:3: the names in"));
}

TEST_CASE("Masses under Ri that never fall may be cumulative") {
  const std::string h = "Sieve size (mm),Ri (g)\n4,0\n";
  CHECK(text(read(h + "2,10\n1,30\n0.5,20\n").masses()) == "20 30 10 0");
  CHECK(contains(refusal(h + "2,10\n1,30\n0.5,40\n"), "say --kind retained or --kind cumulative"));
  Reading retained;
  retained.kind = "retained";
  CHECK(text(read_with(h + "2,10\n1,30\n0.5,40\n", retained).masses()) == "40 30 10 0");
}

TEST_CASE("A header of mm above sieves in um is refused, unless --unit mm says it is right") {
  const std::string sheet = "Sieve size (mm),Mass retained (g)\n600,0\n300,10\n63,20\nPan,5\n";
  CHECK(
      contains(refusal(sheet), "sand.csv:2: the column 'Sieve size (mm)' is in mm, and its sizes are those"));
  Reading mm;
  mm.unit = "mm";
  CHECK(text(read_with(sheet, mm).sizes()) == "0 63 300 600");
  CHECK(text(read("Sieve size (mm),Mass retained (g)\n300,0\n75,10\n4.75,20\nPan,5\n").sizes()) ==
        "0 4.75 75 300");
}

TEST_CASE("A second column of the same words is another sample, and must be chosen") {
  const auto sheet = [](const std::string &headers) {
    return "Sieve size (mm)," + headers + "\n2,100,100\n1,50,40\n0.5,10,5\n";
  };
  for (const char *headers :
       {"% passing A,% passing B", "% passing,% passing B", "% passing,BH2 3.5 m % passing"})
    CHECK(contains(refusal(sheet(headers)), "may be of two samples"));
  CHECK(text(read_with(sheet("% passing,% passing B"), columns("1,2")).masses()) == "10 40 50 0");
  CHECK(text(read(sheet("% passing,Min % passing")).masses()) == "10 40 50 0");
}

TEST_CASE("A header that ends in a unit is no row of units below another") {
  const Reading first = columns("1,2");
  Reading in_mm = first;
  in_mm.kind = "mass";
  in_mm.unit = "mm";
  const std::string sheet = "Size (um),Grams\n8000,0\n4000,5\n";
  CHECK(contains(refusal_with(sheet, in_mm), "the column 'Size (um)' is in um"));
  CHECK(contains(refusal_with(sheet, first),
                 "'Grams' does not say in known words what the column of masses holds"));
  CHECK(contains(message_of([&] { read_with("8,0\n4,5\n", first); }),
                 "no header says what the column of sizes holds"));
}

TEST_CASE("Units in a row of their own tell two columns of one name apart") {
  CHECK(text(read("Siebweite;Rückstand;Rückstand\n[mm];[g];[%]\n8;0;0\n4;25;25\n2;75;75\n").masses()) ==
        "75 25 0");
  CHECK(contains(refusal("Siebweite;Rückstand;Rückstand\n[mm];[g];[g]\n8;0;0\n4;25;25\n2;75;75\n"),
                 "have one meaning"));
}

TEST_CASE("A column that may be cumulative or not is refused until the user says which") {
  const std::string sheet = "Tamis (mm);Refus (g);Notes\n8;0;\n4;12,3;\n2;55,1;\n";
  CHECK(contains(refusal(sheet),
                 "sand.csv:1: 'Refus (g)' may be what each sieve retains, or what all coarser ones "
                 "retain too: say --kind retained or --kind cumulative"));
  Reading reading;
  reading.kind = "retained";
  CHECK(text(read_with(sheet, reading).masses()) == "55.1 12.3 0");
  reading.kind = "cumulative";
  CHECK(text(read_with(sheet, reading).masses()) == "42.8 12.3 0");
  reading.kind = "passing";
  CHECK(contains(refusal_with(sheet, reading), "--kind passing"));
}

} // namespace lab_table_test
