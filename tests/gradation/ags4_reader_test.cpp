#include "support.hpp"

namespace ags4_reader_test {

using namespace mdm;
using namespace mdm::test;

namespace {

const std::string head = "\"GROUP\",\"PROJ\"\r\n\"HEADING\",\"PROJ_ID\"\r\n\"DATA\",\"not \"closed\r\n\r\n"
                         "\"GROUP\",\"GRAT\"\r\n"
                         "\"HEADING\",\"LOCA_ID\",\"SAMP_TOP\",\"SAMP_REF\",\"SPEC_REF\",\"GRAT_SIZE\","
                         "\"GRAT_PERP\",\"GRAT_REM\"\r\n"
                         "\"UNIT\",\"\",\"m\",\"\",\"\",\"mm\",\"%\",\"\"\r\n"
                         "\"TYPE\",\"ID\",\"2DP\",\"X\",\"X\",\"3SF\",\"0DP\",\"X\"\r\n";

std::string row(const std::string &location, const std::string &reference, const std::string &size,
                const std::string &passing) {
  return "\"DATA\",\"" + location + "\",\"24.55\",\"\",\"" + reference + "\",\"" + size + "\",\"" + passing +
         "\",\"a \"\"b\"\"\"\r\n";
}

const std::string sand = row("327-16A", "1a", "3.35", "100") + row("327-16A", "1a", "0.063", "8") +
                         row("327-16A", "1a", "1.18", "60");
const std::string gravel = row("BH2", "1", "20", "100") + row("BH2", "1", "2", "0");
const std::string other_gravel = row("BH2", "2", "20", "100") + row("BH2", "2", "5", "0");

Reading reading(const std::optional<std::string> &specimen) {
  Reading r;
  r.specimen = specimen;
  return r;
}

Gradation read_specimen(const std::string &content, const std::string &specimen) {
  return read_gradation(content, "site.ags", reading(specimen));
}

std::string refusal_of(const std::string &content,
                       const std::optional<std::string> &specimen = std::nullopt) {
  return message_of([&] { read_gradation(content, "site.ags", reading(specimen)); });
}

} // namespace

TEST_CASE("AGS4 is told by its first field") {
  CHECK(is_ags4(head));
  CHECK(is_ags4("\xEF\xBB\xBF\r\n\"GROUP\",\"PROJ\""));
  CHECK_FALSE(is_ags4("\"HEADING\""));
  CHECK_FALSE(is_ags4("GROUP,PROJ"));
  CHECK_FALSE(is_ags4(""));
}

TEST_CASE("AGS4: the only specimen is read, other groups are not") {
  const std::string tail =
      "\r\n\"GROUP\",\"GEOL\"\r\n\"HEADING\",\"LOCA_ID\"\r\n\"DATA\",\"327-16A\"\r\n\xFF\r\n";
  const Gradation g = read_gradation("\xEF\xBB\xBF" + head + sand + tail, "site.ags");
  CHECK(g.id() == "327-16A/24.55/1a");
  CHECK(text(g.sizes()) == "0 0.063 1.18 3.35");
  CHECK(text(g.masses()) == "8 52 40 0");
  REQUIRE(g.notes().size() == 2);
  CHECK(g.notes()[0] == "Specimen '327-16A/24.55/1a' of 1.");
}

TEST_CASE("AGS4: all specimens are read in the order of the file, each by itself") {
  const std::vector<UnreadGradation> all = gradations_in(
      head + gravel + sand + row("X", "", "2", "101") + row("X", "", "1", "0") + other_gravel, "site.ags");
  REQUIRE(all.size() == 4);
  CHECK(all[0].id == "BH2/24.55/1");
  CHECK(all[1].id == "327-16A/24.55/1a");
  CHECK(text(all[1].read().masses()) == "8 52 40 0");
  CHECK(all[3].read().id() == "BH2/24.55/2");
  CHECK(contains(message_of([&] { all[2].read(); }), "site.ags:14: percent passing 101 is above 100"));
  CHECK(contains(message_of([] { gradations_in(head, "site.ags"); }), "has no DATA row"));
}

TEST_CASE("AGS4: one of several specimens is chosen by its id, or by its location if that is enough") {
  const std::string content = head + gravel + sand + other_gravel;
  CHECK(read_specimen(content, "327-16A/24.55/1a").classes() == 3);
  CHECK(read_specimen(content, "327-16A").classes() == 3);
  CHECK(text(read_specimen(content, "BH2/24.55/2").sizes()) == "5 20");
  CHECK(refusal_of(content) ==
        "site.ags:9: there are 3 specimens: 'BH2/24.55/1', '327-16A/24.55/1a', 'BH2/24.55/2'; "
        "choose one by --specimen-id");
  CHECK(
      contains(refusal_of(content, "BH2"), "site.ags:9: 'BH2' does not name one specimen of: 'BH2/24.55/1'"));
  CHECK(contains(refusal_of(content, "BH3"), "'BH3' does not name one specimen of"));
}

TEST_CASE("AGS4: SAMP_ID or SAMP_REF serve where one is enough, and GRAT_TYPE is noted") {
  const std::string both =
      "\"GROUP\",\"GRAT\"\n\"HEADING\",\"LOCA_ID\",\"SAMP_REF\",\"SAMP_ID\",\"GRAT_SIZE\",\"GRAT_PERP\","
      "\"GRAT_TYPE\"\n\"UNIT\",\"\",\"\",\"\",\"mm\",\"%\",\"\"\n"
      "\"DATA\",\"BH1\",\"R1\",\"S1\",\"2\",\"100\",\"WS\"\n"
      "\"DATA\",\"BH1\",\"R1\",\"S1\",\"0.02\",\"7\",\"HY\"\n"
      "\"DATA\",\"BH1\",\"R2\",\"S2\",\"4\",\"100\",\"DS\"\n"
      "\"DATA\",\"BH1\",\"R2\",\"S2\",\"1\",\"7\",\"DS\"\n";
  CHECK(text(read_specimen(both, "S2").sizes()) == "0 1 4");
  CHECK(text(read_specimen(both, "R2").sizes()) == "0 1 4");
  CHECK(read_specimen(both, "R1").notes()[1] == "GRAT_TYPE: WS, HY.");
  CHECK(understand_gradation(both, "site.ags", reading("S1")).samples ==
        std::vector<std::string>{"BH1/R1/S1", "BH1/R2/S2"});
  CHECK(contains(refusal_of(both, "BH1"), "'BH1' does not name one specimen of"));
}

TEST_CASE("AGS4: at most ten specimens are listed") {
  std::string content = head;
  for (int i = 10; i < 25; ++i)
    content += row("BH" + std::to_string(i), "1", "20", "100") + row("BH" + std::to_string(i), "1", "2", "0");
  CHECK(contains(refusal_of(content), "'BH19/24.55/1' and 5 more; choose one"));
}

TEST_CASE("AGS4: what is wrong is said with its line") {
  const auto replaced = [](std::string content, const std::string &old, const std::string &by) {
    return content.replace(content.find(old), old.size(), by);
  };
  CHECK(contains(refusal_of("\"GROUP\",\"PROJ\"\n"),
                 "site.ags:1: this AGS4 file has no DATA row in a group GRAT"));
  CHECK(contains(refusal_of(replaced(head + sand, "\"mm\"", "\"m\"")),
                 "site.ags:7: GRAT_SIZE has the unit 'm', only 'mm' is read"));
  CHECK(contains(refusal_of(replaced(head + sand, "\"%\"", "\"\"")),
                 "site.ags:7: GRAT_PERP has the unit '', only '%' is read"));
  CHECK(contains(refusal_of(replaced(head + sand, "\"UNIT\"", "\"X\"")),
                 "site.ags:9: group GRAT has no UNIT row above"));
  CHECK(contains(refusal_of(replaced(head + sand, "\"HEADING\",\"LOCA_ID\"", "\"X\",\"LOCA_ID\"")),
                 "site.ags:7: group GRAT has no HEADING row above"));
  CHECK(contains(refusal_of(replaced(head + sand, "GRAT_PERP", "GRAT_X")),
                 "site.ags:6: group GRAT has no column GRAT_PERP"));
  CHECK(contains(refusal_of(replaced(head + sand, "\"100\"", "\"\"")),
                 "site.ags:9: GRAT_PERP '' is not a number"));
  CHECK(contains(refusal_of(replaced(head + sand, "\"100\"", "\"101\"")),
                 "site.ags:9: percent passing 101 is above 100"));
  CHECK(contains(refusal_of(replaced(head + sand, "\"100\"", "\"99\"")),
                 "site.ags:9: the largest sieve, 3.35 mm, has percent passing 99"));
  CHECK(contains(refusal_of(replaced(head + sand, "\"100\",", "")),
                 "site.ags:9: the row has 7 fields, HEADING has 8"));
  CHECK(contains(refusal_of(replaced(head + sand, "\"100\",", "\"100,")),
                 "site.ags:9: a quoted field does not end"));
  CHECK(contains(refusal_of(head + row("A", "1", "2", "100")),
                 "site.ags:9: a gradation needs at least two rows"));
}

TEST_CASE("A specimen is chosen in AGS4 files alone") {
  CHECK(
      contains(refusal_of("size_mm,mass\n1,1\n2,0\n", "BH2"), "site.ags:1: --specimen-id is for AGS4 files"));
}

} // namespace ags4_reader_test
