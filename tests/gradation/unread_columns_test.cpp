// Columns, comments and lines around a table that are not read and may change what its numbers mean.

#include "catch.hpp"
#include "sheet.hpp"

namespace unread_columns_test {

using namespace mdm;
using namespace mdm::test;

namespace {

/// A table of five sieves with a column beside the masses. \param cells  of that column
std::string with_column(const std::string &header, const std::vector<std::string> &cells) {
  const std::string rows[] = {"4,0", "2,20", "1,60", "0.5,80", "0.25,30", "Pan,10"};
  std::string text = "Sieve (mm),Mass retained (g)," + header + "\n";
  for (std::size_t i = 0; i < cells.size(); ++i)
    text += rows[i] + "," + cells[i] + "\n";
  return text;
}

const std::string read_as_it_is = "10 30 80 60 20 0";

} // namespace

TEST_CASE("a column in a unit of mass or percent has the masses of the table, or is refused") {
  for (const char *header :
       {"Repeat (g)", "Mean (g)", "Mittelwert [g]", "Second batch (g)", "After resieving (g)", "Dried (g)",
        "umgerechnet (g)", "Upscaled (g)", "Measured (%)", "Tare (g)", "Tare", "Beaker (g)", "Average"}) {
    INFO(header);
    CHECK(contains(refusal(with_column(header, {"0", "24", "70", "70", "26", "11"})),
                   "has other masses or shares than 'Mass retained (g)'"));
  }
  for (const char *header : {"Mean (g)", "Netto [g]", "Dried (g)"}) {
    INFO(header);
    CHECK(masses(with_column(header, {"0", "20", "60", "80", "30", "10"})) == read_as_it_is);
  }
  for (const char *header : {"%", "Anteil [%]", "Average"}) {
    INFO(header);
    CHECK(masses(with_column(header, {"0", "10", "30", "40", "15", "5"})) == read_as_it_is);
  }
  for (const char *header : {"Fe (%)", "Target (%)", "Error (%)", "Upper limit (%)"}) {
    INFO(header);
    CHECK(masses(with_column(header, {"0", "24", "70", "70", "26", "11"})) == read_as_it_is);
  }
}

TEST_CASE("a second column of what passes, of the whole or of a part, is not passed over") {
  const std::string passing = "4,100,100\n2,90,94.5\n1,60,76.2\n0.5,20,52.1\n0.063,5,43.0\n";
  for (const char *header : {"Overall", "Of total sample", "Measured (%)", "Result"}) {
    INFO(header);
    CHECK(
        contains(refusal("Sieve (mm),Passing (%)," + std::string(header) + "\n" + passing), "other masses"));
  }
  const std::string joined = "Sieve (mm),Passing (%)\n4,100\n2,90\n0.5,70\n0.075,50\n",
                    fine = "Diameter (mm),Finer (%)\n0.03,40\n0.01,25\n0.002,10\n";
  CHECK(masses(joined + fine) == "10 15 15 10 20 20 10 0");
  CHECK(contains(refusal(joined + "Hydrometer (% of fraction < 2 mm)\n" + fine), "begins below"));
  CHECK(contains(refusal(joined + fine + "\nHydrometer percentages are of the material < 2 mm\n"),
                 "shares of a part"));
}

TEST_CASE("masses with their container, and that of the container, are compared with those without") {
  CHECK(masses(with_column("Gross (g),Dish (g)", {"100,100", "121,101", "162,102", "180,100", "129,99",
                                                  "110,100"})) == read_as_it_is);
  CHECK(masses(with_column("With dish (g)", {"100.2", "120.2", "160.2", "180.2", "130.2", "110.2"})) ==
        read_as_it_is);
  CHECK(
      contains(refusal(with_column("With dish (g)", {"100.2", "120.2", "160.2", "182.9", "130.2", "110.2"})),
               "other masses"));
}

TEST_CASE("shares beside masses without a pan must add up to all") {
  for (const char *header : {"Anteil [%]", "%", "Retained (%)"}) {
    INFO(header);
    CHECK(contains(refusal(with_column(header, {"0", "8.4", "25.1", "33.5", "12.6"})), "pan"));
    CHECK(masses(with_column(header, {"0", "10.5", "31.6", "42.1", "15.8"})) == "30 80 60 20 0");
  }
}

TEST_CASE("shares of channels stand beside the size above them, where another column says what passes") {
  const std::string header = "Size (um),% Chan,% Pass\n";
  CHECK(masses(header + "100,20,100\n50,50,80\n25,30,30\n12,0,0\n") == "30 50 20 0");
  CHECK(contains(refusal(header + "100,20,100\n50,40,80\n25,40,30\n12,0,0\n"), "other masses or shares"));
}

TEST_CASE("what is said of a part that was sieved for the whole is not added up") {
  const std::string stack =
      "Sieve (mm),Mass retained (g)\n19,0\n9.5,400\n4.75,800\n2.36,90\n1.18,60\nPan,20\n";
  for (const char *words :
       {"Umrechnungsfaktor: 5.8", "Coefficient: 5.8", "Scaling 5.8 for material below 4.75 mm",
        "Feinsiebung: Einwaage 500 g", "Correction factor: 5.8", "Mass for fine sieving: 500 g",
        "Fine fraction 500 g", "Representative portion 500 g", "40 % > 4 mm removed before sieving",
        "Scalped at 20 mm"}) {
    INFO(words);
    CHECK(contains(refusal(std::string(words) + "\n" + stack), "--split"));
  }
  CHECK(masses("Coefficient of uniformity: 5.8\n" + stack) == "20 60 90 800 400 0");
}

TEST_CASE("a comment of a sheet that speaks of its masses is not passed over") {
  const std::string table = "Sieve (mm),Mass retained (g)\n4,0\n2,20\n1,60\nPan,3\n";
  for (const char *comment : {"# Wash loss: 40 g", "# Initial dry mass: 248 g", "# Values are cumulative",
                              "# Split: 100 g of 400 g were sieved"}) {
    INFO(comment);
    CHECK(contains(refusal(std::string(comment) + "\n" + table), "sand.csv:1: the comment"));
    CHECK(contains(refusal(table + comment + "\n"), "sand.csv:6: the comment"));
  }
  CHECK(masses("# Sand of the river, sieved by A. B.\n" + table) == "3 60 20 0");
}

TEST_CASE("numbers of another series of sieves are not those of ASTM, wherever that is said") {
  const std::string table = "Sieve,Mass retained (g)\nNo. 10,0\nNo. 35,60\nPan,5\n";
  for (const char *words : {"Tyler", "Particle size distribution to BS 1377:1975", "B.S. sieves",
                            "I.M.M. mesh", "Siebsatz BS", "# Tyler sieves"}) {
    INFO(words);
    CHECK(contains(refusal(std::string(words) + "\n" + table), "may not be a sieve of ASTM"));
    CHECK(contains(refusal(table + "\n" + words + "\n"), "may not be a sieve of ASTM"));
  }
  CHECK(contains(refusal("Series,Sieve,Mass retained (g)\nBS,No. 7,0\nBS,No. 14,20\n"),
                 "may not be a sieve of ASTM"));
  CHECK(masses("ASTM sieves, project of the BS\n" + table) == "5 60 0");
}

TEST_CASE(
    "a column without a pan that was asked for gives way to one by which something passes the finest sieve") {
  const std::string sheet = "Sieve (mm),Mass retained (g),Retained (%),Passing (%)\n4,0,0,100\n2,20,10,90\n"
                            "1,60,30,60\n0.5,84,42,18\n";
  for (const char *kind : {"mass", "retained", "retained_percent"}) {
    INFO(kind);
    Reading asked;
    asked.kind = kind;
    CHECK(text(read_gradation(sheet, "sand.csv", asked).masses()) == "18 42 30 10 0");
  }
  Reading columns;
  for (const char *names : {"Sieve (mm),Mass retained (g)", "1,3", "1,4"}) {
    INFO(names);
    columns.columns = names;
    CHECK(text(read_gradation(sheet, "sand.csv", columns).masses()) == "18 42 30 10 0");
  }
}

TEST_CASE("a second table among the sieves of the first is of another curve") {
  const std::string first = "Sieve (mm),Passing (%)\n4,100\n1,60\n0.25,18\n";
  CHECK(contains(refusal(first + "Sieve (mm),Passing (%)\n4,100\n2,70\n1,50\n"), "among those of the first"));
  CHECK(contains(refusal(first + "Sieve (mm),Passing (%)\n2,80\n0.5,40\n"), "among those of the first"));
  CHECK(masses(first + "Sieve (mm),Passing (%)\n0.125,10\n0.063,4\n") == "4 6 8 42 40 0");
}

TEST_CASE("words with a number below the pan are none of a sieve that lacks its mass") {
  const std::string table = "Sieve No.,Opening (mm),Mass retained (g)\nNo. 5,4,0\nNo. 10,2,20\nPan,,60\n";
  for (const char *words : {"Gs,2.65,", "Cu,3.1", "D60 (mm),0.42,", "Date,2021-05-14,", "Gravel,19.9,"}) {
    INFO(words);
    CHECK(masses(table + words + "\n") == "60 20 0");
  }
  CHECK(contains(refusal(table + "No. 20,0.85,\n"), "has no value in the column"));
  CHECK(contains(refusal(table + "Fines,1.6,\n"), "sand.csv:5: "));
  CHECK(contains(refusal(table + "Gs,2.65,\nNo. 20,0.85,5\n"), "sand.csv:6: "));
}

TEST_CASE("a pan and one of the wash may be added, or not") {
  CHECK(contains(refusal(header + rows + "Pan,10\nPan (wash),60\n"), "may have 'Pan' in it, or not"));
  CHECK(contains(refusal(header + rows + "Pan,10\nPan - washed,60\n"), "may have 'Pan' in it, or not"));
  CHECK(masses(header + rows + "Pan,10\nPan + wash,60\n") == "60 130 300 0");
  CHECK(masses(header + rows + "Pan (wash),60\n") == "60 130 300 0");
}

TEST_CASE("masses of few sieves that never fall are read with a note") {
  const auto notes = [](const std::string &sieves) {
    const std::vector<std::string> all = read("Sieve (mm),Mass retained (g)\n4,0\n" + sieves).notes();
    return std::count_if(all.begin(), all.end(), [](const std::string &note) {
      return contains(note,
                      "No sieve retains less than the next coarser one: 'Mass retained (g)' was read as");
    });
  };
  CHECK(notes("2,20\n1,60\nPan,80\n") == 1);
  CHECK(notes("2,20\n1,60\n0.5,80\nPan,90\n") == 1);
  CHECK(notes("2,20\n1,60\n0.5,50\nPan,90\n") == 0);
  CHECK(notes("2,20\nPan,60\n") == 0);
}

TEST_CASE("a sentence that gives the sizes another unit than their header is not passed over") {
  const std::string table = "Sieve (mm),Mass retained (g)\n4,0\n2,20\n1,60\nPan,3\n";
  for (const char *words : {"Sizes in inches", "All sieve openings are in micrometres", "Siebweiten in um"}) {
    INFO(words);
    CHECK(contains(refusal(std::string(words) + "\n" + table), "names another unit"));
    CHECK(contains(refusal(table + "\n" + words + "\n"), "names another unit"));
  }
  for (const char *words :
       {"Sizes in millimetres", "Sieves of 8 in", "Sieving in the laboratory in London"}) {
    INFO(words);
    CHECK(masses(std::string(words) + "\n" + table) == "3 60 20 0");
  }
}

TEST_CASE("metres that may be micrometres without their first letter are no unit") {
  for (const char *unit : {"(?m)", "[?m]", "(_m)", "( m)"}) {
    INFO(unit);
    CHECK(contains(refusal("Size " + std::string(unit) + ",Passing (%)\n2,100\n1,80\n0.5,0\n"), "--unit"));
  }
  CHECK(read("Size (m),Passing (%)\n2,100\n1,80\n0.5,0\n").unit() == SizeUnit::m);
}

} // namespace unread_columns_test
