#include "gradation/weighed_sieves.hpp"

#include "gradation/header_words.hpp"
#include "gradation/plain_words.hpp"

#include <algorithm>

namespace mdm {
namespace {
/// Short names, kept apart from those of other files.
namespace weighing {

constexpr std::string_view mass = "mass masses weight weights wt masse gewicht poids masa peso massa";
constexpr std::string_view sieve =
    "sieve sieves sieb siebe siebs siebes tamis tamiz tamices setaccio setacci";
constexpr std::string_view empty =
    "empty tare leer leeres leeren leere leergewicht tara vide vides vacio vacios vuoto vuoti";
constexpr std::string_view with = "plus and with und mit et avec y con e";
constexpr std::string_view content =
    "soil sample retained material aggregate sand dry boden probe rueckstand siebgut sol materiau "
    "refus suelo muestra retenido terreno campione trattenuto";
constexpr std::string_view link = "of the each der des die du de la le del el los della dei di";

/// The words of a header of masses; none where its unit is another.
std::vector<std::string> words(std::string_view header) {
  return words_in(header, ColumnUnit::mass);
}

/// True where every word is in one of the lists.
bool are_all_in(const std::vector<std::string> &words, std::initializer_list<std::string_view> lists) {
  return std::all_of(words.begin(), words.end(), [&lists](const std::string &word) {
    return std::any_of(lists.begin(), lists.end(),
                       [&word](std::string_view list) { return has_word(list, word); });
  });
}

bool is_of_full_sieves(std::string_view header) {
  const std::vector<std::string> all = words(header);
  const bool joins = has_any_word(with, all) || header.find('&') != std::string_view::npos;
  return joins && has_any_word(sieve, all) && has_any_word(content, all) &&
         are_all_in(all, {mass, sieve, with, content, link});
}

bool is_of_empty_sieves(std::string_view header) {
  const std::vector<std::string> all = words(header);
  const bool says_mass = has_any_word(mass, all) || unit_in_header(header) == ColumnUnit::mass;
  return (has_any_word(empty, all) || (says_mass && has_any_word(sieve, all))) &&
         are_all_in(all, {mass, sieve, empty, link});
}

/// The place of the only cell that is such a header; nothing where there is none or there are several.
template <typename Condition>
std::optional<std::size_t> only_place(const CellRow &header, Condition is_it) {
  const auto first = std::find_if(header.cells.begin(), header.cells.end(), is_it);
  if (first == header.cells.end() || std::find_if(first + 1, header.cells.end(), is_it) != header.cells.end())
    return std::nullopt;
  return static_cast<std::size_t>(first - header.cells.begin());
}

} // namespace weighing
} // namespace

bool names_empty_sieves(std::string_view header) {
  return weighing::is_of_empty_sieves(header);
}

bool names_mass_alone(std::string_view header) {
  const std::vector<std::string> all = weighing::words(header);
  return !all.empty() && weighing::are_all_in(all, {weighing::mass, weighing::link});
}

std::optional<WeighedSieves> weighed_sieves(const CellRow &header) {
  const std::optional<std::size_t> full = weighing::only_place(header, weighing::is_of_full_sieves);
  const std::optional<std::size_t> empty = weighing::only_place(header, weighing::is_of_empty_sieves);
  return full && empty ? std::optional(WeighedSieves{*full, *empty}) : std::nullopt;
}

} // namespace mdm
