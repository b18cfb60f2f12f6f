// Specification envelopes, and the names of sieves that figures show.

#include "gradation/sieve_name.hpp"
#include "support.hpp"

#include <mdm/gradation/envelope.hpp>
#include <mdm/number/decimal.hpp>

namespace envelope_test {

using namespace mdm;
using namespace mdm::test;

namespace {

constexpr const char *header = "size_mm,passing_min_percent,passing_max_percent\n";

std::string refusal_of(const std::string &content) {
  return message_of([&content] { read_envelope(content, "band.csv"); });
}

} // namespace

TEST_CASE("an envelope ascends by size whatever the order of its rows") {
  std::string content = "# C33\n";
  content.append(header).append("2.36,80,100\n0.6,25.5,60\n1.18,50,85\n");
  const Envelope e = read_envelope(content, "specs/c33.csv");
  CHECK(e.id == "c33");
  CHECK(e.unit == SizeUnit::mm);
  CHECK(e.sizes == std::vector<Rational>{ratio(3, 5), ratio(59, 50), ratio(59, 25)});
  CHECK(e.passing_min == std::vector<Rational>{ratio(51, 2), 50, 80});
  CHECK(e.passing_max == std::vector<Rational>{60, 85, 100});
  CHECK(e.notes.empty());
}

TEST_CASE("an envelope has the sizes of gradation files") {
  const Envelope names = read_envelope(
      "\uFEFFsieve;passing_min_percent;passing_max_percent\r\n\"#200\";0,5;3\r\n3/8 in;100;100\r\n", "x.csv");
  CHECK(names.sizes == std::vector<Rational>{ratio(3, 40), ratio(19, 2)});
  CHECK(names.passing_min[0] == ratio(1, 2));
  CHECK(read_envelope("size_um,passing_min_percent,passing_max_percent\n75,0,3\n", "x").unit == SizeUnit::um);
  CHECK(read_envelope("size_in,passing_min_percent,passing_max_percent\n1,0,3\n", "x").notes.size() == 1);
}

TEST_CASE("bounds that are no percentages, and what is no envelope, are refused with their line") {
  const std::string h = header;
  CHECK(contains(refusal_of(h + "1,101,100\n"), "band.csv:2: passing_min_percent 101 is above 100"));
  CHECK(contains(refusal_of(h + "pan,1,5\n"), "band.csv:2: passing_min_percent 1 at size 0"));
  CHECK(contains(refusal_of(h + "1,20,100.5\n"), "band.csv:2: passing_max_percent 100.5 is above 100"));
  CHECK(contains(refusal_of(h + "1,-1,100\n"), "band.csv:2: passing_min_percent -1 is negative"));
  CHECK(contains(refusal_of(h + "-1,1,100\n"), "band.csv:2: size -1 is negative"));
  CHECK(contains(refusal_of(h + "1,10,50\n1.0,20,60\n"), "band.csv:3: size 1 repeats that of line 2"));
  CHECK(contains(refusal_of(h + "1,x,50\n"), "band.csv:2: passing_min_percent 'x'"));
  CHECK(contains(refusal_of(h + "1,50\n"), "band.csv:2: the row has 2 fields, the header has 3"));
  CHECK(contains(refusal_of(h), "band.csv:1: there is no row"));
  CHECK(contains(refusal_of(""), "band.csv:1: there is no header"));
  CHECK(contains(refusal_of("size_mm,passing_percent\n1,0\n2,100\n"), "band.csv:1: a band has the columns"));
  CHECK(contains(refusal_of("size_mm,passing_min_percent,passing_max_percent,factor\n1,0,1,1\n"),
                 "band.csv:1:"));
}

TEST_CASE("an envelope of a specification has its limits in columns of its own words") {
  for (const std::string headers :
       {"Sieve size (mm),Lower,Upper", "Sieve (mm),Min,Max", "Size (mm),Lower limit (%),Upper limit (%)",
        "Opening (mm),% passing min,% passing max", "Sieve size (mm),Min. % passing,Max. % passing",
        "size_mm,Lower,Upper", "Siebweite [mm],untere Grenze,obere Grenze", "Tamis (mm),Minimum,Maximum"}) {
    INFO(headers);
    const Envelope e =
        read_envelope("Specification C33\n" + headers + "\n9.5,100,100\n1.18,50,85\n0.15,0,10\n", "x.csv");
    CHECK(text(e.sizes) == "0.15 1.18 9.5");
    CHECK(text(e.passing_min) == "0 50 100");
    CHECK(text(e.passing_max) == "10 85 100");
    CHECK(contains(e.notes.at(0), "the percent that passes from columns"));
  }
  const Envelope named = read_envelope("Sieve;Upper;Lower\n3/8 in.;100;100\nNo. 200;3,5;0\n", "x.csv");
  CHECK(text(named.sizes) == "0.075 9.5");
  CHECK(text(named.passing_max) == "3.5 100");
}

TEST_CASE("lower limits may all be 0") {
  CHECK(text(read_envelope("Sieve (mm),Lower,Upper\n1,0,60\n0.5,0,30\n", "x.csv").passing_min) == "0 0");
}

TEST_CASE("limits that may be of something else are refused") {
  const std::string h = "Sieve size (mm),Lower,Upper\n";
  CHECK(contains(refusal_of(h + "1,0,1\n0.5,0,0.4\n"),
                 "band.csv:1: no limit is above 1, so they may be fractions"));
  CHECK(contains(refusal_of(h + "1,0,10\n0.5,5,40\n"),
                 "band.csv:2: the limit 0 is below 5 of the next finer sieve"));
  CHECK(contains(refusal_of(h + "1,0,101\n"), "band.csv:2: the limit 101 is no percent"));
  CHECK(contains(refusal_of(h + "2,50,60\n1,50,\n"),
                 "band.csv:3: the size '1' has no value in the column 'Upper'"));
  CHECK(contains(refusal_of("Sieve size,Lower,Upper\n1,50,60\n"), "the size '1' has no unit"));
  for (const std::string headers : {"Sieve (mm),Lower (mm),Upper (mm)", "Sieve (mm),Lower,Mean",
                                    "Sieve (mm),Lower,Lower,Upper", "Sieve (mm),Lower (g),Upper (g)"})
    CHECK(contains(refusal_of(headers + "\n1,50,60,70\n"), "band.csv:1: first column"));
  CHECK(contains(
      refusal_of("Sieve (mm),Min % retained,Max % retained\n1,50,60\n"),
      "band.csv:1: 'Min % retained' is about what is retained, and limits are of the percent that passes"));
  CHECK(contains(refusal_of("Limits, percent retained\n" + h + "1,50,60\n"),
                 "band.csv:1: 'percent retained' is about what is retained"));
  CHECK(contains(refusal_of("Grenzwerte: Siebr\u00fcckstand in %\n" + h + "1,50,60\n"), "band.csv:1: "));
  CHECK(contains(
      refusal_of("Sieve (mm),A Lower,A Upper,B Lower,B Upper\n1,50,60,70,80\n"),
      "band.csv:1: there are 2 pairs of limits, as 'A Lower' and 'A Upper', 'B Lower' and 'B Upper': give "
      "each in a file of its own"));
}

TEST_CASE("an envelope that contradicts itself is read, and says where") {
  const auto reason = [](const std::string &rows) {
    return contradiction(read_envelope(header + rows, "x"));
  };
  CHECK(reason("1,20,10\n") == "at least 20 percent must pass 1 mm, but at most 10 may pass 1 mm");
  CHECK(reason("1,20,30\n2,0,10\n4,5,100\n") ==
        "at least 20 percent must pass 1 mm, but at most 10 may pass 2 mm");
  CHECK(reason("1,20,20\n2,0,20\n4,100,100\n") == std::nullopt);
  CHECK(reason("1,60,90\n2,50,80\n4,55,100\n") == std::nullopt);
}

TEST_CASE("openings have their ASTM names, and only they") {
  CHECK(astm_sieve_name(ratio(3, 40)) == "No. 200");
  CHECK(astm_sieve_name(ratio(19, 4)) == "No. 4");
  CHECK(astm_sieve_name(ratio(19, 2)) == "3/8 in");
  CHECK(astm_sieve_name(75) == "3 in");
  CHECK(astm_sieve_name(ratio(74, 1000)) == std::nullopt);
  CHECK(astm_sieve_name(0) == std::nullopt);
  for (const char *name : {"No. 635", "No. 3-1/2", "1/4 in", "5 in", "0.530 in"})
    CHECK(astm_sieve_name(sieve_opening(name)) == name);
}

TEST_CASE("an envelope with phi that is no whole number is refused") {
  CHECK(read_envelope("size_phi,passing_min_percent,passing_max_percent\n-1,100,100\n", "x").sizes ==
        std::vector<Rational>{2});
  const std::string message =
      refusal_of("size_phi,passing_min_percent,passing_max_percent\n-1,100,100\n-0.5,10,20\n");
  CHECK(contains(message, "band.csv:3: size_phi '-0.5' is no whole number"));
  CHECK(contains(message, "1.4142135623731"));
  CHECK(contains(message, "mdm convert"));
}

} // namespace envelope_test
