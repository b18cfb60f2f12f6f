#include "sets/suite_description.hpp"

#include "gradation/sieve_series.hpp"
#include "sets/beta_curve.hpp"
#include "sets/suite_members.hpp"
#include "text/json_tree.hpp"
#include "text/source.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr std::uint32_t most_suite_classes = 1000;
constexpr std::uint32_t most_suite_digits = 100;
constexpr std::size_t longest_suite_id = 100;

/// The bounds of sizes, and of their power in ties, such that masses stay inside those of decimals.
constexpr unsigned most_tied_power = 9;
Rational least_opening() {
  return ratio(1, power_of_ten(30));
}
Rational largest_opening() {
  return Rational(power_of_ten(30));
}

void check_opening(const SuiteMembers &members, const Rational &opening) {
  if (opening < least_opening() || opening > largest_opening())
    members.refuse("list", "an opening is not from 1e-30 to 1e30: choose another unit");
}

/// Ascending, without what lies outside [from, to] where these are there.
ListedSieves listed_sieves(SuiteMembers members, SizeUnit unit) {
  ListedSieves sieves;
  if (members.has("list")) {
    const nlohmann::json &list = members.value("list");
    if (!list.is_array())
      members.refuse("list", "is no list: write [\"0.063\", \"0.125\", ...]");
    for (const nlohmann::json &opening : list)
      check_opening(members, sieves.openings.emplace_back(members.positive("list", opening)));
  } else {
    try {
      sieves.openings = sieve_series(members.text("series"));
    } catch (const InputError &e) {
      members.refuse("series", e.what());
    }
    for (Rational &opening : sieves.openings)
      opening /= in_mm(unit);
    const Rational from = members.has("from") ? members.positive("from") : sieves.openings.front();
    const Rational to = members.has("to") ? members.positive("to") : sieves.openings.back();
    std::erase_if(sieves.openings, [&](const Rational &opening) { return opening < from || opening > to; });
  }
  std::sort(sieves.openings.begin(), sieves.openings.end());
  if (std::adjacent_find(sieves.openings.begin(), sieves.openings.end()) != sieves.openings.end())
    members.refuse("list", "an opening is there twice: leave one");
  if (members.has("neighbours"))
    sieves.neighbours = members.boolean("neighbours");
  members.refuse_others();
  if (sieves.openings.size() < 2 || sieves.openings.size() > most_suite_classes + 1)
    throw InputError(
        fmt::format("sieves: {} of them: give from 2 to {}", sieves.openings.size(), most_suite_classes + 1));
  return sieves;
}

/// Refuses digits to which two sieves may become one: their ratio must be above 1 + 10^(1 - digits).
void check_apart(const GeometricSieves &sieves, std::uint32_t classes) {
  const Rational unit = Rational(1) + ratio(1, power_of_ten(sieves.digits - 1));
  const bool apart =
      sieves.ratio ? sieves.ratio->from > unit : sieves.to->from / sieves.from.to > power(unit, classes);
  if (!apart)
    throw InputError(
        fmt::format("sieves: two of them may be the same to {} digits: give more digits, or fewer "
                    "classes over a longer range",
                    sieves.digits));
  if (sieves.ratio && sieves.from.to * power(sieves.ratio->to, classes) > largest_opening())
    throw InputError("sieves: ratio: the largest may be beyond 1e30: give a smaller ratio, or fewer classes");
}

GeometricSieves geometric_sieves(SuiteMembers members) {
  constexpr int largest_ratio = 1000;
  GeometricSieves sieves{members.numbers("from", least_opening(), largest_opening()), {}, {}, 6};
  if (members.has("ratio"))
    sieves.ratio = members.numbers("ratio", 1, largest_ratio);
  else if (members.has("to"))
    sieves.to = members.numbers("to", least_opening(), largest_opening());
  else
    members.refuse("to", "is missing: give to, or ratio");
  if (members.has("digits"))
    sieves.digits = members.count("digits", 1, most_suite_digits);
  members.refuse_others();
  return sieves;
}

std::vector<std::string> words_of_kinds() {
  return {"random", "gap-graded", "beta", "lognormal", "normal", "ties"};
}

TiedMasses tied_masses(SuiteMembers &members) {
  constexpr std::uint32_t most_quantities = 1000000000;
  TiedMasses ties{TiedMasses::At::either, {1, 20}, 3};
  if (members.has("at"))
    ties.at = static_cast<TiedMasses::At>(members.word("at", {"upper", "lower", "either"}));
  if (members.has("quantities"))
    ties.quantities = members.counts("quantities", 1, most_quantities);
  if (members.has("law")) {
    const std::string text = members.text("law");
    try {
      const MassLaw law = parse_mass_law(text);
      if (!law.is_power())
        throw InputError(in_quotes(text) + " is no power: give sphere, or power:a with a whole a");
      if (law.b != 1)
        throw InputError(in_quotes(text) + " has irrational masses: give sphere, or power:a with a whole a");
      if (law.a > most_tied_power)
        throw InputError(fmt::format("{} is beyond x^{}", in_quotes(text), most_tied_power));
      ties.power = law.a;
    } catch (const InputError &e) {
      members.refuse("law", e.what());
    }
  }
  return ties;
}

