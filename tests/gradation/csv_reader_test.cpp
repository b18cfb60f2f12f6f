#include "support.hpp"

#include <mdm/gradation/envelope.hpp>

namespace csv_reader_test {

using namespace mdm;
using namespace mdm::test;

TEST_CASE("CSV: masses are taken as they are, in any order of rows") {
  const Gradation g = read("size_mm,mass\n2,1\n0.5,3.86\n4,0\npan,2\n");
  CHECK(text(g.sizes()) == "0 0.5 2 4");
  CHECK(text(g.masses()) == "2 3.86 1 0");
  CHECK(g.unit() == SizeUnit::mm);
  CHECK(g.id() == "sand");
  CHECK(g.notes().empty());
}

TEST_CASE("CSV: every kind of mass column") {
  const auto masses = [](const std::string &column, const std::string &fine, const std::string &middle,
                         const std::string &coarse) {
    return text(
        read("size_mm," + column + "\n1," + fine + "\n2," + middle + "\n3," + coarse + "\n").masses());
  };
  CHECK(masses("mass", "60", "40", "0") == "60 40 0");
  CHECK(masses("retained_g", "60", "40", "0") == "60 40 0");
  CHECK(masses("retained_percent", "60", "40", "0") == "60 40 0");
  CHECK(masses("retained_fraction", "0.6", "0.4", "0") == "0.6 0.4 0");
  CHECK(masses("cumulative_retained_percent", "100", "40", "0") == "60 40 0");
  CHECK(masses("passing_percent", "0", "60", "100") == "60 40 0");
  CHECK(masses("passing_fraction", "0", "0.6", "1") == "0.6 0.4 0");
}

TEST_CASE("CSV: every unit of size") {
  const auto sizes = [](const std::string &column, const std::string &a, const std::string &b) {
    const Gradation g = read(column + ",mass\n" + a + ",1\n" + b + ",0\n");
    return text(g.sizes()) + " " + std::string(name(g.unit()));
  };
  CHECK(sizes("size_mm", "pan", "1.5") == "0 1.5 mm");
  CHECK(sizes("size_um", "PAN", "75") == "0 75 um");
  CHECK(sizes("size_m", "Pan", "1e-3") == "0 0.001 m");
  CHECK(sizes("size_in", "0.375", "1") == "9.525 25.4 mm");
  CHECK(sizes("size_phi", "2", "-1") == "0.25 2 mm");
  CHECK(sizes("sieve", "No. 200", "3/8 in") == "0.075 9.5 mm");
}

TEST_CASE("CSV: an interior sieve that retains nothing stays") {
  CHECK(text(read("size_mm,passing_percent\n4,100\n3,50\n2,50\n1,0\n").masses()) == "50 0 50 0");
}

TEST_CASE("CSV: byte order mark, CRLF, blank lines, comments and quotes are accepted") {
  const Gradation g = read("\xEF\xBB\xBF# a sand, \"quoted\r\n\r\n \t\r\n\"size_mm\" , \"mass\"\r\n"
                           " # not a row, 1\r\n\"1\" ,2\r\n 2\t,\"0\"\r\n");
  CHECK(text(g.sizes()) == "1 2");
  CHECK(text(g.masses()) == "2 0");
}

TEST_CASE("CSV: semicolons with decimal commas or decimal points, not with both") {
  CHECK(text(read("size_mm;mass\n0,5;1,25\n2;0\n").sizes()) == "0.5 2");
  CHECK(text(read("size_mm;mass\n0.5;1.25\n2;0\n").masses()) == "1.25 0");
  CHECK(text(read("sieve;mass\n1,18 mm;1,25\n50 mm;0\n").sizes()) == "1.18 50");
  CHECK(text(read("sieve;mass\nNo. 200;1,25\n1.06 in;0\n").sizes()) == "0.075 26.5");
  CHECK(
      contains(refusal("size_mm;mass\n0,5;1\n1.5;1\n2;0\n"), "sand.csv:3: size_mm '1.5' has a decimal '.'"));
  CHECK(contains(refusal("sieve;mass\n1.18 mm;1,5\n2;0\n"), "sand.csv:2: mass '1,5' has a decimal ','"));
  CHECK(contains(refusal("size_mm;mass\n1.000,5;1\n2;0\n"), "sand.csv:2: size_mm '1.000,5' is not a number"));
  CHECK(contains(refusal("size_mm,mass\n\"0,5\",1\n2,0\n"), "sand.csv:2: size_mm '0,5' is not a number"));
  CHECK(contains(refusal("size_mm,mass\n0,5,1\n2,0\n"),
                 "sand.csv:2: the row has 3 fields, the header has 2 fields"));
}

TEST_CASE("CSV: a number behind # may be a sieve and is refused, under every header and above it") {
  for (const std::string header : {"size_mm", "size_um", "size_m", "size_in", "size_phi", "sieve"})
    CHECK(contains(refusal(header + ",mass\n#4,50\n"), "sand.csv:2: '#4,50' may be a sieve or a comment: "));
  CHECK(refusal("\n \t#4 sands\nsize_mm,mass\n1,1\n2,0\n") ==
        "sand.csv:2: '#4 sands' may be a sieve or a comment: write '# ' before a comment, No. 4 for a sieve");
  CHECK(contains(refusal("size_mm,mass\n1,1\n2,0\n#10*"), "sand.csv:4: '#10*' may be"));
  CHECK(text(read("# 4 sands\nsize_mm,mass\n# 4,50\n#x 4\n#\n#-4\n1,1\n2,0\n").sizes()) == "1 2");
}

TEST_CASE("CSV: below a sieve header, blanks between # and a number make no comment of it") {
  CHECK(refusal("sieve,mass\n# \t3-1/2,1\n") ==
        "sand.csv:2: '# \\x093-1/2,1' may be a sieve or a comment: write No. 4 for a sieve, begin a comment "
        "with a word");
  CHECK(text(read("# 4 sands\nsieve,mass\n# No. 4: see the note\n\"#200\",4.1\n\" # 4 \",0\n").sizes()) ==
        "0.075 4.75");
  CHECK(contains(refusal("sieve,mass\n\"#201\",4.1\n1 mm,1\n2 mm,0\n"),
                 "sand.csv:2: sieve '#201' is no sieve"));
}

TEST_CASE("CSV: a row of a sieve table without a name is refused") {
  CHECK(contains(refusal("sieve,passing_percent\n1.18 mm,100\nNo. 30,97\n,# ASTM\n"),
                 "sand.csv:4: sieve '' is no sieve"));
}

TEST_CASE("CSV: quotes inside a quoted field are doubled") {
  CHECK(text(read("sieve,mass\n\"3/8\"\"\",1\n\"1 1/2\"\"\",0\n").sizes()) == "9.5 37.5");
  CHECK(contains(refusal("sieve,mass\n\"3/8\"\",1\n1 in,0\n"), "sand.csv:2: a quoted field does not end"));
  CHECK(contains(refusal("size_mm,mass\n\"1\"2,1\n1 in,0\n"), "sand.csv:2: a quoted field does not end"));
}

TEST_CASE("CSV: a pan is implied, with a note, where something passes the finest sieve") {
  const Gradation g = read("size_mm,passing_percent,tolerance_percent\n1,10,0.5\n2,100,1\n");
  CHECK(text(g.sizes()) == "0 1 2");
  CHECK(text(g.masses()) == "10 90 0");
  CHECK(text(g.tolerances()) == "0 0.5 1");
  REQUIRE(g.notes().size() == 2);
  CHECK(g.notes()[0] == "A pan of size 0 was added for the 10 percent that pass the finest sieve, 1 mm.");
  CHECK(text(read("size_mm,passing_percent\n1,100\n2,100\n").masses()) == "100 0 0");
  CHECK(text(read("size_mm,cumulative_retained_percent\n1,90\n2,0\n").masses()) == "10 90 0");
  CHECK(read("size_mm,passing_percent\n1,0\n2,100\n").notes().empty());
  CHECK(contains(refusal("size_mm,passing_percent\n0,10\n2,100\n"),
                 "sand.csv:2: percent passing 10 at size 0"));
  CHECK(contains(
      refusal("size_mm,cumulative_retained_percent\n2,0\npan,99\n"),
      "sand.csv:3: cumulative percent retained 99 at size 0: nothing passes the pan, so this must be 100"));
}

TEST_CASE("CSV: with factors the pan needs a row of its own") {
  const Gradation g = read("size_mm,passing_percent,factor\n1,10,2.65\n2,100,1\npan,0,3\n");
  CHECK(text(g.masses()) == "10 90 0");
  CHECK(g.factor(0) == 3);
  CHECK(g.factor(1) == parse_decimal("2.65"));
  CHECK_FALSE(read("size_mm,passing_percent\n1,10\n2,100\n").has_factors());
  CHECK(contains(refusal("size_mm,passing_percent,factor\n2,100,1\n1,10,2\n"),
                 "sand.csv:3: something passes the finest sieve, 1 mm, and the pan below has no factor"));
}

TEST_CASE("CSV: optional columns in either order, once each") {
  CHECK(text(read("size_mm,mass,factor,tolerance_percent\n1,1,2,0.5\n2,0,1,0\n").tolerances()) == "0.5 0");
  CHECK(contains(refusal("size_mm,mass,factor,factor\n1,1,2,2\n2,0,1,1\n"),
                 "sand.csv:1: column factor is there twice"));
  CHECK(contains(refusal("size_mm,mass,weight\n"),
                 "sand.csv:1: column 'weight' is unknown: after the first two there "
                 "may be tolerance_percent and factor"));
  CHECK(contains(refusal("size_mm,mass,factor\n1,1,0\n2,0,1\n"), "sand.csv:2: factor 0 is not above 0"));
  CHECK(contains(refusal("size_mm,mass,tolerance_percent\n1,1,0\n2,0,-1\n"),
                 "sand.csv:3: tolerance -1 is negative"));
}

TEST_CASE("CSV: the header is told what columns there are") {
  CHECK(contains(refusal("\nd50,mass\n1,1\n"),
                 "sand.csv:2: first column 'd50' is unknown: use one of size_mm, size_um, size_m, size_in, "
                 "size_phi, sieve"));
  CHECK(contains(
      refusal("size_mm,passing\n"),
      "sand.csv:1: second column 'passing' is unknown: use one of mass, retained_g, retained_percent, "
      "retained_fraction, cumulative_retained_percent, passing_percent, passing_fraction"));
  CHECK(contains(refusal("size_mm\n1\n"), "sand.csv:1: a second column is missing"));
  CHECK(contains(refusal("SIZE_MM,masses\n1,1\n2,0\n"), "sand.csv:1: first column 'SIZE_MM' is unknown"));
  CHECK(contains(refusal("size_mm,mass,\n1,1,\n2,0,\n"), "sand.csv:1: column '' is unknown"));
  CHECK(contains(refusal("mdm-certificate 1\nlaw 3\n"), "(this is a proof: give the gradation first"));
  CHECK(contains(refusal("mdm-packing 1\nunit mm\n"), "(this is a packing: give the gradation)"));
  CHECK(contains(refusal("size_mm,passing_min_percent,passing_max_percent\n1,0,10\n2,100,100\n"),
                 "sand.csv:1: this is a band of allowed gradations, where a gradation is asked for"));
}

TEST_CASE("CSV: the largest sieve must retain nothing (Cond1), and the message says what to add") {
  CHECK(refusal("size_mm,passing_percent\n1,10\n2,93.4\n") ==
        "sand.csv:3: the largest sieve, 2 mm, has percent passing 93.4, not 100: add a row for a larger "
        "sieve with "
        "percent passing 100");
  CHECK(contains(
      refusal("size_mm,passing_percent\n1,0.1\n2,1\n"),
      "sand.csv:3: the largest sieve, 2 mm, has percent passing 1: name the column passing_fraction if"));
  CHECK(refusal("size_mm,retained_g\n2,6.6\n1,10\n") ==
        "sand.csv:2: the largest sieve, 2 mm, has mass retained 6.6, not 0: add a row for a larger sieve "
        "with mass "
        "retained 0");
  CHECK(contains(refusal("size_mm,cumulative_retained_percent\n2,6.6\n1,10\n"),
                 "sand.csv:2: the largest sieve, 2 mm, has cumulative percent retained 6.6, not 0"));
}

TEST_CASE("CSV: impossible values are refused with their line") {
  CHECK(refusal("size_mm,passing_percent\n1,10\n2,101\n3,100\n") ==
        "sand.csv:3: percent passing 101 is above 100");
  CHECK(contains(refusal("size_mm,passing_fraction\n1,10\n2,1\n"),
                 "sand.csv:2: fraction passing 10 is above 1"));
  CHECK(contains(refusal("size_mm,cumulative_retained_percent\n1,101\n2,0\n"),
                 "sand.csv:2: cumulative percent retained 101 is above 100"));
  CHECK(contains(refusal("size_mm,mass\n1,-1\n2,0\n"), "sand.csv:2: mass -1 is negative"));
  CHECK(contains(refusal("size_mm,mass\n-1,1\n2,0\n"), "sand.csv:2: size -1 mm is negative"));
  CHECK(contains(refusal("size_mm,mass\n1,1\n2,0\n1.0,2\n"), "sand.csv:4: size 1 mm repeats that of line 2"));
  CHECK(contains(refusal("size_mm,mass\n1,0\n2,0\n"),
                 "sand.csv:1: no row has a mass above 0: write what each sieve retains"));
  CHECK(contains(refusal("size_mm,passing_percent\n3,100\n1,50\n2,40\n"),
                 "sand.csv:4: percent passing 40 at 2 mm is below 50 at 1 mm"));
  CHECK(contains(refusal("size_mm,cumulative_retained_percent\n3,0\n1,50\n2,60\n"),
                 "sand.csv:4: cumulative percent retained 60 at 2 mm is above 50 at 1 mm"));
}

TEST_CASE("CSV: what is no decimal is refused") {
  for (const std::string word :
       {"nan", "inf", "-inf", "0x1", "1d5", "1 000", "1'000", ".", "", "e5", "1e", "--1", "1/3"})
    CHECK(contains(refusal("size_mm,mass\n1," + word + "\n2,0\n"),
                   "sand.csv:2: mass '" + word + "' is not a number"));
}

TEST_CASE("CSV: numbers are exact, within limits") {
  const std::string digits(1000, '7');
  CHECK(read("size_mm,mass\n1," + digits + "\n2,0\n").mass(0) == Rational(Integer(digits)));
  CHECK(read("size_mm,mass\n1,1e-400\n2,0\n").mass(0) * Rational(power_of_ten(400)) == 1);
  CHECK(contains(refusal("size_mm,mass\n1,7" + digits + "\n2,0\n"), "has more than 1000 digits"));
  CHECK(contains(refusal("size_mm,mass\n1,1e401\n2,0\n"),
                 "sand.csv:2: mass '1e401' has an exponent beyond 400"));
  CHECK(contains(refusal("size_mm,mass\n1,1e99999999999999999999\n2,0\n"), "has an exponent beyond 400"));
  const std::string message = refusal("size_mm,mass\n1," + std::string(10'000'000, '1') + "\n2,0\n");
  CHECK(contains(message, "has more than 1000 digits"));
  CHECK(message.size() < 200);
}

TEST_CASE("CSV: at least a header and two rows") {
  CHECK(contains(refusal(""), "sand.csv:1: there is no header"));
  CHECK(contains(refusal("\n\n# nothing\n"), "sand.csv:3: there is no header"));
  CHECK(contains(refusal("#\nsize_mm,mass\n"),
                 "sand.csv:2: a gradation needs at least two rows below the header, there are 0"));
  CHECK(contains(refusal("size_mm,mass\n1,1\n"),
                 "sand.csv:1: a gradation needs at least two rows below the header, there are 1"));
}

TEST_CASE("CSV: rows are as long as the header") {
  CHECK(contains(refusal("size_mm,mass\n1,1\n2\n"),
                 "sand.csv:3: the row has 1 field, the header has 2 fields: give each column its value"));
  CHECK(contains(refusal("size_mm;mass\n1;1;\n2;0\n"),
                 "sand.csv:2: the row has 3 fields, the header has 2 fields"));
}

TEST_CASE("CSV: only clean UTF-8 text") {
  CHECK(contains(refusal("size_mm,mass\n1,1\n2,0 \xFF\n"), "sand.csv:3: the text is not UTF-8"));
  CHECK(contains(refusal("size_mm,mass\n# \xED\xA0\x80\n1,1\n2,0\n"), "sand.csv:2: the text is not UTF-8"));
  CHECK(contains(refusal(std::string("size_mm,mass\n1,1\n2,0\n\0", 22)),
                 "sand.csv:4: the control character '\\x00'"));
  CHECK(contains(refusal("size_mm,mass\n#\x1B[31m\n1,1\n"), "sand.csv:2: the control character '\\x1b'"));
  CHECK(contains(refusal("size_mm,mass\n#\x7F\n1,1\n"), "sand.csv:2: the control character '\\x7f'"));
  CHECK(
      contains(refusal("size_mm,mass\n#\xC2\x85\n1,1\n"), "sand.csv:2: the control character '\\xc2\\x85'"));
  CHECK(contains(refusal("\x89PNG\r\n\x1A\n"), "sand.csv:1: the text is not UTF-8"));
  for (const char *mark :
       {"\u2028", "\u2029", "\u061C", "\u200E", "\u200F", "\u202A", "\u202E", "\u2066", "\u2069"})
    CHECK(contains(refusal("size_mm,mass\n# note" + std::string(mark) + "1,500\n1,1\n2,0\n"),
                   "sand.csv:2: the character '\\x"));
  CHECK(text(read("size_mm,mass\n# \u2027 \u202F \u2065 \u061B \u2070\n1,1\n2,0\n").masses()) == "1 0");
  CHECK(text(read("size_mm,mass\n# Sand \xC3\xA4 \xF0\x9F\x8F\x96\n1,1\n2,0\n").masses()) == "1 0");
}

TEST_CASE("CSV: a carriage return is only part of CRLF") {
  const std::string message = "a carriage return (CR) is there that no line feed (LF) follows";
  for (const char *line : {"1,1\r", "# lab 7\r1,40", "1,\"1\r\"", "1\r,1"})
    CHECK(contains(refusal("size_mm,mass\n" + std::string(line) + "\r\n2,0\n"), "sand.csv:2: " + message));
  CHECK(contains(refusal("size_mm,mass\r1,1\r2,0\r"), "sand.csv:1: " + message));
  CHECK(contains(refusal("size_mm,mass\r\n1,1\r\n2,0\r"), "sand.csv:3: " + message));
  CHECK(contains(refusal("{\"sizes\":[1,2],\r\"masses\":[1,0]}"), "sand.csv:1: " + message));
  CHECK(contains(refusal("\"GROUP\",\"GRAT\"\r\"HEADING\"\r\n"), "sand.csv:1: " + message));
  CHECK(contains(message_of([] {
                   read_envelope("size_mm,passing_min_percent,passing_max_percent\n# x\r2,40,60\n2,40,100\n",
                                 "b.csv");
                 }),
                 "b.csv:2: " + message));
}

TEST_CASE("CSV: edge 3: what stands in quotes is taken as it is") {
  CHECK(text(read("size_mm,mass\n\"pan\",1\n2,\"0\"\n").sizes()) == "0 2");
  CHECK(text(read("size_mm,mass\n \"PAN\" ,1\n2,0\n").sizes()) == "0 2");
  CHECK(contains(refusal("size_mm,mass\n\"pan \",1\n2,0\n"), "sand.csv:2: size_mm 'pan ' is not a number"));
  CHECK(contains(refusal("sieve,mass\n\"pan \",1\n2mm,0\n"), "sand.csv:2: sieve 'pan '"));
  CHECK(contains(refusal("size_mm,mass\npan,\" 1\"\n2,0\n"), "sand.csv:2: mass ' 1' is not a number"));
  CHECK(text(read("sieve,mass\npan,1\n\" No. 10 \",0\n").sizes()) == "0 2");
}

TEST_CASE("CSV: percents that do not add up to the whole are noted and used as they are") {
  CHECK(read("size_mm,retained_percent\n1,60\n2,38.5\n3,0\n").notes() ==
        std::vector<std::string>{
            "The percent retained values add up to 98.5, not 100; they are used as they are."});
  CHECK(read("size_mm,retained_fraction\n1,0.6\n2,0.5\n3,0\n").notes() ==
        std::vector<std::string>{
            "The fraction retained values add up to 1.1, not 1; they are used as they are."});
  CHECK(read("size_mm,retained_percent\n1,60\n2,40\n3,0\n").notes().empty());
  CHECK(read("size_mm,retained_g\n1,60\n2,38.5\n3,0\n").notes().empty());
}

TEST_CASE("CSV: conversions are noted") {
  CHECK(read("size_in,mass\n1,60\n2,0\n").notes() ==
        std::vector<std::string>{"Sizes in inches were converted to mm."});
  CHECK(read("sieve,mass\n1 in,60\n2 in,0\n").notes().empty());
  CHECK(read("size_phi,mass\n0.5,60\n2.25,1\n-1,0\n").notes().empty());
}

TEST_CASE("CSV: many rows take n log n time") {
  std::string content = "size_um,mass\n";
  for (int i = 100'000; i > 0; --i)
    content += std::to_string((i * 7919L) % 100'003) + ",0.5\n";
  content += "200000,0\n";
  const Gradation g = read(content);
  CHECK(g.classes() == 100'000);
  CHECK(g.lower(0) == 1);
}

TEST_CASE("CSV: more than 2^20 rows, or 64 MiB, are refused") {
  std::string content = "size_um,mass\n";
  for (std::size_t i = 0; i <= max_gradation_rows; ++i)
    content += "1,1\n";
  CHECK(contains(refusal(content), "there are more than 1048576 rows"));
  CHECK(contains(refusal(std::string(max_gradation_bytes + 1, '#')),
                 "sand.csv:1: the gradation has more than 64 MiB"));
}

TEST_CASE("A file's name is its id, and never spoils a message") {
  const std::string content = "size_mm,mass\n1,1\n2,0\n";
  CHECK(read_gradation(content, "/data.d/ottawa.f65.csv").id() == "ottawa.f65");
  CHECK(read_gradation(content, "plain").id() == "plain");
  CHECK(read_gradation(content, "a/.hidden").id() == ".hidden");
  CHECK(contains(message_of([] { read_gradation("", "bad\n\xFFname"); }), "bad\\x0a\\xffname:1: "));
}

} // namespace csv_reader_test
