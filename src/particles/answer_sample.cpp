#include "../gradation/json_tree.hpp"
#include "../gradation/message.hpp"
#include "../gradation/text.hpp"

#include <mdm/number/common_denominator.hpp>
#include <mdm/number/interval.hpp>
#include <mdm/number/long_decimal.hpp>
#include <mdm/particles/answer_sample.hpp>
#include <mdm/particles/particle_format.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <tuple>

namespace mdm {
namespace {

using Json = nlohmann::json;

class AnswerReader {
public:
  AnswerReader(std::string_view content, const std::string &file) : file_(file) {
    content = without_byte_order_mark(content);
    const std::size_t first = std::min(content.find_first_not_of(" \t\r\n"), content.size());
    begin_line_ = line_number(content, first);
    if (!content.substr(first).starts_with('{'))
      Source(file_).refuse(begin_line_, "this is not one JSON object: give the JSON answer of mdm solve");
    try {
      answer_ = json_tree(content);
    } catch (const JsonError &error) {
      Source(file_).refuse(error.line, error.what());
    }
  }

  AnswerSample read() const {
    if (const std::string schema = text(answer_, "schema", ""); schema != "mdm-answer-1")
      refuse("schema", in_quotes(schema) + " is not 'mdm-answer-1': give the JSON answer of mdm solve");
    if (const std::string status = text(answer_, "status", ""); status != "optimal" && status != "feasible")
      refuse("status", in_quotes(status) + " means that there is no sample: solve again with other limits");
    AnswerSample sample;
    if (answer_.contains("id"))
      sample.id = text(answer_, "id", "");
    if (answer_.contains("question"))
      sample.question = text(answer_, "question", "");
    sample.unit = unit();
    sample.particles = natural(answer_, "particles", "");
    const Json &scale = member(answer_, "scale", "");
    sample.scale = fraction(scale, "chosen", "scale.");
    if (scale.contains("scale_power"))
      sample.scale_power = scale_power(scale);
    const Json &classes = member(answer_, "classes", "");
    if (!classes.is_array())
      refuse("classes", "is no array: give the JSON answer of mdm solve");
    const Json *const achieved = achieved_shares(classes.size());
    for (std::size_t j = 0; j < classes.size(); ++j)
      add_class(sample, classes[j], j, achieved);
    if (sample.classes.empty())
      refuse("classes", "have no particles: give an answer that has some");
    if (achieved != nullptr)
      sample.share_error = share_error(classes, *achieved);
    return sample;
  }

private:
  /// Names the line where the answer begins, mostly the only one: the key says where in it.
  [[noreturn]] void refuse(const std::string &key, const std::string &what) const {
    Source(file_).refuse(begin_line_, key + " " + what);
  }

  const Json &member(const Json &object, const char *key, const std::string &place) const {
    if (!object.is_object() || !object.contains(key))
      refuse(place + key, "is missing: give the JSON answer of mdm solve");
    return object[key];
  }

  const std::string &text(const Json &object, const char *key, const std::string &place) const {
    const Json &value = member(object, key, place);
    if (!value.is_string())
      refuse(place + key, "is no number and no text: give the JSON answer of mdm solve");
    return value.get_ref<const std::string &>();
  }

  static std::optional<Integer> digits(const std::string &text) {
    if (text.empty() || text.size() > max_long_decimal_digits ||
        text.find_first_not_of("0123456789") != std::string::npos)
      return std::nullopt;
    Integer n;
    mpz_set_str(n.backend().data(), text.c_str(), 10);
    return n;
  }

  Integer natural(const Json &object, const char *key, const std::string &place) const {
    const std::string &written = text(object, key, place);
    const std::optional<Integer> n = digits(written);
    if (!n)
      refuse(place + key, in_quotes(written) + " is not a whole number: give the JSON answer of mdm solve");
    return *n;
  }

  /// What a match within a tolerance has instead of the masses; null for an exact match.
  const Json *achieved_shares(std::size_t classes) const {
    if (!answer_.contains("achieved") || answer_["achieved"].is_null())
      return nullptr;
    const Json &shares = answer_["achieved"];
    if (!shares.is_array() || shares.size() != classes ||
        !std::all_of(shares.begin(), shares.end(), [](const Json &share) { return share.is_string(); }))
      refuse("achieved", "is not a string for each class: give the JSON answer of mdm solve");
    return &shares;
  }