/// The centre in the middle half of the sieves, as in the paper; below a deviation of a quarter of a class
/// none might have mass.
NormalMasses normal_masses(SuiteMembers &members) {
  const NumberRange middle_half{ratio(1, 4), ratio(3, 4)};
  return {members.has("centre") ? members.numbers("centre", 0, 1) : middle_half,
          members.numbers("deviation", ratio(1, 4), 1000),
          members.has("noise") ? members.numbers("noise", 0, 100) : NumberRange{0, 0}};
}

SuiteMasses masses_of(const nlohmann::json &object, std::uint32_t fewest_classes) {
  SuiteMembers members(object, "masses");
  const auto masses = [&]() -> SuiteMasses {
    switch (members.word("kind", words_of_kinds())) {
    case 0:
      return RandomMasses{};
    case 1: {
      if (fewest_classes < 3)
        members.refuse("kind", "a gap needs at least 3 classes");
      return GapMasses{members.has("empty") ? members.counts("empty", 1, fewest_classes - 2)
                                            : CountRange{1, 1}};
    }
    case 2:
      return BetaMasses{members.numbers("a", BetaCurve::least_parameter(), BetaCurve::largest_parameter()),
                        members.numbers("b", BetaCurve::least_parameter(), BetaCurve::largest_parameter())};
    case 3:
      return LognormalMasses{members.numbers("median", 0, 1),
                             members.numbers("deviation", ratio(1, 10), 100)};
    case 4:
      return normal_masses(members);
    default:
      return tied_masses(members);
    }
  }();
  members.refuse_others();
  return masses;
}

SizeUnit unit_of(SuiteMembers &members) {
  return members.has("unit") ? static_cast<SizeUnit>(members.word("unit", {"mm", "um", "m"})) : SizeUnit::mm;
}

std::string id_of(SuiteMembers &members) {
  if (!members.has("id"))
    return "g";
  const std::string id = members.text("id");
  if (id.empty() || id.size() > longest_suite_id)
    members.refuse("id", fmt::format("write 1 to {} characters", longest_suite_id));
  if (printable(id) != id)
    members.refuse("id", "it has characters that cannot be printed: leave them out");
  return id;
}

/// All sieves where the number of classes is not given.
CountRange classes_of(SuiteMembers &members, const ListedSieves *list) {
  const std::uint32_t most =
      list ? static_cast<std::uint32_t>(list->openings.size()) - 1 : most_suite_classes;
  if (members.has("classes") || !list)
    return members.counts("classes", 1, most);
  return {most, most};
}

SuiteDescription description_of(const nlohmann::json &root) {
  SuiteMembers members(root, "");
  members.word("schema", {"mdm-suite-1"});
  SuiteDescription d;
  d.id = id_of(members);
  d.unit = unit_of(members);
  SuiteMembers of_sieves(members.value("sieves"), "sieves");
  const bool is_list = of_sieves.has("list") || of_sieves.has("series");
  if (is_list)
    d.sieves = listed_sieves(of_sieves, d.unit);
  else
    d.sieves = geometric_sieves(of_sieves);
  d.classes = classes_of(members, std::get_if<ListedSieves>(&d.sieves));
  if (!is_list)
    check_apart(std::get<GeometricSieves>(d.sieves), d.classes.to);
  d.digits = members.has("digits") ? members.count("digits", 1, most_suite_digits) : 6;
  if (power_of_ten(d.digits) < d.classes.to)
    members.refuse("digits", fmt::format("{} are too few for {} classes: give more", d.digits, d.classes.to));
  const nlohmann::json &masses = members.value("masses");
  if (!masses.is_array())
    d.masses.push_back(masses_of(masses, d.classes.from));
  else
    for (const nlohmann::json &some : masses)
      d.masses.push_back(masses_of(some, d.classes.from));
  if (d.masses.empty())
    members.refuse("masses", "the list is empty: give at least one kind");
  members.refuse_others();
  return d;
}

} // namespace

SuiteDescription read_suite_description(std::string_view json, std::string_view file) {
  try {
    return description_of(json_tree(json));
  } catch (const JsonError &e) {
    Source(file).refuse(e.line, e.what());
  } catch (const InputError &e) {
    throw InputError(printable(file) + ": " + e.what());
  }
}

} // namespace mdm
