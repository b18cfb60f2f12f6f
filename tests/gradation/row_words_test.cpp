#include "gradation/row_words.hpp"
#include "support.hpp"

namespace row_words_test {

using namespace mdm;

namespace {

void check_all(RowMeaning meaning, std::initializer_list<const char *> labels) {
  for (const char *label : labels) {
    INFO(label);
    CHECK(row_words(label).meaning == meaning);
  }
}

} // namespace

TEST_CASE("The row of the pan in five languages") {
  check_all(RowMeaning::pan, {"Pan", "pan", "In pan", "Material in the pan P", "Schale", "Bodenschale",
                              "Boden", "Fond", "Fondo", "Receiver", "Pan (< 0.063 mm)", "Mass in pan (g)"});
}

TEST_CASE("What was washed out in five languages") {
  check_all(RowMeaning::wash_loss,
            {"Wash loss", "Loss on wash (g)", "Washed out", "Fines (washing)", "Loss by washing", "Wash",
             "Wash loss (No. 200)", "Dry mass of fines removed by washing", "Waschverlust", "Abschlämmbares",
             "Ausgewaschen", "Perte au lavage", "Fines lavées", "Pérdida por lavado", "Finos lavados",
             "Perdita per lavaggio", "Passing No. 200 by washing"});
  check_all(RowMeaning::pan_and_wash, {"Pan + wash", "Pan and wash loss", "Schale + Waschverlust",
                                       "Fond et lavage", "Fondo + lavado", "Fondo e lavaggio"});
}

TEST_CASE("What passes a sieve that is named") {
  check_all(RowMeaning::passing,
            {"< 0.063", "<63 um", "Minus No. 200", "-#200", "Passing 63 um", "Finer than 0.075 mm",
             "Kleiner 0,063", "Passant 0,063 mm", "Pasa No. 200", "Passante 0,063 mm"});
  CHECK(row_words("Minus No. 200").sieve == "No. 200");
  CHECK(row_words("-#200").sieve == "#200");
  CHECK(row_words("Passing 63 um sieve").sieve == "63 um");
  CHECK(row_words("< 0,063").sieve == "0,063");
  CHECK(row_words("Passing No.200 (75 um)").sieve == "No. 200");
}

TEST_CASE("Masses beside the table") {
  check_all(RowMeaning::initial_mass,
            {"Dry mass before wash (g)", "Initial dry mass", "Dry mass (g)", "Total dry mass M1",
             "Trockenmasse", "Einwaage", "Trockenmasse vor dem Waschen", "Masse sèche", "Masa seca inicial",
             "Massa secca", "Weight of dry sample", "Sample mass (g)"});
  check_all(RowMeaning::washed_mass,
            {"Dry mass after wash (g)", "Mass after washing", "Dry mass after washing M2",
             "Masse sèche après lavage", "Trockenmasse nach dem Waschen", "Masa seca después del lavado",
             "Massa secca dopo lavaggio"});
  check_all(RowMeaning::sieved_mass, {"Mass before sieving"});
  check_all(RowMeaning::total,
            {"Total", "Summe", "Total mass", "Sum of masses", "Mass after sieving", "Somme"});
  check_all(RowMeaning::sieve_loss, {"Loss", "Sieving loss (g)", "Siebverlust", "Perte"});
  check_all(RowMeaning::container, {"Tare", "Mass of container"});
  check_all(RowMeaning::with_container, {"Mass of container + dry soil"});
  check_all(RowMeaning::moist_mass, {"Wet mass (g)", "Moist mass of sample"});
}

TEST_CASE("Words that are not all known, or mean two things, mean nothing") {
  check_all(RowMeaning::none,
            {"", "pancake", "D50", "Fines", "Silt and clay", "Totals of Smith", "Specific gravity",
             "Operator", "Passing", "> 4 mm", "Mass of container + wet soil in pan"});
}

TEST_CASE("Words of a part that was sieved for the whole") {
  for (const char *text : {"Split on No. 4", "Mass of subsample", "Sub-sample (g)", "Riffled", "Reduced mass",
                           "Teilprobe", "Quartage", "Submuestra", "Sottocampione"}) {
    INFO(text);
    CHECK(speaks_of_splitting(text));
  }
  for (const char *text : {"Split-spoon sample S-4", "Split barrel", "Sample", "No. 4"}) {
    INFO(text);
    CHECK_FALSE(speaks_of_splitting(text));
  }
}

} // namespace row_words_test
