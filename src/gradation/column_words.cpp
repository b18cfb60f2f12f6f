#include "gradation/column_words.hpp"

#include "gradation/plain_words.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace mdm {
namespace {
/// Short names, kept apart from those of other files.
namespace column_roles {

/// What a word adds to a header. A word may have several roles.
enum Role : unsigned {
  opening = 1u << 0,  ///< the opening of a sieve, or a size that says by itself what it is the size of
  diameter = 1u << 1, ///< of a grain: the diameter of a sieve is that of its frame
  extent = 1u << 2,   ///< a size of something that another word must name
  sieve = 1u << 3,    ///
  mesh = 1u << 4,     ///< an opening with a unit, the number of a sieve without one
  grain = 1u << 5,    ///
  number = 1u << 6,   ///< of a sieve
  standard = 1u << 7, ///< words beside a sieve that change nothing
  retained = 1u << 8, ///
  refusal = 1u << 9,  ///< French: what a sieve retains, or all coarser ones too
  passing = 1u << 10, ///
  cumulative = 1u << 11,
  individual = 1u << 12,
  whole = 1u << 13,    ///< `total passing` is cumulative, `total retained` may be either
  mass = 1u << 14,     ///< may stand alone for what a sieve retains
  material = 1u << 15, ///< words beside masses that change nothing
  link = 1u << 16,     ///< articles and the like
  place = 1u << 17     ///< `on` a sieve
};

struct RoleWords {
  unsigned roles;
  std::string_view words; ///< as plain_words gives them, with spaces between them
};

constexpr std::array vocabulary = {
    // English
    RoleWords{opening, "size sizes opening openings aperture apertures"},
    RoleWords{diameter, "diameter diam dia"},
    RoleWords{sieve, "sieve sieves"},
    RoleWords{mesh, "mesh"},
    RoleWords{grain, "particle particles grain grains equivalent"},
    RoleWords{number, "no nos number numbers"},
    RoleWords{standard, "us u s usa as bs british astm iso din is indian standard test nominal square name "
                        "designation nf une uni cnr range ranges class classes"},
    RoleWords{retained, "retained ret retd"},
    RoleWords{retained | cumulative, "oversize coarser"},
    RoleWords{passing, "passing pass passed finer undersize smaller less through thru under cpft"},
    RoleWords{cumulative, "cumulative cum cumm cumul cumulated accum accumulated"},
    RoleWords{individual, "individual indiv ind partial"},
    RoleWords{whole, "total totale totali totales"},
    RoleWords{mass, "mass weight wt"},
    RoleWords{material, "material soil sample aggregate dry masses weights volume vol than ri net"},
    RoleWords{link, "of the each a d age"},
    RoleWords{place, "on"},
    // German
    RoleWords{opening,
              "siebweite siebweiten maschenweite maschenweiten siebmaschenweite siebgroesse sieboeffnung "
              "sieboeffnungen oeffnungsweite nennoeffnungsweite lochweite"},
    RoleWords{diameter, "korngroesse korngroessen korndurchmesser partikelgroesse partikeldurchmesser "
                        "durchmesser kornfraktion "
                        "kornfraktionen kornklasse kornklassen korngruppe korngruppen"},
    RoleWords{extent, "groesse"},
    RoleWords{sieve, "sieb siebe siebs pruefsieb analysensieb"},
    RoleWords{number, "nr nummer"},
    RoleWords{standard, "lichte nominelle w"},
    RoleWords{retained, "rueckstand siebrueckstand rueckstaende rueckst"},
    RoleWords{retained | individual, "einzelrueckstand einzelrueckstaende teilrueckstand"},
    RoleWords{retained | cumulative, "rueckstandssumme summenrueckstand"},
    RoleWords{passing,
              "durchgang durchgaenge durchg durchgangswerte siebdurchgang siebdurchgaenge gesamtdurchgang "
              "durchgangssumme summendurchgang"},
    RoleWords{cumulative, "kumuliert kumulierter kumulierte kumulativ kum aufsummiert"},
    RoleWords{individual, "einzeln einzelner"},
    RoleWords{mass, "masse gewicht massenanteil"},
    RoleWords{material, "siebgut"},
    RoleWords{link, "der des die dem jedem"},
    RoleWords{place, "auf"},
    // French
    RoleWords{opening, "ouverture ouvertures maille mailles"},
    RoleWords{diameter, "diametre diametres"},
    RoleWords{extent, "dimension dimensions taille"},
    RoleWords{sieve, "tamis"},
    RoleWords{grain, "particules"},
    RoleWords{number, "n numero"},
    RoleWords{standard, "nominale"},
    RoleWords{retained, "retenu retenue retenus retenues"},
    RoleWords{refusal, "refus"},
    RoleWords{passing, "passant passants tamisat tamisats"},
    RoleWords{cumulative, "cumule cumules cumulee cumulees"},
    RoleWords{individual, "partiel partiels partielle partielles"},
    RoleWords{material, "poids materiau sol"},
    RoleWords{link, "de du la le les chaque"},
    RoleWords{place, "sur"},
    // Spanish
    RoleWords{opening, "abertura aberturas"},
    RoleWords{diameter, "diametro"},
    RoleWords{extent, "tamano luz"},
    RoleWords{sieve, "tamiz tamices"},
    RoleWords{mesh, "malla mallas"},
    RoleWords{grain, "particula particulas grano granos"},
    RoleWords{retained, "retenido retenida retenidos retenidas"},
    RoleWords{passing, "pasa pasante pasantes"},
    RoleWords{cumulative, "acumulado acumulada acumulados acumuladas"},
    RoleWords{individual, "parcial parciales"},
    RoleWords{material, "masa peso suelo que"},
    RoleWords{link, "del el los las cada"},
    RoleWords{place, "en"},
    // Italian; `aperture` and `diametro` are above
    RoleWords{opening, "apertura"},
    RoleWords{extent, "dimensione luce"},
    RoleWords{sieve, "setaccio setacci crivello crivelli"},
    RoleWords{mesh, "maglia maglie"},
    RoleWords{grain, "particelle grani"},
    RoleWords{retained, "trattenuto trattenuta trattenuti"},
    RoleWords{passing, "passante passanti"},
    RoleWords{cumulative, "cumulato cumulata cumulati cumulativo cumulativa"},
    RoleWords{individual, "parziale parziali"},
    RoleWords{material, "massa materiale"},
    RoleWords{link, "della delle dei di il ogni"},
    RoleWords{place, "sul"},
};

/// Names of more words that none of them tells, such as those of instruments.
struct Phrase {
  std::string_view words;
  ColumnMeaning meaning;
};
constexpr std::array phrases = {
    Phrase{"channel diameter lower", ColumnMeaning::size},
    Phrase{"volume in", ColumnMeaning::retained},
    Phrase{"differential volume", ColumnMeaning::retained},
    Phrase{"diff volume", ColumnMeaning::retained},
    Phrase{"p3", ColumnMeaning::retained},
    Phrase{"volume under", ColumnMeaning::passing},
    Phrase{"q3", ColumnMeaning::passing},
    Phrase{"summe rueckstand", ColumnMeaning::cumulative},
    Phrase{"summe der rueckstaende", ColumnMeaning::cumulative},
    Phrase{"summe der durchgaenge", ColumnMeaning::passing},
    Phrase{"summe der siebdurchgaenge", ColumnMeaning::passing},
};

using RolesOfWords = std::unordered_map<std::string_view, unsigned>;

RolesOfWords roles_of_vocabulary() {
  RolesOfWords roles;
  for (const RoleWords &r : vocabulary)
    for (const std::string_view word : listed_words(r.words))
      roles[word] |= r.roles;
  return roles;
}

/// The roles of a word; 0 where it is not known.
unsigned roles_of(std::string_view word) {
  static const RolesOfWords all = roles_of_vocabulary();
  const auto found = all.find(word);
  return found == all.end() ? 0 : found->second;
}

/// Takes `on each sieve` and the like away: it says where a mass is retained.
void drop_place(std::vector<std::string> &words) {
  const auto on =
      std::find_if(words.begin(), words.end(), [](const std::string &w) { return roles_of(w) == place; });
  if (on == words.end())
    return;
  const auto behind =
      std::find_if(on + 1, words.end(), [](const std::string &w) { return roles_of(w) != link; });
  if (behind != words.end() && roles_of(*behind) == sieve)
    words.erase(on, behind + 1);
}

/// Takes the formula of EN 933-1 away: `retained Ri/M1 x 100`, `passing 100 - (sum Ri/M1 x 100)`.
void drop_formula(std::vector<std::string> &words) {
  const auto drop = [&words](std::initializer_list<std::string_view> last) {
    if (words.size() <= last.size() || !std::equal(last.begin(), last.end(), words.end() - std::ssize(last)))
      return false;
    words.resize(words.size() - last.size());
    return true;
  };
  if (!drop({"m1", "x", "100"}) && !drop({"m1", "100"}))
    return;
  drop({"ri"});
  drop({"sum"});
  drop({"100"});
}

std::optional<ColumnMeaning> meaning_of_sizes(unsigned roles, bool has_length) {
  if ((roles & diameter) != 0)
    return (roles & (sieve | mesh | number | extent)) == 0 ? std::optional(ColumnMeaning::size)
                                                           : std::nullopt;
  const bool is_opening =
      (roles & opening) != 0 || ((roles & extent) != 0 && (roles & (sieve | mesh | grain)) != 0);
  if ((roles & number) != 0)
    return (roles & (sieve | mesh)) != 0 && !has_length ? std::optional(ColumnMeaning::sieve) : std::nullopt;
  if (is_opening)
    return ColumnMeaning::size;
  if ((roles & sieve) != 0)
    return (roles & grain) == 0 ? std::optional(ColumnMeaning::sieve) : std::nullopt;
  return (roles & mesh) != 0 && has_length ? std::optional(ColumnMeaning::size) : std::nullopt;
}

std::optional<ColumnMeaning> meaning_of_values(unsigned roles) {
  const bool is_retained = (roles & (retained | refusal)) != 0;
  if ((roles & passing) != 0)
    return is_retained || (roles & individual) != 0 ? std::nullopt : std::optional(ColumnMeaning::passing);
  const bool is_cumulative = (roles & cumulative) != 0, is_individual = (roles & individual) != 0;
  if (!is_retained || (is_cumulative && is_individual))
    return std::nullopt;
  return is_cumulative ? ColumnMeaning::cumulative : ColumnMeaning::retained;
}

} // namespace column_roles
} // namespace

