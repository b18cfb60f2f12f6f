#include "gradation/row_words.hpp"

#include "gradation/header_words.hpp"
#include "gradation/plain_words.hpp"
#include "text/lines.hpp"

#include <algorithm>
#include <unordered_set>
#include <vector>

namespace mdm {
namespace {
/// Short names, kept apart from those of other files.
namespace row_vocabulary {

// Words with spaces between them, in the spelling of plain_words.
constexpr std::string_view pan =
    "pan bottom schale bodenschale auffangschale siebboden blindboden boden fond fondo receiver "
    "auffanggefaess auffangboden pfanne siebpfanne raccoglitore bandeja charola cazoleta receptor fondello";
constexpr std::string_view washing =
    "auswaschverlust wash rinse rinsed rinsing ausgespuelt ausgespueltes spuelverlust decant washing washed "
    "washings washout waschen gewaschen waschverlust ausgewaschen "
    "ausgewaschenes "
    "auswaschung abschlaemmen abschlaemmbar abschlaemmbares abschlaemmbare abgeschlaemmt abgeschlaemmtes "
    "abschlaemmung schlaemmen schlaemmverlust schlaemmanteil decanted decantation elutriation elutriated "
    "lavage "
    "lave laves lavee lavees lavado lavados lavada lavadas lavaggio lavato lavati lavata lavate";
/// Words of washing that are of what went as well as of what stayed.
constexpr std::string_view washed =
    "washed gewaschen lave laves lavee lavees lavados lavada lavadas lavato lavati lavata lavate decanted "
    "elutriated";
/// Words beside washing of what may have stayed.
constexpr std::string_view stayed = "residue retained rest collected on over rueckstand";
/// Words beside washing that say that its number is what went.
constexpr std::string_view gone =
    "loss losses lost verlust spuelverlust ausgespuelt ausgespueltes waschverlust auswaschverlust eliminees "
    "elimines eliminado eliminados eliminada "
    "eliminati eliminate rimossi asportati schlaemmverlust schlaemmanteil ausgewaschen ausgewaschenes "
    "auswaschung abschlaemmbar abschlaemmbares abschlaemmbare abgeschlaemmt abgeschlaemmtes abschlaemmung "
    "away perte "
    "pertes perdida perdidas perdita perdite removed out fines fine finer finos fins fini feinanteil through "
    "passing silt clay schluff ton finer washout washings elements bestandteile";
constexpr std::string_view loss =
    "loss losses lost verlust siebverlust perte pertes perdida perdidas perdita "
    "perdite";
constexpr std::string_view total = "total totals sum summe gesamt gesamtmasse gesamtsumme somme suma totale "
                                   "somma totales sumatoria";
constexpr std::string_view initial =
    "initial original starting anfangsmasse ausgangsmasse einwaage gesamteinwaage initiale inicial iniziale";
constexpr std::string_view before = "before vor avant antes prima";
constexpr std::string_view after = "after nach apres despues dopo";
constexpr std::string_view dry = "dry dried oven ovendry trocken trockene trockenmasse trockengewicht "
                                 "trockenprobe seche sec seca seco secca secco essiccato";
constexpr std::string_view mass = "mass masses weight weights massen masses masas pesos masse gewicht masa "
                                  "peso massa poids trockenmasse trockengewicht "
                                  "probenmasse probengewicht wt";
constexpr std::string_view sample =
    "sample specimen soil material probe probenmasse probengewicht trockenprobe "
    "echantillon sol muestra suelo campione terreno materiale materiaux";
constexpr std::string_view sieving =
    "sieving sieved sieve siebung sieben tamisage tamizado setacciatura vagliatura";
constexpr std::string_view passing =
    "passing passes passed minus finer smaller less below under kleiner unter durchgang siebdurchgang "
    "passant passants "
    "pasa "
    "pasante passante tamisat inferieur inferieure inferior menor inferiore minore undersize";
constexpr std::string_view container =
    "container dish tin tare tara beaker bowl can tray recipient recipiente "
    "behaelter gefaess contenitore capsule capsula";
constexpr std::string_view moist =
    "moist wet damp feucht feuchte feuchtmasse nass humide humeda humedo umida umido bulk";
constexpr std::string_view splitting =
    "multiplied multiply multipliziert halved halbiert split splits splitting aliquot aliquots aliquota "
    "aliquote quarter "
    "quarters tenth subsample subsamples "
    "subsampled riffle riffled riffling riffler quartered "
    "quartering "
    "reduced reduction geviertelt viertelung teilprobe teilproben probenteilung probeteilung geteilt "
    "riffelteiler quartage quarte scaling feinsiebung prelevement preleve prelevee "
    "reduit reduite reduits cuarteo cuarteado cuarteada submuestra reducida reducido quartatura "
    "sottocampione "
    "ridotto ridotta";
constexpr std::string_view joining = "and und et y e plus with mit con avec";
constexpr std::string_view factor =
    "factor faktor umrechnungsfaktor facteur fattore coefficient koeffizient coeff multiplier multiplikator";
constexpr std::string_view beside_factor = "correction korrektur conversion scale f k x of the";
/// Words of what tells samples apart, and those that may stand beside them.
constexpr std::string_view telling =
    "sample samples specimen specimens probe proben borehole boring bohrung bore hole bh sondage station "
    "site "
    "location depth tiefe profondeur profondita echantillon muestra campione run layer schicht couche capa "
    "strato";
constexpr std::string_view beside_telling = "id no nr number name code ref label lab test m ft of from to ";
/// Words that change nothing.
constexpr std::string_view filler =
    "the of in on to by a at an and und et y e con mit plus than as als used taken is from im der die das "
    "des dem "
    "de du da la le les l al au aux par por per del della nel nello nella en que collected residue retained "
    "rest restant rueckstand materiau material materials matter p m g gr gram grams kg lbs percent mm um u "
    "inch no nr n sieve sieb siebs "
    "tamis "
    "tamiz malla setaccio vaglio mesh test us through over ";

std::unordered_set<std::string_view> all_known_words() {
  std::unordered_set<std::string_view> known;
  for (const std::string_view list : {pan, washing, gone, loss, total, initial, before, after, dry, mass,
                                      sample, sieving, passing, container, moist, filler})
    for (const std::string_view word : listed_words(list))
      known.insert(word);
  return known;
}

class Words {
public:
  explicit Words(std::string_view text) : all_(words_of(text)) {}
  bool empty() const { return all_.empty(); }
  bool have(std::string_view list) const { return has_any_word(list, all_); }
  /// True where each word is known or has a digit.
  bool are_known() const {
    return std::all_of(all_.begin(), all_.end(), [](const std::string &word) {
      static const std::unordered_set<std::string_view> known = all_known_words();
      return has_digit(word) || known.contains(word) || word.size() <= 2; // a symbol
    });
  }
  bool have_two(std::string_view first, std::string_view second) const {
    return has_two_words(first, second, all_);
  }