  Rational share_error(const Json &classes, const Json &achieved) const {
    std::vector<Rational> masses, shares;
    for (std::size_t j = 0; j < classes.size(); ++j) {
      masses.push_back(decimal(classes[j], "mass", fmt::format("classes[{}].", j)));
      const std::string &share = achieved[j].get_ref<const std::string &>();
      shares.push_back(share == "0" ? Rational(0) : fraction(share, fmt::format("achieved[{}]", j)));
    }
    const Rational mass = sum(masses), all = sum(shares);
    Rational most = 0;
    for (std::size_t j = 0; j < masses.size(); ++j)
      most = std::max(most, abs(Rational(shares[j] / all - masses[j] / mass)));
    return most;
  }

  /// p/q > 0 or p > 0.
  Rational fraction(const Json &object, const char *key, const std::string &place) const {
    return fraction(text(object, key, place), place + key);
  }

  Rational fraction(const std::string &both, const std::string &place) const {
    const std::size_t slash = both.find('/');
    const std::optional<Integer> n = digits(both.substr(0, slash));
    const std::optional<Integer> d = slash == std::string::npos ? Integer(1) : digits(both.substr(slash + 1));
    if (!n || !d || *n == 0 || *d == 0)
      refuse(place, in_quotes(both) + " is no fraction p/q above 0: give the JSON answer of mdm solve");
    return ratio(*n, *d);
  }

  Rational decimal(const std::string &number, const std::string &place) const {
    try {
      return parse_long_decimal(number);
    } catch (const InputError &error) {
      refuse(place, error.what());
    }
  }

  Rational decimal(const Json &object, const char *key, const std::string &place) const {
    return decimal(text(object, key, place), place + key);
  }

  SizeUnit unit() const {
    const std::string &written = text(answer_, "unit", "");
    for (const SizeUnit unit : {SizeUnit::mm, SizeUnit::um, SizeUnit::m})
      if (written == name(unit))
        return unit;
    refuse("unit", in_quotes(written) + " is unknown: use mm, um or m");
  }

  unsigned scale_power(const Json &scale) const {
    const Integer b = natural(scale, "scale_power", "scale.");
    if (b < 1 || b > max_law_exponent)
      refuse("scale.scale_power", "is not from 1 to 1000: give the JSON answer of mdm solve");
    return b.convert_to<unsigned>();
  }

  void add_class(AnswerSample &sample, const Json &from, std::size_t j, const Json *achieved) const {
    const std::string place = fmt::format("classes[{}].", j);
    AnswerSample::Class c;
    c.number = j + 1;
    sample.has_spread = sample.has_spread || (from.is_object() && from.contains("sizes"));
    c.quantity = natural(from, "quantity", place);
    if (c.quantity == 0)
      return;
    c.lower = decimal(from, "lower", place);
    c.upper = decimal(from, "upper", place);
    c.mass = achieved != nullptr ? fraction((*achieved)[j].get_ref<const std::string &>(), place + "achieved")
                                 : decimal(from, "mass", place);
    if (c.mass <= 0)
      refuse(place + "mass", "is not above 0, but there are particles: give the JSON answer of mdm solve");
    std::tie(c.size_lo, c.size_hi) = enclosure(member(from, "size", place), place + "size");
    if (from.contains("sizes")) {
      const Json &sizes = from["sizes"];
      if (!sizes.is_array() || sizes.empty())
        refuse(place + "sizes", "is no list of sizes: give the JSON answer of mdm solve");
      for (const Json &size : sizes)
        c.sizes.push_back(enclosure(size, place + "sizes"));
    }
    sample.classes.push_back(std::move(c));
  }

  std::pair<Rational, Rational> enclosure(const Json &size, const std::string &place) const {
    if (!size.is_array() || size.size() != 2 || !size[0].is_string() || !size[1].is_string())
      refuse(place, "is not [lo, hi], two strings: give the JSON answer of mdm solve");
    std::pair<Rational, Rational> e{decimal(size[0].get_ref<const std::string &>(), place),
                                    decimal(size[1].get_ref<const std::string &>(), place)};
    if (e.first < 0 || e.second < e.first)
      refuse(place, "is not 0 <= lo <= hi: give the JSON answer of mdm solve");
    return e;
  }

