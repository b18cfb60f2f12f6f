#include "plot/figure_form.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace mdm {
namespace {

constexpr FigureTexts english_texts = {
    .size = "size",
    .passing = "percent passing",
    .retained = "percent retained, cumulative",
    .analysis = "sieve analysis",
    .particles = "set of particles",
    .target = "target: ",
    .allowed = "allowed: ",
    .counts = "particles in the class",
    .outside = "outside all classes: ",
    .finer = "finer than ",
    .no_group = "USCS: not available",
    .bands = "bands: ",
    .passing_shown = "Percent passing over the size; of a set of particles, its steps.",
    .counts_shown = "The number of particles of each class over the size.",
    .missed = "a limit is missed",
    .curves_shown = "Percent passing over the size, a curve for each gradation.",
    .count = "N (particles)",
    .proved = "N, proved smallest",
    .at_limit = "N at a limit, down to what is proved",
    .by_tolerance = "the smallest match within a tolerance",
    .by_sieve = "the smallest match without the finest classes",
    .exact_by_sieve = "the exact match without the finest classes",
    .of_retained = "tolerance on percent retained (percentage points)",
    .of_passing = "tolerance on percent passing (percentage points)",
    .of_total = "sum of deviations (percentage points)",
    .smallest_sieve = "smallest sieve kept",
    .pan = "pan",
    .lost = "mass lost (percent)",
    .lost_at_right = "mass lost (right)",
    .tradeoff_shown = "The number of particles over the tolerance, and over the smallest sieve that is kept.",
    .axial_strain = "axial strain (percent)",
    .deviator = "deviator stress",
    .deviator_unit = "q (kPa)",
    .volume = "change of volume, compression positive",
    .volumetric_strain = "volumetric strain (percent)",
    .constant_stress = "constant: ",
    .triaxial_shown =
        "Of a triaxial test the deviator stress and the volumetric strain over the axial strain.",
    .no_texture = "no texture",
    .texture_shown = "A triangle of three parts of the mass, with the fields of the textures; a point for "
                     "each gradation."};

constexpr FigureTexts german_texts = {
    .size = "Größe",
    .passing = "Durchgang in Prozent",
    .retained = "Rückstand in Prozent, summiert",
    .analysis = "Siebanalyse",
    .particles = "Partikelmenge",
    .target = "Soll: ",
    .allowed = "zulässig: ",
    .counts = "Partikel in der Klasse",
    .outside = "außerhalb aller Klassen: ",
    .finer = "feiner als ",
    .no_group = "USCS: nicht bestimmbar",
    .bands = "Bereiche: ",
    .passing_shown = "Durchgang in Prozent über der Größe; von einer Partikelmenge die Stufen.",
    .counts_shown = "Die Partikelzahl jeder Klasse über der Größe.",
    .missed = "eine Grenze ist verletzt",
    .curves_shown = "Durchgang in Prozent über der Größe, eine Linie für jede Körnung.",
    .count = "N (Partikel)",
    .proved = "N, bewiesen kleinstes",
    .at_limit = "N an einer Grenze, hinab bis zum Bewiesenen",
    .by_tolerance = "die kleinste Menge innerhalb einer Toleranz",
    .by_sieve = "die kleinste Menge ohne die feinsten Klassen",
    .exact_by_sieve = "die exakte Menge ohne die feinsten Klassen",
    .of_retained = "Toleranz je Klasse (Prozentpunkte)",
    .of_passing = "Toleranz im Durchgang (Prozentpunkte)",
    .of_total = "Summe der Abweichungen (Prozentpunkte)",
    .smallest_sieve = "kleinstes behaltenes Sieb",
    .pan = "Schale",
    .lost = "verlorene Masse (Prozent)",
    .lost_at_right = "verlorene Masse (rechts)",
    .tradeoff_shown = "Die Partikelzahl über der Toleranz und über dem kleinsten behaltenen Sieb.",
    .axial_strain = "axiale Dehnung (Prozent)",
    .deviator = "Deviatorspannung",
    .deviator_unit = "q (kPa)",
    .volume = "Volumenänderung, Verdichtung positiv",
    .volumetric_strain = "Volumendehnung (Prozent)",
    .constant_stress = "konstant: ",
    .triaxial_shown =
        "Von einem Triaxialversuch die Deviatorspannung und die Volumendehnung über der axialen Dehnung.",
    .no_texture = "keine Bodenart",
    .texture_shown = "Ein Dreieck aus drei Anteilen der Masse mit den Feldern der Bodenarten; ein Punkt für "
                     "jede Körnung."};

using Pair = std::pair<std::string_view, std::string_view>;

constexpr std::array<Pair, 9> german_bands = {{{"large boulders", "große Blöcke"},
                                               {"boulders", "Blöcke"},
                                               {"cobbles", "Steine"},
                                               {"gravel", "Kies"},
                                               {"sand", "Sand"},
                                               {"silt", "Schluff"},
                                               {"clay", "Ton"},
                                               {"mud", "Schlamm"},
                                               {"fines", "Feinkorn"}}};
constexpr std::array<Pair, 3> german_parts = {{{"coarse", "grob"}, {"medium", "mittel"}, {"fine", "fein"}}};

template <class Pairs>
std::string_view german(const Pairs &pairs, std::string_view english) {
  const auto found =
      std::find_if(pairs.begin(), pairs.end(), [&](const Pair &p) { return p.first == english; });
  return found == pairs.end() ? std::string_view() : found->second;
}

} // namespace

const FigureTexts &figure_texts(Language language) {
  return language == Language::german ? german_texts : english_texts;
}

std::vector<std::string> band_names(std::string_view band, Language language) {
  std::string full(band);
  std::string first(band.substr(0, band.find(' ')));
  if (language == Language::german) {
    const std::string_view part = german(german_parts, first);
    const bool is_part = !part.empty() && first != band;
    full = german(german_bands, is_part ? band.substr(first.size() + 1) : band);
    first = is_part ? std::string(part) : full;
    if (is_part) // Grobkies
      full = first + std::string(1, static_cast<char>(full[0] - 'A' + 'a')) + full.substr(1);
    if (is_part)
      full[0] = static_cast<char>(full[0] - 'a' + 'A');
  }
  return {full, first, first.substr(0, 1)};
}

} // namespace mdm
