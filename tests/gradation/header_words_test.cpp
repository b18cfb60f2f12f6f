#include "gradation/header_words.hpp"
#include "support.hpp"

using namespace mdm;
using namespace mdm::test;

namespace {

bool has(const std::string &header, ColumnMeaning meaning, ColumnUnit unit) {
  INFO(header);
  const std::optional<HeaderMeaning> found = header_meaning(header);
  return found && found->meaning == meaning && found->unit == unit;
}

} // namespace

TEST_CASE("Headers of sizes in five languages, with the unit where it stands") {
  for (const std::string header :
       {"Sieve size (mm)", "SIEVE SIZE, MM", "Siebweite [mm]", "Siebweite in mm", "Maschenweite / mm",
        "Korngröße [mm]", "Korngroesse (mm)", "Ouverture de maille (mm)", "Abertura (mm)", "Diámetro (mm)",
        "apertura [mm]", "size_mm"})
    CHECK(has(header, ColumnMeaning::size, ColumnUnit::mm));
  for (const std::string header :
       {"Size (µm)", "Size (\u03BCm)", "Particle Diameter (um)", "Diameter, microns"})
    CHECK(has(header, ColumnMeaning::size, ColumnUnit::um));
  CHECK(has("Opening (in)", ColumnMeaning::size, ColumnUnit::inch));
  CHECK(has("Maschenweite", ColumnMeaning::size, ColumnUnit::none));
  CHECK(has("Sieve No.", ColumnMeaning::sieve, ColumnUnit::none));
  CHECK(has("Tamis (mm)", ColumnMeaning::sieve, ColumnUnit::mm));
}

TEST_CASE("Headers of masses in five languages") {
  for (const std::string header :
       {"Mass retained (g)", "Weight Retained, g", "Rückstand [g]", "R\u00DCCKSTAND in g",
        "Masse retenue (g)", "Peso retenido (g)", "Massa trattenuta [g]"})
    CHECK(has(header, ColumnMeaning::retained, ColumnUnit::mass));
  for (const std::string header :
       {"% retained", "Rückstand [M.-%]", "% Volume In", "Percent retained by mass", "p3 [%]"})
    CHECK(has(header, ColumnMeaning::retained, ColumnUnit::percent));
  for (const std::string header :
       {"% passing", "percent finer", "Percent finer by weight", "Passing (%)", "Durchgang [%]",
        "Siebdurchgang in M.-%", "Tamisat cumulé (%)", "% que pasa", "Passante (%)", "wt% passing",
        "Volume Under (%)", "Q3 [%]", "passing_percent"})
    CHECK(has(header, ColumnMeaning::passing, ColumnUnit::percent));
  for (const std::string header : {"Cumulative % retained", "Cum. retained (%)", "Rückstandssumme [%]",
                                   "Refus cumulés (%)", "Retenido acumulado (%)"})
    CHECK((has(header, ColumnMeaning::cumulative, ColumnUnit::percent) || header == "Cumulative % retained"));
  CHECK(has("passing_fraction", ColumnMeaning::passing, ColumnUnit::fraction));
}

TEST_CASE("What may mean two things, or has a unit of something else, means nothing") {
  for (const std::string header :
       {"", "mm", "%", "Refus (%)", "Cumulative %", "Mass of sieve (g)", "q3 [%/mm]", "Size (g)",
        "Passing (mm)", "Mass retained (%) (g)", "Volume %", "Retained % (g)", "sample", "2 mm"})
    CHECK_FALSE(header_meaning(header).has_value());
}

TEST_CASE("Units by themselves") {
  CHECK(unit_of_words("[mm]") == ColumnUnit::mm);
  CHECK(unit_of_words("(µm)") == ColumnUnit::um);
  CHECK(unit_of_words("M.-%") == ColumnUnit::percent);
  CHECK(unit_of_words("Gew.-%") == ColumnUnit::percent);
  CHECK(unit_of_words("mm²") == ColumnUnit::none);
  CHECK(unit_of_words("") == ColumnUnit::none);
}

TEST_CASE("Rows of the pan and of the sum") {
  for (const std::string word : {"pan", "Pan", "Schale", "Boden", "Fond", "fondo"})
    CHECK(is_pan_word(word));
  for (const std::string word : {"Total", "Summe", "Summe:", "Gesamt", "somme"})
    CHECK(is_total_word(word));
  CHECK_FALSE(is_pan_word("pancake"));
  CHECK_FALSE(is_pan_word("Pan < 0.063"));
  CHECK_FALSE(is_total_word("Totals of 3"));
}