  /// `100 g of 400 g`.
  bool have_part_of_mass() const {
    const auto is_mass = [this](std::size_t i) {
      return i + 1 < all_.size() && is_digit(all_[i].front()) && has_word("g gr gram grams kg", all_[i + 1]);
    };
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (is_mass(i) && ((is_mass(i + 3) && has_word("of from von aus de sur di su", all_[i + 2])) ||
                         (is_mass(i + 4) && all_[i + 2] == "out" && all_[i + 3] == "of")))
        return true;
    return false;
  }

  /// `Fine fraction sieved`, `10 % of minus 1 mm tested`, `Sample for fine sieving`.
  bool have_part_sieved() const {
    return have("fraction fractions fraccion portion minus fine fines finos fins") &&
           have("sieved sieving tested taken representative ensayada ensayado essayee tamisee");
  }
  /// `Fine factor`, `Ratio total/sieved`, `Factor = 8`, `Correction factor: 5.8`.
  bool have_factor_of_part() const {
    const auto is_beside = [](const std::string &word) {
      return has_word(factor, word) || has_word(beside_factor, word) || is_digit(word.front());
    };
    const bool has_number =
        std::any_of(all_.begin(), all_.end(), [](const std::string &word) { return is_digit(word.front()); });
    if (has_number && have(factor) && std::all_of(all_.begin(), all_.end(), is_beside))
      return true;
    return (have(factor) || have("ratio multiplier")) &&
           have("fine fines sieved fein fins finos portion fraction corrected");
  }

private:
  std::vector<std::string> all_;
};

bool is_letter(char c) {
  return lower(c) >= 'a' && lower(c) <= 'z';
}

/// The number of a sieve that stands in the text with what belongs to it: `No. 200`, `#200`, `0,063 mm`.
std::string named_sieve(std::string_view text) {
  std::size_t digit = std::string_view::npos;
  for (std::size_t i = 0; i < text.size() && digit == std::string_view::npos; ++i)
    if (is_digit(text[i]) && (i == 0 || !is_letter(text[i - 1]) || lower(text[i - 1]) == 'o'))
      digit = i;
  if (digit == std::string_view::npos)
    return {};
  std::size_t end = std::min(text.find_first_not_of("0123456789.,/-", digit), text.size());
  while (end > digit && (text[end - 1] == '.' || text[end - 1] == ',' || text[end - 1] == '-'))
    --end;
  std::string sieve(text.substr(digit, end - digit));
  const std::size_t before_digit = text.substr(0, digit).find_last_not_of(" .") + 1;
  const std::string_view up_to_digit = text.substr(0, before_digit);
  const std::string ahead = plain_words(up_to_digit);
  if (before_digit > 0 && text[before_digit - 1] == '#')
    return "#" + sieve;
  const bool has_degree = up_to_digit.ends_with("\u00B0") || up_to_digit.ends_with("\u00BA"); // `N°200`
  if (ahead == "no" || ahead == "nr" || ahead.ends_with(" no") || ahead.ends_with(" nr") ||
      (has_degree && (ahead == "n" || ahead.ends_with(" n"))))
    return "No. " + sieve;
  std::size_t unit = std::min(text.find_first_not_of(' ', end), text.size());
  if (text.substr(unit).starts_with('"'))
    return sieve + "\"";
  const std::size_t last = std::min(text.find_first_of(" ,;:()[]", unit), text.size());
  const std::string_view word = text.substr(unit, last - unit);
  return is_of_sizes(unit_of_words(word)) ? sieve + " " + std::string(word) : sieve;
}

std::string_view from_last_number(std::string_view text) {
  const std::size_t last = text.find_last_of("0123456789");
  if (last == std::string_view::npos)
    return {};
  const std::size_t behind_words = text.find_last_not_of("0123456789.,/", last);
  return behind_words == std::string_view::npos ? text : text.substr(behind_words + 1);
}

/// True for `< 0.063`, `-#200` and `- No. 200`.
bool has_sign_of_passing(std::string_view text) {
  if (text.find('<') != std::string_view::npos || text.find("\u2264") != std::string_view::npos)
    return true;
  for (const std::string_view minus : {"-", "\u2212", "\u2013"})
    if (text.starts_with(minus)) {
      const std::string_view rest = trimmed(text.substr(minus.size()));
      return rest.starts_with('#') || plain_words(rest).starts_with("no ");
    }
  return false;
}

/// `1/4 of what passes was sieved`; `1/4 in` is a sieve.
bool has_fraction_of(std::string_view text) {
  for (std::size_t at = text.find("1/"); at != std::string_view::npos; at = text.find("1/", at + 1)) {
    const std::size_t first = at + 2;
    const std::size_t end = std::min(text.find_first_not_of("0123456789", first), text.size());
    const std::vector<std::string> behind = words_of(text.substr(end));
    if (end > first && (at == 0 || !is_digit(text[at - 1])) && !behind.empty() &&
        has_word("of der des vom von du de del della", behind.front()))
      return true;
  }
  return false;
}

/// What is weighed in a container, or that alone.
RowMeaning of_container(const Words &words) {
  if (words.have(pan) || words.have(moist))
    return RowMeaning::none;
  const bool washes = words.have(washing) && !words.have(before);
  if ((words.have(after) && !washes) || (washes && words.have(gone)))
    return RowMeaning::none;
  if (words.have(dry) || words.have("sample soil material"))
    return washes ? RowMeaning::washed_with_container : RowMeaning::with_container;
  const bool is_name = words.have("no nr n") && !words.have(mass);
  return washes || is_name ? RowMeaning::none : RowMeaning::container;
}

RowMeaning meaning_of(const Words &words, bool passes) {
  const bool washes = words.have(washing), dries = words.have(dry), weighs = words.have(mass);
  if (words.have(container))
    return of_container(words);
  if (words.have(after))
    return washes ? RowMeaning::washed_mass : words.have(sieving) ? RowMeaning::total : RowMeaning::none;
  if (words.have(before))
    return washes                ? RowMeaning::initial_mass
           : words.have(sieving) ? RowMeaning::sieved_mass
                                 : RowMeaning::none;
  if (words.have(pan) && words.have(sample) && words.have(joining))
    return RowMeaning::none; // the pan is weighed with what is in it
  if (words.have(pan) && (washes || !dries))
    return washes ? RowMeaning::pan_and_wash : RowMeaning::pan;
  if (washes) {
    const bool is_unclear = weighs || words.have(washed) || words.have(stayed) || words.have(sample) ||
                            words.have(total) || words.have(sieving);
    return words.have(gone) ? RowMeaning::wash_loss
           : dries          ? RowMeaning::washed_mass
           : is_unclear     ? RowMeaning::none
                            : RowMeaning::wash_loss;
  }
  if (words.have(moist))
    return passes || words.have(passing) || words.have(gone) || words.have(loss) || words.have(sieving)
               ? RowMeaning::none
               : RowMeaning::moist_mass;
  if (passes || words.have(passing))
    return RowMeaning::passing;
  if (words.have(loss))
    return words.have(total) ? RowMeaning::none : RowMeaning::sieve_loss;
  if (words.have(initial) || (weighs && (dries || words.have(sample))))
    return RowMeaning::initial_mass;
  return words.have(total) ? RowMeaning::total : RowMeaning::none;
}

} // namespace row_vocabulary
} // namespace

RowWords row_words(std::string_view label) {
  using namespace row_vocabulary;
  const Words words(label);
  if (words.empty() || !words.are_known())
    return {};
  // `Passing 2 mm, retained 1 mm` is a size class.
  if (words.have(passing) && words.have("retained") &&
      named_sieve(label) != named_sieve(from_last_number(label)))
    return {};
  const bool passes = has_sign_of_passing(label);
  RowWords row{meaning_of(words, passes), named_sieve(label)};
  const bool needs_sieve = row.meaning == RowMeaning::passing,
             has_none = row.meaning == RowMeaning::moist_mass;
  if ((needs_sieve && row.sieve.empty()) || (has_none && !row.sieve.empty()))
    row.meaning = RowMeaning::none;
  return row;
}

bool speaks_of_washing(std::string_view text) {
  const std::string plain = plain_words(text);
  for (const std::string_view stem :
       {"wash", "wasch", "schlaemm", "lavag", "lavad", "lavat", "decant", "nasssieb", "nassabtrenn", "rins",
        "spuel", "elutriat", "slime", "wet siev", "voie humide", "via humeda", "via umida"})
    if (plain.find(stem) != std::string::npos)
      return true;
  return false;
}

bool speaks_of_splitting(std::string_view text) {
  using namespace row_vocabulary;
  const Words words(text);
  return words.have("scalped scalping") ||
         words.have_two("removed discarded excluded entfernt", "before prior vor") ||
         (words.have(splitting) && !words.have_two("split", "spoon barrel tube") &&
          !words.have_two("reduced", "level")) ||
         words.have_two("sub", "sample samples") || words.have_part_of_mass() || words.have_part_sieved() ||
         words.have_factor_of_part() || has_fraction_of(text) ||
         (words.have("portion prise") && (words.have(passing) || has_sign_of_passing(text)));
}

bool joins_parts(std::string_view label) {
  using namespace row_vocabulary;
  const Words words(label);
  return label.find_first_of("+&") != std::string_view::npos || words.have(joining) ||
         words.have("incl including total");
}

bool speaks_of_part(std::string_view text) {
  using namespace row_vocabulary;
  return Words(text).have(
             "fraction fractions fraccion frazione part portion fines fine fein feinanteil feinanteils "
             "finos fins") ||
         Words(text).have(passing) || has_sign_of_passing(text);
}

bool speaks_of_sample(std::string_view text) {
  return row_vocabulary::Words(text).have(row_vocabulary::sample);
}

bool names_samples(std::string_view header) {
  using namespace row_vocabulary;
  const std::vector<std::string> words = words_of(header);
  return Words(header).have(telling) && std::all_of(words.begin(), words.end(), [](const std::string &word) {
           return has_word(telling, word) || has_word(beside_telling, word);
         });
}

bool may_be_remark(std::string_view label) {
  using namespace row_vocabulary;
  const Words words(label);
  return !words.have(pan) || words.have("bottom boden fond fondo") || words.have(washing);
}

bool may_be_fines(std::string_view text) {
  return row_vocabulary::Words(text).have("rest remainder residue fines dust staub poussiere polvo polvere "
                                          "p200 p075 p063 filler unterkorn durchgang feinanteil feinanteile "
                                          "feinanteilen feinanteils feinteil feinteile feinteilen feinkorn "
                                          "fein schluff ton silt clay finos fins reste resto restos mud "
                                          "colloid colloids feinstes schlamm lama vase slib suspension");
}

bool speaks_of_retaining(std::string_view text) {
  return row_vocabulary::Words(text).have("retained retaining oversize rueckstand siebrueckstand ueberkorn "
                                          "refus retenu retenida retenido trattenuto trattenuta");
}

bool speaks_of_moisture_or_container(std::string_view text) {
  using namespace row_vocabulary;
  return Words(text).have(moist) || Words(text).have(container) ||
         Words(text).have("water wasser eau agua acqua");
}

bool names_washed_part(std::string_view text) {
  using namespace row_vocabulary;
  const Words words(text);
  return words.have(washing) && (words.have(sample) || words.have(stayed) || words.have(total));
}

bool speaks_of_mass(std::string_view text) {
  using namespace row_vocabulary;
  return Words(text).have(mass) || Words(text).have("g gr gram grams kg");
}

} // namespace mdm