std::optional<WordsMeaning> meaning_of_words(std::vector<std::string> words, bool has_length) {
  using namespace column_roles;
  const std::string all = joined(words);
  const auto phrase =
      std::find_if(phrases.begin(), phrases.end(), [&all](const Phrase &p) { return p.words == all; });
  if (phrase != phrases.end())
    return WordsMeaning{phrase->meaning};
  if (words.size() == 1 && roles_of(words[0]) == mass)
    return WordsMeaning{ColumnMeaning::retained};
  drop_formula(words);
  drop_place(words);
  constexpr unsigned of_sizes = opening | diameter | extent | sieve | mesh | grain | number | standard;
  unsigned roles = 0;
  for (const std::string &word : words) {
    const unsigned of_word = roles_of(word);
    if (of_word == 0 || of_word == place)
      return std::nullopt;
    roles |= of_word;
  }
  const unsigned without_links = roles & ~static_cast<unsigned>(link);
  const std::optional<ColumnMeaning> meaning = (without_links & of_sizes) == without_links
                                                   ? meaning_of_sizes(roles, has_length)
                                               : (roles & of_sizes) == 0 ? meaning_of_values(roles)
                                                                         : std::nullopt;
  if (!meaning)
    return std::nullopt;
  const bool may_be_either = (roles & (refusal | whole)) != 0 && (roles & (cumulative | individual)) == 0;
  return WordsMeaning{*meaning, (roles & individual) != 0,
                      may_be_either && *meaning == ColumnMeaning::retained};
}

bool is_word_of_sums(std::string_view word) {
  return column_roles::roles_of(word) == column_roles::cumulative;
}

bool speaks_of_sums(std::string_view text) {
  const std::vector<std::string> words = words_of(text);
  return std::any_of(words.begin(), words.end(), is_word_of_sums);
}

} // namespace mdm
