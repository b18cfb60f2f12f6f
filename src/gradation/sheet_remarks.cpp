#include "gradation/sheet_remarks.hpp"

#include "gradation/plain_words.hpp"
#include "text/lines.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// True for D and a number: `d10`, `10`.
bool names_diameter(const std::vector<std::string> &words) {
  const auto is_number = [](std::string_view word) {
    return !word.empty() && std::all_of(word.begin(), word.end(), is_digit);
  };
  return words.front().front() == 'd' && (is_number(std::string_view(words.front()).substr(1)) ||
                                          (words.front() == "d" && words.size() > 1 && is_number(words[1])));
}

} // namespace

bool names_index(std::string_view cell) {
  const std::vector<std::string> words = words_of(cell);
  const std::string all = plain_words(cell);
  return !words.empty() && (all == "fm" || all == "f m" || all == "cu" || all == "cc" ||
                            all.find("modul") != std::string::npos || names_diameter(words));
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
  const std::vector<std::string> words = words_of(cell);
  return !words.empty() && std::all_of(words.begin(), words.end(),
                                       [names](const std::string &word) { return has_word(names, word); });
}

} // namespace mdm
