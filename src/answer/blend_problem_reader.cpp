#include "answer/blend_problem_reader.hpp"

#include "answer/string_members.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

namespace mdm {
namespace {

using Json = nlohmann::json;

/// The members of mdm-blend-1 and the name of a problem; those of its answer are passed over.
constexpr std::array<std::string_view, 25> known_members = {
    "id",      "schema",     "specification", "status",  "unit",    "stockpiles",    "sieves",
    "moduli",  "coarseness", "steps",         "at_most", "aim",     "blends",        "all",
    "bound",   "splits",     "real",          "prices",  "rounded", "contradiction", "widened_real",
    "widened", "notes",      "versions",      "bailey"};

void check_members(const Json &object, const std::string &where, const auto &known) {
  if (!object.is_object())
    throw InputError(where + " is no object");
  for (const auto &[key, value] : object.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw InputError(fmt::format("{}{} is unknown: there are {}", where.empty() ? "" : where + ": ",
                                   in_quotes(key), fmt::join(known, ", ")));
}

Rational number_or(const Json &object, const char *key, const Rational &other, const std::string &where) {
  return has_member(object, key) ? stated_number(object[key], where + "." + key) : other;
}

const Json &array_member(const Json &object, const std::string &key) {
  const Json &value = member_of(object, key);
  if (!value.is_array())
    throw InputError(key + " is no array");
  return value;
}

BlendSieve sieve_of(const Json &stated, const std::string &where) {
  constexpr std::array<std::string_view, 4> known = {"size", "least", "most", "target"};
  check_members(stated, where, known);
  BlendSieve sieve;
  sieve.size = stated_number(member_of(stated, "size"), where + ".size");
  sieve.least = number_or(stated, "least", 0, where);
  sieve.most = number_or(stated, "most", 100, where);
  if (has_member(stated, "target"))
    sieve.target = stated_number(stated["target"], where + ".target");
  for (const Rational &percent : {sieve.least, sieve.most, sieve.target.value_or(0)})
    if (percent < 0 || percent > 100)
      throw InputError(where + ": a percent is below 0 or above 100");
  if (sieve.size <= 0)
    throw InputError(where + ".size is not above 0");
  if (sieve.least > sieve.most)
    throw InputError(where + ": least is above most: correct one of them");
  return sieve;
}

BlendSieve modulus_of(const Json &stated, const std::string &where) {
  constexpr std::array<std::string_view, 3> known = {"name", "least", "most"};
  check_members(stated, where, known);
  const std::string asked = text_member(stated, "name");
  const std::optional<FinenessModulus> modulus = fineness_modulus_named(asked);
  if (!modulus)
    throw InputError(fmt::format("{}.name is {}: write {} or {}", where, in_quotes(asked),
                                 name(FinenessModulus::astm), name(FinenessModulus::en)));
  BlendSieve sieve{};
  sieve.modulus = modulus;
  // The coarser, the less passes: limits change sides.
  if (has_member(stated, "most"))
    sieve.least =
        std::max(Rational(0), mean_of_modulus(*modulus, stated_number(stated["most"], where + ".most")));
  if (has_member(stated, "least"))
    sieve.most =
        std::min(Rational(100), mean_of_modulus(*modulus, stated_number(stated["least"], where + ".least")));
  return sieve;
}

/// The numbers of an array, in the order of the sieves.
std::vector<Rational> numbers(const Json &array, const std::string &where, std::size_t count,
                              const char *of) {
  if (array.size() != count)
    throw InputError(fmt::format("{} has {} numbers, and there are {} {}", where, array.size(), count, of));
  std::vector<Rational> all;
  for (std::size_t i = 0; i < count; ++i)
    all.push_back(stated_number(array[i], fmt::format("{}[{}]", where, i)));
  return all;
}

/// \param order  of the sieves as they were stated, ascending by size
Stockpile stockpile_of(const Json &stated, const std::string &where, const std::vector<std::size_t> &order,
                       const std::vector<BlendSieve> &moduli) {
  constexpr std::array<std::string_view, 7> known = {"name",  "passing", "moduli", "coarse",
                                                     "least", "most",    "cost"};
  check_members(stated, where, known);
  Stockpile s;
  s.name = text_member(stated, "name");
  const std::vector<Rational> passing =
      numbers(array_member(stated, "passing"), where + ".passing", order.size(), "sieves");
  for (const std::size_t at : order) {
    if (passing[at] < 0 || passing[at] > 100 || (!s.passing.empty() && passing[at] < s.passing.back()))
      throw InputError(where +
                       ".passing: a percent is below 0, above 100, or less than one of a finer sieve");
    s.passing.push_back(passing[at]);
  }
  if (!moduli.empty()) {
    const std::vector<Rational> values =
        numbers(array_member(stated, "moduli"), where + ".moduli", moduli.size(), "moduli");
    for (std::size_t i = 0; i < moduli.size(); ++i)
      s.passing.push_back(mean_of_modulus(*moduli[i].modulus, values[i]));
  }
  if (has_member(stated, "coarse") && !stated["coarse"].empty()) {
    const std::vector<Rational> coarse =
        numbers(array_member(stated, "coarse"), where + ".coarse", 2, "sieves, 9.5 mm and 2.36 mm");
    if (coarse[1] < 0 || coarse[0] < coarse[1] || coarse[0] > 100)
      throw InputError(where + ".coarse: a percent is below 0, above 100, or less than one of a finer sieve");
    s.coarse = CoarsePassing{coarse[0], coarse[1]};
  }
  s.least = number_or(stated, "least", 0, where);
  s.most = number_or(stated, "most", 1, where);
  s.cost = number_or(stated, "cost", 0, where);
  return s;
}

BlendAim aim_of(const std::string &text) {
  if (const std::optional<BlendAim> aim = blend_aim_named(text))
    return *aim;
  throw InputError("aim is " + in_quotes(text) + ": write none, cost, deviation, max-deviation or squares");
}

/// A cost that is not stated is none: it must not count as 0.
void check_costs(const Json &stockpiles) {
  for (std::size_t i = 0; i < stockpiles.size(); ++i)
    if (!has_member(stockpiles[i], "cost"))
      throw InputError(
          fmt::format("stockpiles[{}].cost is missing, and the aim is the least cost: add it", i));
}

void take_coarseness(const Json &stated, BlendProblem &problem) {
  constexpr std::array<std::string_view, 2> known = {"least", "most"};
  check_members(stated, "coarseness", known);
  const CoarsenessLimits limits{number_or(stated, "least", 0, "coarseness"),
                                number_or(stated, "most", 100, "coarseness")};
  if (limits.least < 0 || limits.most > 100 || limits.most < limits.least)
    throw InputError("coarseness: its limits are not in order from 0 to 100");
  for (std::size_t i = 0; i < problem.stockpiles.size(); ++i)
    if (!problem.stockpiles[i].coarse)
      throw InputError(fmt::format("stockpiles[{}].coarse is missing: it has what passes 9.5 mm and 2.36 mm, "
                                   "which the coarseness factor needs",
                                   i));
  limit_coarseness(problem, limits);
}

/// The sieves as they are stated, and their order by size.
std::vector<std::size_t> take_sieves(const Json &tree, BlendProblem &problem) {
  std::vector<BlendSieve> stated;
  for (const Json &sieve : array_member(tree, "sieves"))
    stated.push_back(sieve_of(sieve, fmt::format("sieves[{}]", stated.size())));
  std::vector<std::size_t> order(stated.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&stated](std::size_t a, std::size_t b) { return stated[a].size < stated[b].size; });
  for (const std::size_t at : order) {
    if (!problem.sieves.empty() && problem.sieves.back().size == stated[at].size)
      throw InputError("sieves: the size " + to_string(stated[at].size) + " is there twice");
    problem.sieves.push_back(stated[at]);
  }
  if (order.empty())
    throw InputError("sieves: there are none");
  return order;
}

} // namespace

Rational stated_number(const Json &value, const std::string &what) {
  if (!value.is_string())
    throw InputError(what + " is no number");
  const std::string &text = value.get_ref<const std::string &>();
  const std::size_t slash = text.find('/');
  try {
    if (slash == std::string::npos)
      return parse_decimal(text);
    const Rational over = parse_decimal(std::string_view(text).substr(slash + 1));
    if (over == 0)
      throw InputError(in_quotes(text) + " is divided by 0");
    return parse_decimal(std::string_view(text).substr(0, slash)) / over;
  } catch (const InputError &e) {
    throw InputError(what + ": " + e.what());
  }
}

std::string stated_blend_id(std::string_view json) {
  try {
    const Json tree = json_tree(json);
    return tree.is_object() && has_member(tree, "id") ? text_member(tree, "id") : std::string();
  } catch (const InputError &) { // what is no JSON has none
    return {};
  }
}

StatedBlendProblem read_blend_problem(std::string_view json) {
  const Json tree = json_tree(json);
  check_members(tree, "", known_members);
  StatedBlendProblem result;
  if (has_member(tree, "id"))
    result.id = text_member(tree, "id");
  for (const auto &[key, only] : {std::pair("unit", "mm"), std::pair("schema", "mdm-blend-1")})
    if (has_member(tree, key) && text_member(tree, key) != only)
      throw InputError(
          fmt::format("{} is {}: write {}, or leave it out", key, in_quotes(text_member(tree, key)), only));
  BlendProblem &problem = result.problem;
  const std::vector<std::size_t> order = take_sieves(tree, problem);
  std::vector<BlendSieve> moduli;
  if (has_member(tree, "moduli"))
    for (const Json &stated : array_member(tree, "moduli"))
      moduli.push_back(modulus_of(stated, fmt::format("moduli[{}]", moduli.size())));
  std::set<std::string> names;
  for (const Json &stated : array_member(tree, "stockpiles")) {
    const std::string where = fmt::format("stockpiles[{}]", problem.stockpiles.size());
    problem.stockpiles.push_back(stockpile_of(stated, where, order, moduli));
    if (!names.insert(problem.stockpiles.back().name).second)
      throw InputError(where + ".name: " + in_quotes(problem.stockpiles.back().name) + " is there twice");
  }
  problem.sieves.insert(problem.sieves.end(), moduli.begin(), moduli.end());
  if (has_member(tree, "coarseness"))
    take_coarseness(tree["coarseness"], problem);
  if (has_member(tree, "steps"))
    problem.steps = number_member(tree, "steps");
  if (has_member(tree, "at_most"))
    problem.at_most = number_member(tree, "at_most");
  if (has_member(tree, "aim"))
    problem.aim = aim_of(text_member(tree, "aim"));
  if (problem.aim == BlendAim::cost)
    check_costs(array_member(tree, "stockpiles"));
  return result;
}

} // namespace mdm
