#include "support.hpp"

namespace table_accounts_test {

using namespace mdm;
using namespace mdm::test;

namespace {

const std::string rows = "2,0\n1,200.0\n0.5,250.0\n0.063,171.8\n";
const std::string header = "Sieve size (mm),Mass retained (g)\n";

Gradation read_with(const std::string &content, const Reading &reading) {
  return read_gradation(content, "sand.csv", reading);
}

Reading kind(const std::string &text) {
  Reading reading;
  reading.kind = text;
  return reading;
}

Reading loss(const Rational &percent) {
  Reading reading;
  reading.loss = percent;
  return reading;
}

} // namespace

TEST_CASE("Rows that begin with # and a digit are sieves and never comments") {
  CHECK(text(read("Sieve,Mass retained (g)\n# as received\n3/8 in,0\n#4,50\n#10,120\n# "
                  "40,210\n\"#200\",100\nPan,20\n")
                 .masses()) == "20 100 210 120 50 0");
  CHECK(text(read("Sieve\tMass retained (g)\n3/8 in\t0\n#4\t50\n#200\t100\n").masses()) == "100 50 0");
  CHECK(contains(refusal("Sieve,Mass retained (g)\n3/8 in,0\n#4711,50\n#200,100\n"), "sand.csv:3: '#4711'"));
  CHECK(
      contains(refusal("Sieve,Mass retained (g)\n3/8 in,0\n#4 a b,50\n#200,100\n"), "sand.csv:3: '#4 a b'"));
}

TEST_CASE("Without a row of the pan percent passing says what passes the finest sieve") {
  const Gradation g =
      read("Sieve size (mm),Mass retained (g),% passing\n2,0,100.0\n1,200,60.0\n0.075,244.5,11.1\n");
  CHECK(text(g.masses()) == "11.1 48.9 40 0");
  CHECK(has_note(
      g, "The masses in 'Mass retained (g)' have no row of the pan; '% passing' decides, where 11.1 percent "
         "pass the finest sieve, 0.075 mm."));
  CHECK(
      text(read_with("Sieve size (mm),Mass retained (g),% passing\n2,0,100.0\n1,200,60.0\n0.075,244.5,11.1\n",
                     kind("mass"))
               .masses()) == "11.1 48.9 40 0");
  CHECK(contains(
      refusal("Size (mm),Mass retained (g),% passing\n2,0,100\n1,200,\n0.5,100,40\n0.075,144.5,11.1\n"),
      "has empty cells"));
}

TEST_CASE("Masses and percent that differ are refused with both readings, unless one is asked for") {
  const std::string sheet =
      "Size (mm),Mass retained (g),% passing\n2,0,100\n1,290,52\n0.5,110,26\n0.25,50,10\nPan,50,0\n";
  const std::string message = refusal(sheet);
  CHECK(contains(message,
                 "sand.csv:1: at 1 mm 42 percent pass by the column 'Mass retained (g)', 52 by '% passing'"));
  CHECK(contains(message, "--kind mass or --kind passing_percent"));
  const Gradation g = read_with(sheet, kind("passing"));
  CHECK(has_note(g, "at 1 mm 42 percent pass by the column 'Mass retained (g)', 52 by '% passing'"));
  CHECK(text(g.masses()) == "10 16 26 48 0");
}

TEST_CASE("A column that is only compared has the decimal sign of its own digits") {
  const std::string head = "Sieve (um)\tMass retained (g)\t% passing\n";
  CHECK(
      contains(refusal(head + "Pan\t60\t\n80\t50\t5,5\n100\t40\t30,5\n200\t0\t100,0\n"), "percent pass by"));
  CHECK(has_note(read(head + "Pan\t10\t\n80\t50\t6,25\n100\t100\t37,50\n200\t0\t100,00\n"),
                 "Columns that agree"));
}

TEST_CASE("Columns agree within the rounding of their digits") {
  const std::string sheet =
      "Size (mm),Mass retained (g),% retained,Cumulative % retained,% passing\n"
      "4,0,0,0,100\n2,33.4,11,11,89\n1,66.7,22,33,67\n0.5,99.9,33,67,33\n0.063,80,27,93,7\n"
      "Pan,20,7,100,0\nTotal,300.0,100,,\n";
  const Gradation g = read(sheet);
  CHECK(text(g.masses()) == "20 80 99.9 66.7 33.4 0");
  CHECK(has_note(g,
                 "Columns that agree within the rounding of their digits: 'Mass retained (g)', '% passing', "
                 "'Cumulative % retained', '% retained'."));
  CHECK(contains(
      refusal("Size (mm),Mass retained (g),% passing\n4,0,100.0\n2,100,66.7\n1,100,33.4\nPan,110,0.0\n"),
      "the percent in '% passing' are of 297.9 to 302.71"));
}

TEST_CASE("Percent may be of the dry mass, of which a little was lost") {
  const std::string sheet =
      "Dry mass (g),501.0\nSize (mm),Mass retained (g),% passing\n2,0,100.0\n1,200.0,60.1\n"
      "0.5,250.0,10.2\nPan,49.0,\n";
  const Gradation g = read(sheet);
  CHECK(text(g.masses()) == "49 250 200 0");
  CHECK(has_note(g,
                 "The rows of 'Mass retained (g)' add up to 499, 'Dry mass (g)' says 501: 0.4 percent less"));
}

TEST_CASE("Cumulative masses that end below a total are not lost in silence") {
  const std::string sheet = "Size (mm),Cumulative mass retained (g)\n2,0\n1,40\n0.5,95\nTotal,120\n";
  CHECK(contains(refusal(sheet),
                 "sand.csv:5: the rows of 'Cumulative mass retained (g)' add up to 95, and 'Total' says "
                 "120, a difference of 20.83 percent of that: write the row 'pan' or 'Wash loss'"));
  CHECK(text(read("Size (mm),Cumulative mass retained (g)\n2,0\n1,40\n0.5,95\nPan,120\nTotal,120\n")
                 .masses()) == "25 55 40 0");
  CHECK(contains(refusal("Size (mm),Cumulative mass retained (g)\n2,0\n1,40\n0.5,95\nPan,25\n"),
                 "which is cumulative"));
}

TEST_CASE("Wash loss in a row passes the finest sieve, with the pan or without") {
  CHECK(text(read(header + rows + "Pan,4.9\nWash loss,73.3\nTotal,700.0\n").masses()) ==
        "78.2 171.8 250 200 0");
  CHECK(text(read(header + rows + "Wash loss,73.3\n").masses()) == "73.3 171.8 250 200 0");
  CHECK(text(read(header + rows + "Pan + wash,78.2\n").masses()) == "78.2 171.8 250 200 0");
  CHECK(text(read(header + rows + "< 0.063,78.2\n").masses()) == "78.2 171.8 250 200 0");
  CHECK(text(read(header + rows + "Passing 63 um,78.2\n").masses()) == "78.2 171.8 250 200 0");
  CHECK(text(read(header + rows + "Material in the pan P,78.2\n").masses()) == "78.2 171.8 250 200 0");
  CHECK(text(read(header + rows + "Pan,4.9\nWash loss,73.3\nPan + wash,78.2\n").masses()) ==
        "78.2 171.8 250 200 0");
  CHECK(text(read("Sieve,Opening (mm),Retained (g)\nNo. 10,2,0\nNo. 200,0.075,20\nPan,,4\nWash loss,,73.3\n")
                 .masses()) == "77.3 20 0");
  CHECK(text(read(header + rows + "Pan,4.9\n\nWash loss,73.3\n").masses()) == "78.2 171.8 250 200 0");
}

TEST_CASE("Wash loss above the table passes the finest sieve too") {
  const std::string loss_line = "Loss on wash (g),73.30\n", before = "Dry mass before wash (g),700.00\n",
                    after = "Dry mass after wash (g),626.70\n";
  for (const std::string &heading :
       {loss_line, loss_line + before, before + after, before + after + loss_line}) {
    INFO(heading);
    const Gradation g = read(heading + header + rows + "Pan,4.9\n");
    CHECK(text(g.masses()) == "78.2 171.8 250 200 0");
    CHECK(has_note(g, "What passes the finest sieve, 0.063 mm, is 78.2: 'Pan 4.9', '"));
  }
  CHECK(text(read(before + after + header + rows).masses()) == "73.3 171.8 250 200 0");
  CHECK(text(read("Waschverlust: 73,3 g;\nSiebweite [mm];Rückstand [g]\n1;0\n0,063;626,7\n").masses()) ==
        "73.3 626.7 0");
  CHECK(text(read(before + loss_line + header + rows + "Pan,78.2\n").masses()) == "78.2 171.8 250 200 0");
}

TEST_CASE("What passes the finest sieve is not left below the table") {
  CHECK(contains(refusal(header + rows + "\nIn pan = 53.9 g\n"),
                 "sand.csv:7: 'In pan' stands beside the table"));
  CHECK(contains(refusal("Auswaschverlust,445 g\n" + header + rows + "Wash loss,73.3\n"),
                 "'Auswaschverlust' in line 1 says 445"));
  CHECK(text(read("Size (mm),% retained,% passing\n2,0,100\n1,60,40\n0.5,29,11\nPan,11,\n").masses()) ==
        "11 29 60 0");
}

TEST_CASE("Wash loss that two places say differently is refused") {
  CHECK(contains(refusal("Loss on wash (g),73.30\n" + header + rows + "Pan,4.9\nWash loss,70.0\n"),
                 "sand.csv:8: 'Wash loss' is 70, and 'Loss on wash (g)' in line 1 says 73.3"));
  CHECK(contains(refusal("Dry mass before wash (g),700\nDry mass after wash (g),650\nWash loss (g),73\n" +
                         header + rows),
                 "less 'Dry mass after wash (g)' is 50"));
  CHECK(contains(refusal("Dry mass after wash (g),626.7\n" + header + rows + "Pan,4.9\n"),
                 "nothing of what was washed out"));
  CHECK(contains(refusal(header + rows + "Pan,4.9\nPassing 63 um,73.3\n"), "write 'Pan + wash' for both"));
  CHECK(contains(refusal(header + rows + "Passing 2 mm,73.3\n"), "the finest sieve is 0.063 mm"));
  CHECK(contains(refusal("Loss (%) on washing in all,10.5\n" + header + rows + "Pan,4.9\n"),
                 "may be what was washed out, or not"));
}

TEST_CASE("The dry mass is compared with the sum of the rows") {
  CHECK(contains(refusal("Dry mass (g),700\n" + header + rows + "Pan,4.9\n"),
                 "sand.csv:1: the rows of 'Mass retained (g)' add up to 626.7, and 'Dry mass (g)' says 700, "
                 "a difference of 10.47 percent of that"));
  CHECK(text(read_with("Dry mass (g),700\n" + header + rows + "Pan,4.9\n", loss(11)).masses()) ==
        "4.9 171.8 250 200 0");
  CHECK(has_note(read("Dry mass (g),630.0\n" + header + rows + "Pan,4.9\n"),
                 "0.52 percent less; the rows are used"));
  CHECK(has_note(read("Dry mass (g),626.7\n" + header + rows + "Pan,4.9\n"), "The masses add up to 626.7"));
  CHECK(text(read("Dry mass (kg),0.6267\n" + header + rows + "Pan,4.9\n").masses()) == "4.9 171.8 250 200 0");
  CHECK(contains(refusal("Container (g),100\nContainer + dry soil (g),800\n" + header + rows + "Pan,4.9\n"),
                 "says 700"));
}

TEST_CASE("What may be lost in sieving is an exact share of the dry mass") {
  const std::string sheet = "Total dry mass (g),1000\n\n" + header + "2,0\n1,400\n0.5,";
  CHECK(has_note(read(sheet + "590\n"), "1 percent less"));
  CHECK(contains(refusal(sheet + "589\n"), "1.1 percent"));
}

TEST_CASE("A part that was sieved for the whole is refused") {
  CHECK(contains(refusal(header + "4,0\n2,800\nSplit,300\n1,100\n0.5,200\n"), "--split"));
  CHECK(contains(refusal(header + "4,0\n2,800\nPassing 2 mm,1700\n1,100\n0.5,200\n"), "--split"));
  CHECK(contains(refusal(header + "4,0\n2,800\nPan,1700\n1,100\n0.5,200\nPan,3\n"), "--split"));
  CHECK(contains(refusal("Mass of subsample (g),303\n" + header + "4,0\n2,800\n1,100\n0.5,200\nPan,3\n"),
                 "--split"));
  CHECK(contains(refusal("Dry mass (g),2500\n" + header + "4,0\n2,800\n1,100\n0.5,200\nPan,3\n"), "--split"));
  CHECK(text(read("Split-spoon sample S-4,12 ft\n" + header + rows + "Pan,4.9\n").masses()) ==
        "4.9 171.8 250 200 0");
}

TEST_CASE("A column that may be cumulative or not is compared as what agrees") {
  const std::string head = "Tamis (mm);Refus (g);Tamisats (%)\n10;0;100\n";
  CHECK(has_note(read(head + "5;30;70\n2;50;20\n1;20;0\n"), "'Tamisats (%)', 'Refus (g)'"));
  CHECK(has_note(read(head + "5;30;70\n2;80;20\n1;100;0\n"), "'Tamisats (%)', 'Refus (g)'"));
  CHECK(contains(refusal(head + "5;30;70\n2;60;20\n1;20;0\n"), "percent pass by the column"));
  CHECK(contains(refusal("Tamis (mm);Refus (g)\n10;0\n5;30\n2;50\n"), "may be what each sieve retains"));
  CHECK(text(read("Tamiz UNE (mm);Retenido parcial (g);Pasa (%)\n20;0;100\n10;60;40\n5;40;0\n").masses()) ==
        "40 60 0");
}

TEST_CASE("A row of fines must be in the column that was chosen") {
  const std::string table =
      "Sieve (mm),Cumulative retained (g),Retained (g)\n4,0,0\n2,10,10\n1,50,40\n0.5,80,30\n";
  for (const std::string row : {"Wash loss,,20\n", "Pan,,20\n"})
    CHECK(contains(message_of([&] { read_with(table + row, kind("cumulative")); }),
                   "nothing in 'Cumulative retained (g)'"));
  CHECK(text(read_with(table + "Pan,100,20\n", kind("cumulative")).masses()) == "20 30 40 10 0");
  CHECK(text(read(table + "Wash loss,,20\n").masses()) == "20 30 40 10 0");
}

TEST_CASE("Percent retained must be of the whole") {
  CHECK(
      contains(refusal("Size (mm),% retained\n2,0\n1,60\n0.5,29\n"),
               "percent retained add up to 89: write the row 'pan' with 11 if that passes the finest sieve"));
  CHECK(text(read("Size (mm),% retained\n2,0\n1,60\n0.5,29\nPan,11\n").masses()) == "11 29 60 0");
  CHECK(text(read("Size (mm),% retained\n2,0\n1,60\n0.5,39.5\n").masses()) == "39.5 60 0");
}

TEST_CASE("A row of the table with numbers that is none of these is an error") {
  CHECK(contains(refusal(header + rows + "D50,0.3\n"), "sand.csv:6: 'D50' is no sieve"));
  CHECK(
      contains(refusal("Size (mm),Mass retained (g),% passing\n2,0,100\n1,30,40\nDust ratio,,3\nPan,20,0\n"),
               "sand.csv:4: the row 'Dust ratio' has numbers"));
}

TEST_CASE("The option --loss is a percentage of sheets alone") {
  CHECK(contains(message_of([] { read_with("{\"sizes\":[1,2],\"masses\":[1,0]}", loss(2)); }),
                 "--loss are for tables"));
}

TEST_CASE("Sieves weighed with what they retain and empty are compared with the masses") {
  const std::string weighed = "Sieve (mm),Mass of sieve (g),Mass of sieve + soil (g),Mass retained (g)\n"
                              "2,450.2,450.2,0\n0.425,400.0,455.5,55.5\n0.075,350.5,365.6,15.1\nPan,300.0,";
  const Gradation g = read(weighed + "309.3,9.3\nTotal,,,79.9\n");
  CHECK(text(g.masses()) == "9.3 15.1 55.5 0");
  CHECK(has_note(g, "agree within the rounding of their digits: 'Mass retained (g)', 'Mass of sieve + soil "
                    "(g) less Mass of sieve (g)'"));
  CHECK(contains(refusal(weighed + "310.3,9.3\n"), "9.3 passes the finest sieve"));
  CHECK(contains(refusal("Siebweite in mm;Leeres Sieb (g);Sieb und Rückstand (g);Rückstand (g)\n"
                         "2;450,2;450,2;0\n0,4;400,0;456,5;55,5\n0,063;350,5;365,6;15,1\n"),
                 "less"));
  CHECK(contains(refusal("Sieve (mm),Empty sieve (g),Sieve and soil (g)\n2,450.2,450.2\n0.4,400,455.5\n"),
                 "and no column has what they retain: add one with the difference"));
}

TEST_CASE("A total in the columns of weighed sieves is compared too") {
  CHECK(text(read("mm,Tare (g),Sieve & soil (g),Mass retained (g)\n2,450,450,0\n0.4,400,455,55\n"
                  "0.1,350,365,15\nPan,300,309,9\nTotal,1500,1579,79\n")
                 .masses()) == "9 15 55 0");
}

TEST_CASE("Whole percents that say that something passes the finest sieve decide, whatever the rounding") {
  const std::string sheet =
      "Sieve (mm),Mass retained (g),% passing\n4.75,0,100\n2,98,90\n0.85,303,60\n0.425,400,20\n0.075,179,2\n";
  const Gradation g = read(sheet);
  CHECK(text(g.masses()) == "2 18 40 30 10 0");
  CHECK(has_note(g, "'% passing' decides, where 2 percent pass the finest sieve"));
  CHECK(text(read(sheet + "Pan,20\n").masses()) == "20 179 400 303 98 0");
  CHECK(text(read("Sieve (mm),Mass retained (g),% passing\n4,0,100\n2,98,90\n1,902,0\n").masses()) ==
        "902 98 0");
}

TEST_CASE("A mass that passes the finest sieve is not dropped where there is no row of the pan") {
  const std::string sheet = "Sieve (mm),Mass retained (g),Mass passing (g)\n4.75,0.0,1000.0\n2,98.0,902.0\n"
                            "0.85,303.0,599.0\n0.425,400.0,199.0\n0.075,149.0,50.0\n";
  CHECK(contains(refusal(sheet),
                 "50 passes the finest sieve by the column 'Mass passing (g)', and 'Mass retained (g)' "
                 "has no row of the pan: write it"));
  CHECK(text(read(sheet + "Pan,50.0,0\n").masses()) == "50 149 400 303 98 0");
}

TEST_CASE("The pan holds no more than passes the finest sieve by the percent beside it") {
  const std::string sheet = "Sieve (mm),% retained,% passing\n4,0,100\n2,30,70\n1,30,40\n0.5,38,2\nPan,";
  CHECK(text(read(sheet + "2,\n").masses()) == "2 38 30 30 0");
  const std::string note =
      "2 passes the finest sieve by the column '% passing', 4 by '% retained': their rounding may "
      "account for it.";
  CHECK(has_note(read(sheet + "4,\n"), note)); // 29.6, 29.6, 37.6 and 3.5
  CHECK(contains(refusal(sheet + "6,\n"),
                 "2 passes the finest sieve by the column '% passing', 6 by '% retained'"));
  const std::string digits =
      "Sieve (mm),% retained,% passing\n4,0.0,100.0\n2,30.0,70.0\n1,30.0,40.0\n0.5,38.0,2.0\nPan,";
  CHECK(contains(refusal(digits + "2.4,0.0\n"), "2.4 by '% retained'"));
  const Gradation lost = read(digits + "1.5,0.0\n"); // of what was lost nothing is in the pan
  CHECK(text(lost.masses()) == "2 38 30 30 0");
  CHECK(has_note(
      lost, "2 passes the finest sieve by the column '% passing', 1.5 by '% retained': the difference may "
            "have been lost."));
}

TEST_CASE("Masses make no shares that their rounding does not make") {
  const std::string two = "Sieve (mm),Mass retained (g),% passing\n4.75,0,100\n2,3,";
  CHECK(contains(refusal(two + "67\nPan,3,0\n"), "correct one, or choose with --kind mass or"));
  CHECK(text(read(two + "57\nPan,3,0\n").masses()) == "3 3 0"); // 3.4 of 3.4 and 2.6
  CHECK(contains(refusal("Sieve (mm),Mass retained (g),% passing\n4.75,0,100\n2,10,80\n1,20,40\n0.5,15,13\n"
                         "Pan,5,0\n"),
                 "the masses in 'Mass retained (g)' add up to 50"));
}

TEST_CASE("Percent are compared whatever their heading has beside them") {
  const std::string wrong =
      "9.5,0,100\n4.75,20,96\n2.36,60,84\n1.18,10,64\n0.6,150,34\n0.3,120,10\n0.15,40,2\n"
      "Pan,10,\n";
  for (const char *name : {"%age passing", "Cumulative percentages passing", "Percentages passing",
                           "Accum. % passing", "% Finer, N", "Percent passing sieve", "% Passing (rounded)",
                           "Actual % passing", "% < size", "P (%)", "Gesamtdurchgang [%]",
                           "Durchgangswerte [%]", "Pourcentages cumulés de tamisats", "Passante totale (%)"})
    CHECK(contains(refusal("Sieve (mm),Mass retained (g)," + std::string(name) + "\n" + wrong), "choose"));
  const std::string percent = "9.5,0,0\n4.75,100,20\n2.36,200,40\n1.18,100,10\nPan,100,20\n";
  for (const char *name : {"Percentages retained", "%age retained", "% Retd", "Indiv. %", "Frequency (%)",
                           "Percentage of material retained Ri/M1 x 100", "Rückstand Ri/M1*100 [%]"})
    CHECK(contains(refusal("Sieve (mm),Mass retained (g)," + std::string(name) + "\n" + percent), "choose"));
  const std::string right = "9.5,0,100\n4.75,100,80\n2.36,200,40\n1.18,100,20\nPan,100,\n";
  CHECK(
      text(read("Sieve (mm),Mass retained (g),Cumulative percentages passing 100 - (Σ Ri/M1 × 100)\n" + right)
               .masses()) == "100 100 200 100 0");
}

TEST_CASE("An error of a spreadsheet in a column that is compared is told") {
  const Gradation g =
      read("Sieve (mm),Mass retained (g),% passing\n9.5,0,100\n4.75,100,#REF!\n2.36,200,#DIV/0!\n"
           "1.18,100,20\nPan,100,\n");
  CHECK(has_note(g, "Cells with an error of the spreadsheet were not compared, in the rows '4.75', '2.36'."));
}

} // namespace table_accounts_test