  const std::string &file_;
  std::size_t begin_line_ = 1;
  Json answer_;
};

/// The factor of the class of g between the two bounds.
Rational factor(const Gradation &g, const Rational &lower, const Rational &upper) {
  if (!g.has_factors())
    return 1;
  for (std::size_t j = 0; j < g.classes(); ++j)
    if (g.lower(j) == lower && g.upper(j) == upper)
      return g.factor(j);
  throw InputError(fmt::format("the answer's class ({}, {}] is none of the gradation, whose classes have "
                               "factors: give the gradation that was solved",
                               shown(lower), shown(upper)));
}

/// What is wrong with a class's spread; nothing if its sizes are one a particle, in the class, and around its
/// mass (Theorem 16 (d)). \param powered x^a of a particle if all had one size
std::string spread_objection(const AnswerSample::Class &c, const MassLaw &law, const Rational &powered) {
  constexpr unsigned bits = 128;
  const auto mass = [&](const Rational &x) { return root(x, law.b, bits); };
  if (c.quantity != c.sizes.size())
    return fmt::format("{} sizes are listed for its {} particles", c.sizes.size(), to_string(c.quantity));
  std::vector<Rational> low, high;
  for (const auto &[lo, hi] : c.sizes) {
    if (lo < c.lower || (lo == c.lower && lo == hi) || hi > c.upper)
      return "a size is not in it";
    low.push_back(mass(law.powered(lo)).lo);
    high.push_back(mass(law.powered(hi)).hi);
  }
  const Interval one = mass(powered);
  if (sum(low) > one.hi * c.quantity || sum(high) < one.lo * c.quantity)
    return "its sizes do not have its mass together";
  return "";
}

/// \throws InputError if g has an opening inside a class of the answer that is spread
void check_classes(const Gradation &g, const Rational &lower, const Rational &upper) {
  for (const Rational &x : g.sizes())
    if (lower < x && x < upper)
      throw InputError(
          fmt::format("the answer is a spread over ({}, {}], and the gradation has a sieve of {} "
                      "there: give the gradation that was solved",
                      shown(lower), shown(upper), shown(x)));
}

} // namespace

AnswerSample read_answer(std::string_view content, const std::string &file) {
  return AnswerReader(content, file).read();
}

AnswerDescription describe_answer(const AnswerSample &answer, Gradation g, const MassLaw &law,
                                  const Rational &snap) {
  if (answer.scale_power != law.b)
    throw InputError(fmt::format("the answer was made with a law x^(a/{}), not x^({}): say which with --law",
                                 answer.scale_power, law.exponent()));
  const Rational unit = in_mm(length_unit(answer.unit)) / in_mm(length_unit(g.unit()));
  const Rational scale = answer.scale * power(unit, law.a); // with sizes in the unit of g
  AnswerDescription result{Description(std::move(g), {law, snap, scale}), {}, {}};
  Integer particles = 0;
  std::vector<std::size_t> wrong; // classes whose size is not in its enclosure
  for (const AnswerSample::Class &c : answer.classes) {
    const Rational mass =
        c.mass / (factor(result.description.gradation(), c.lower * unit, c.upper * unit) * c.quantity);
    const Rational powered = scale * power(mass, law.b); // x^a
    if (powered < power(Rational(c.size_lo * unit), law.a) ||
        powered > power(Rational(c.size_hi * unit), law.a))
      wrong.push_back(c.number);
    if (!c.sizes.empty()) {
      check_classes(result.description.gradation(), c.lower * unit, c.upper * unit);
      const std::string objection = spread_objection(c, law, powered / power(unit, law.a));
      if (!objection.empty())
        result.objections.push_back(fmt::format("class {} of the answer: {}", c.number, objection));
    }
    result.description.add_powered(powered, c.quantity);
    particles += c.quantity;
  }
  if (!wrong.empty())
    result.objections.push_back(
        fmt::format("scale, mass and quantity do not give the size in class {}{} of the answer with the law "
                    "x^({})",
                    wrong.front(), wrong.size() > 1 ? fmt::format(" and {} more", wrong.size() - 1) : "",
                    law.exponent()));
  if (std::any_of(answer.classes.begin(), answer.classes.end(),
                  [](const auto &c) { return !c.sizes.empty(); }))
    result.notes.emplace_back("The answer is a spread: the particles of a class are judged by their mass "
                              "together, and condition 3 is that of particles of one size with this mass.");
  if (particles != answer.particles)
    result.notes.push_back(fmt::format("The answer says that it has {} particles; its classes have {}.",
                                       to_string(answer.particles), to_string(particles)));
  return result;
}

} // namespace mdm
