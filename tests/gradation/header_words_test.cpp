#include "gradation/header_words.hpp"
#include "support.hpp"

namespace header_words_test {

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
    CHECK(has(header, ColumnMeaning::cumulative, ColumnUnit::percent));
  CHECK(has("passing_fraction", ColumnMeaning::passing, ColumnUnit::fraction));
}

TEST_CASE("Percent may stand between the words, and short forms and symbols do not count") {
  for (const std::string header :
       {"Cumulative % retained", "Cum. % Ret.", "Cumulative percentage of material retained",
        "Rückstand kumuliert [M.-%]", "% retenido acumulado", "Refus cumulés en %", "% trattenuto cumulato"})
    CHECK(has(header, ColumnMeaning::cumulative, ColumnUnit::percent));
  for (const std::string header : {"Cumulative % passing", "Cumulative % finer", "Percentage passing",
                                   "Total % passing", "% pass", "% finer by mass", "Porcentaje que pasa",
                                   "Pourcentage passant", "% di passante", "Prozent Durchgang"})
    CHECK(has(header, ColumnMeaning::passing, ColumnUnit::percent));
  for (const std::string header :
       {"Wt. retained (g)", "Wt. Ret., g", "Ri (g)", "Mass of material retained Ri (g)", "Grams retained",
        "Mass of soil retained on each sieve (g)", "Rückstand auf dem Sieb [g]",
        "Masse des refus partiels (g)", "Masse retenue sur chaque tamis (g)", "Peso retenido en el tamiz (g)",
        "Peso trattenuto sul setaccio (g)"})
    CHECK(has(header, ColumnMeaning::retained, ColumnUnit::mass));
  for (const std::string header :
       {"BS test sieve (mm)", "Test sieve (mm)", "IS sieve, mm", "Prüfsieb [mm]", "Tamis NF (mm)"})
    CHECK(has(header, ColumnMeaning::sieve, ColumnUnit::mm));
  for (const std::string header :
       {"Sieve aperture size (mm)", "Korndurchmesser d [mm]", "Korngröße d [mm]", "sieve opening (mm)",
        "Nominal sieve opening (mm)", "Mesh (mm)", "Lichte Maschenweite w [mm]", "Ouverture des tamis (mm)",
        "Dimension des mailles (mm)", "Diamètre des grains d (mm)", "Abertura de la malla (mm)",
        "Tamaño de partícula (mm)", "Luce delle maglie (mm)", "Diametro dei grani (mm)"})
    CHECK(has(header, ColumnMeaning::size, ColumnUnit::mm));
  CHECK(has("sieve opening", ColumnMeaning::size, ColumnUnit::none));
  for (const std::string header :
       {"Sieve", "Sieve No.", "US Standard Sieve No.", "U.S. Sieve Size No.", "N° de tamis"})
    CHECK(has(header, ColumnMeaning::sieve, ColumnUnit::none));
}

TEST_CASE("A word that is not known, or that says something else, leaves a header unknown") {
  for (const std::string header : {"Sieve + retained (g)",
                                   "Mass of sieve and soil retained (g)",
                                   "Wet mass retained (g)",
                                   "Ri",
                                   "Ri (%)",
                                   "Sieve diameter (mm)",
                                   "Sieve No. (mm)",
                                   "Mesh",
                                   "Malla",
                                   "Tyler sieve No.",
                                   "Dimension (mm)",
                                   "Passing / retained (%)",
                                   "Individual % passing",
                                   "Number passing (%)",
                                   "Mean % passing",
                                   "Cumulative individual retained (g)",
                                   "D50 (mm)",
                                   "d (mm)",
                                   "Mass of soil (g)",
                                   "Total mass (g)",
                                   "Specification % passing"})
    CHECK_FALSE(header_meaning(header).has_value());
}

TEST_CASE("What is retained may be cumulative where the words do not say it") {
  for (const std::string header : {"Total % retained", "Poids refus (g)", "Refus (%)"})
    CHECK(header_meaning(header).value().is_unclear);
  for (const std::string header :
       {"Refus cumulés (g)", "Refus partiel (g)", "Mass retained (g)", "Tamisat (%)"})
    CHECK_FALSE(header_meaning(header).value().is_unclear);
}

TEST_CASE("A unit of length alone is a header of sizes") {
  CHECK(has("mm", ColumnMeaning::size, ColumnUnit::mm));
  CHECK(has("[µm]", ColumnMeaning::size, ColumnUnit::um));
  CHECK(has("Microns", ColumnMeaning::size, ColumnUnit::um));
  CHECK(has("Phi", ColumnMeaning::size, ColumnUnit::phi));
}

TEST_CASE("What may mean two things, or has a unit of something else, means nothing") {
  for (const std::string header :
       {"", "m", "in", "u", "%", "Cumulative %", "Mass of sieve (g)", "q3 [%/mm]", "Size (g)", "Passing (mm)",
        "Mass retained (%) (g)", "Volume %", "Retained % (g)", "sample", "2 mm"})
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

} // namespace header_words_test
