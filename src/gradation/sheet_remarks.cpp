#include "gradation/sheet_remarks.hpp"

#include "gradation/plain_words.hpp"
#include "text/lines.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// True for diameters of the curve alone, each D and a usual percent, with a unit or not: `d10`, `d 10
/// (mm)`, `D60/D10`; `d 0.063 mm` and `d > 4 mm` may be sieves.
bool names_diameters(std::string_view cell) {
  if (cell.find_first_of("<>=.,-") != std::string_view::npos)
    return false;
  constexpr std::string_view percents =
      "5 10 15 16 17 20 25 30 35 40 45 50 60 65 70 75 80 83 84 85 90 95 97 98 99";
  const auto is_percent = [percents](std::string_view word) { return has_word(percents, word); };
  const std::vector<std::string> words = words_of(cell);
  bool has_diameter = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view word = words[i];
    const bool is_apart =
        word == "d" && i + 1 < words.size() && is_percent(words[i + 1]) && words.size() <= i + 3;
    if (is_apart)
      ++i;
    if (is_apart || (word.starts_with('d') && is_percent(word.substr(1))))
      has_diameter = true;
    else if (word != "mm" && word != "um" && word != "m")
      return false;
  }
  return has_diameter;
}

} // namespace

bool names_index(std::string_view cell) {
  const std::vector<std::string> words = words_of(cell);
  const std::string all = plain_words(cell);
  return !words.empty() && (all == "fm" || all == "f m" || all == "cu" || all == "cc" ||
                            all.find("modul") != std::string::npos || names_diameters(cell));
}

bool heads_remarks(std::string_view header) {
  return has_word(
      "note notes remark remarks comment comments anmerkung anmerkungen bemerkung bemerkungen bem "
      "anm hinweis remarque remarques nota notas observacion observaciones obs osservazione "
      "osservazioni",
      plain_words(header));
}

bool names_remark(std::string_view cell) {
  constexpr std::string_view names =
      "date datum fecha data page seite pagina folio report bericht project projekt job order auftrag lab "
      "labor "
      "laboratory no nr number id ref reference year time temperature temperatur revision rev version phone "
      "tel test "
      "versuch operator checked tested moisture water wassergehalt humidity humedad umidita teneur contenido "
      "content "
      "density dichte densite densidad densita particle specific gravity kornrohdichte porosity void ratio "
      "ll pl pi wl "
      "wp liquid plastic limit plasticity index depth tiefe profondeur profundidad profondita bohrung "
      "coefficient "
      "ungleichfoermigkeit ungleichfoermigkeitszahl kruemmungszahl uniformity curvature cu cc kf "
      "permeability fineness "
      "modulus modul span sorting skewness kurtosis median mode percent of the de la du mm um m s cm cm3 m3 "
      "kg g mg c effective maximum max nominal size calibration "
      "equivalent group surface area";
  return has_only_words(names, words_of(cell));
}

} // namespace mdm
