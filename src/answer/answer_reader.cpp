#include "answer/answer_reader.hpp"

#include "gradation/step_curve.hpp"
#include "number/common_denominator.hpp"
#include "number/long_decimal.hpp"
#include "particles/sample_sieves.hpp"
#include "text/json_tree.hpp"
#include "text/lines.hpp"
#include "text/source.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <tuple>

namespace mdm {
namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string &key, const std::string &what) {
  throw InputError(key + " " + what);
}

const Json &member(const Json &object, const char *key, const std::string &place) {
  if (!object.is_object() || !object.contains(key))
    refuse(place + key, "is missing: give the JSON answer of mdm solve");
  return object[key];
}

const std::string &text(const Json &object, const char *key, const std::string &place) {
  const Json &value = member(object, key, place);
  if (!value.is_string())
    refuse(place + key, "is no number and no text: give the JSON answer of mdm solve");
  return value.get_ref<const std::string &>();
}

std::optional<Integer> digits(const std::string &text) {
  if (text.empty() || text.size() > max_long_decimal_digits ||
      text.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  Integer n;
  mpz_set_str(n.backend().data(), text.c_str(), 10);
  return n;
}

Integer natural(const Json &object, const char *key, const std::string &place) {
  const std::string &written = text(object, key, place);
  const std::optional<Integer> n = digits(written);
  if (!n)
    refuse(place + key, in_quotes(written) + " is not a whole number: give the JSON answer of mdm solve");
  return *n;
}

Rational fraction(const std::string &both, const std::string &place) {
  const std::size_t slash = both.find('/');
  const std::optional<Integer> n = digits(both.substr(0, slash));
  const std::optional<Integer> d = slash == std::string::npos ? Integer(1) : digits(both.substr(slash + 1));
  if (!n || !d || *n == 0 || *d == 0)
    refuse(place, in_quotes(both) + " is no fraction p/q above 0: give the JSON answer of mdm solve");
  return ratio(*n, *d);
}

/// p/q > 0 or p > 0.
Rational fraction(const Json &object, const char *key, const std::string &place) {
  return fraction(text(object, key, place), place + key);
}

Rational decimal(const std::string &number, const std::string &place) {
  try {
    return parse_long_decimal(number);
  } catch (const InputError &error) {
    refuse(place, error.what());
  }
}

Rational decimal(const Json &object, const char *key, const std::string &place) {
  return decimal(text(object, key, place), place + key);
}

unsigned exponent(const Json &object, const char *key, const std::string &place, unsigned most) {
  const Integer n = natural(object, key, place);
  if (n < 1 || n > most)
    refuse(place + key, fmt::format("is not from 1 to {}: give the JSON answer of mdm solve", most));
  return n.convert_to<unsigned>();
}

std::pair<Rational, Rational> enclosure(const Json &size, const std::string &place) {
  if (!size.is_array() || size.size() != 2 || !size[0].is_string() || !size[1].is_string())
    refuse(place, "is not [lo, hi], two strings: give the JSON answer of mdm solve");
  std::pair<Rational, Rational> e{decimal(size[0].get_ref<const std::string &>(), place),
                                  decimal(size[1].get_ref<const std::string &>(), place)};
  if (e.first < 0 || e.second < e.first)
    refuse(place, "is not 0 <= lo <= hi: give the JSON answer of mdm solve");
  return e;
}

/// What is wrong with a class's material where one answer has but one.
constexpr const char *several_materials =
    "is of a gradation of several materials: mdm verify takes its answer with the gradation, here give the "
    "answer to a gradation of one";

std::string class_place(std::size_t j) {
  return fmt::format("classes[{}].", j);
}

AnswerSample of_one_material(AnswerSample sample) {
  for (const AnswerSample::Class &c : sample.classes)
    if (!c.material.empty())
      refuse(class_place(c.number - 1) + "material", several_materials);
  return sample;
}

Gradation curve_of_spread(const AnswerSample &spread) {
  SampleSieves sieves;
  for (const AnswerSample::Class &c : spread.classes)
    for (const auto &[lo, hi] : c.sizes)
      sieves.add(SizeRange{lo, hi}, 1);
  return sieves.gradation(spread.id, spread.unit, {}, SampleClasses::at_sizes);
}

} // namespace

const Json &AnswerReader::array(const char *key) const {
  const Json &value = member(answer_, key, "");
  if (!value.is_array())
    refuse(key, "is no array: give the JSON answer of mdm solve");
  return value;
}

/// The shares that a match within a tolerance has instead of the masses; null for an exact match.
const Json *AnswerReader::achieved_shares(std::size_t classes) const {
  if (!answer_.contains("achieved") || answer_["achieved"].is_null())
    return nullptr;
  const Json &shares = answer_["achieved"];
  if (!shares.is_array() || shares.size() != classes ||
      !std::all_of(shares.begin(), shares.end(), [](const Json &share) { return share.is_string(); }))
    refuse("achieved", "is not a string for each class: give the JSON answer of mdm solve");
  return &shares;
}

ShareErrors AnswerReader::errors_of(const Json &classes, const Json &achieved) const {
  std::vector<Rational> masses, shares;
  for (std::size_t j = 0; j < classes.size(); ++j) {
    masses.push_back(decimal(classes[j], "mass", class_place(j)));
    const std::string &share = achieved[j].get_ref<const std::string &>();
    shares.push_back(share == "0" ? Rational(0) : fraction(share, fmt::format("achieved[{}]", j)));
  }
  const Rational mass = sum(masses), all = sum(shares);
  for (std::size_t j = 0; j < masses.size(); ++j) {
    masses[j] /= mass;
    shares[j] /= all;
  }
  return share_errors(masses, shares);
}

SizeUnit AnswerReader::unit() const {
  const std::string &written = text(answer_, "unit", "");
  for (const SizeUnit unit : {SizeUnit::mm, SizeUnit::um, SizeUnit::m})
    if (written == name(unit))
      return unit;
  refuse("unit", in_quotes(written) + " is unknown: use mm, um or m");
}

/// A bound of a class, exactly, and a decimal that names it.
RootSize AnswerReader::opening(const Json &from, const char *key, const char *power_key,
                               const std::string &place) const {
  const Rational shown = decimal(from, key, place);
  if (size_power_ == 1)
    return {shown, 1};
  const std::string &power = text(from, power_key, place);
  const RootSize x{power == "0" ? Rational(0) : fraction(power, place + power_key), size_power_};
  if (!x.is_named_by(shown))
    refuse(place + key, fmt::format("is not the root of {}: give the JSON answer of mdm solve", power_key));
  return x;
}

void AnswerReader::add_class(AnswerSample &sample, const Json &from, std::size_t j,
                             const Json *achieved) const {
  const std::string place = class_place(j);
  AnswerSample::Class c;
  c.number = j + 1;
  sample.has_spread = sample.has_spread || (from.is_object() && from.contains("sizes"));
  c.quantity = natural(from, "quantity", place);
  if (c.quantity == 0)
    return;
  if (from.contains("material"))
    c.material = text(from, "material", place);
  c.lower = opening(from, "lower", "lower_power", place);
  c.upper = opening(from, "upper", "upper_power", place);
  c.mass = achieved != nullptr ? fraction((*achieved)[j].get_ref<const std::string &>(), place + "achieved")
                               : decimal(from, "mass", place);
  if (c.mass <= 0)
    refuse(place + "mass", "is not above 0, but there are particles: give the JSON answer of mdm solve");
  std::tie(c.size_lo, c.size_hi) = enclosure(member(from, "size", place), place + "size");
  if (compare(RootSize{c.size_hi}, c.lower) <= 0 || compare(RootSize{c.size_lo}, c.upper) > 0)
    refuse(place + "size",
           "is not in the class, above lower and up to upper: give the JSON answer of mdm solve");
  if (from.contains("sizes")) {
    const Json &sizes = from["sizes"];
    if (!sizes.is_array() || sizes.empty())
      refuse(place + "sizes", "is no list of sizes: give the JSON answer of mdm solve");
    for (const Json &size : sizes)
      c.sizes.push_back(enclosure(size, place + "sizes"));
  }
  sample.classes.push_back(std::move(c));
}

AnswerSample AnswerReader::sample() {
  if (const std::string schema = text(answer_, "schema", ""); schema != answer_schema)
    refuse("schema", fmt::format("{} is not '{}': give the JSON answer of mdm solve", in_quotes(schema),
                                 answer_schema));
  if (const std::string status = text(answer_, "status", ""); status != "optimal" && status != "feasible")
    refuse("status", in_quotes(status) + " means that there is no sample: solve again with other limits");
  AnswerSample sample;
  if (answer_.contains("id"))
    sample.id = text(answer_, "id", "");
  if (answer_.contains("question"))
    sample.question = text(answer_, "question", "");
  if (answer_.contains("notes"))
    for (const Json &note : array("notes"))
      sample.notes.push_back(note.is_string() ? note.get<std::string>() : note.dump());
  sample.unit = unit();
  if (answer_.contains("size_power"))
    size_power_ = exponent(answer_, "size_power", "", max_root);
  sample.size_power = size_power_;
  sample.particles = natural(answer_, "particles", "");
  const Json &scale = member(answer_, "scale", "");
  sample.scale = fraction(scale, "chosen", "scale.");
  if (scale.contains("scale_power"))
    sample.scale_power = exponent(scale, "scale_power", "scale.", max_law_exponent * max_root);
  const Json &classes = array("classes");
  const Json *const achieved = achieved_shares(classes.size());
  for (std::size_t j = 0; j < classes.size(); ++j)
    add_class(sample, classes[j], j, achieved);
  if (sample.classes.empty())
    refuse("classes", "have no particles: give an answer that has some");
  if (achieved != nullptr)
    sample.errors = errors_of(classes, *achieved);
  return sample;
}

Gradation AnswerReader::gradation(PhiReading phi) {
  const AnswerSample of = of_one_material(sample());
  const Json &classes = array("classes");
  const Json *const achieved = achieved_shares(classes.size());
  Gradation::Data data;
  data.id = of.id;
  data.unit = of.unit;
  const bool is_rounded = size_power_ > 1 && phi == PhiReading::rounded;
  data.root = is_rounded ? 1 : size_power_;
  const auto bound = [&](std::size_t j, const char *key, const char *power_key) {
    const RootSize exact = opening(classes[j], key, power_key, class_place(j));
    return is_rounded ? decimal(classes[j], key, class_place(j)) : exact.power;
  };
  for (std::size_t j = 0; j < classes.size(); ++j) {
    const std::string place = class_place(j);
    const Rational lower = bound(j, "lower", "lower_power");
    if (j > 0 && lower != data.sizes.back())
      refuse(place + "lower",
             "is not the upper bound of the class before: give the JSON answer of mdm solve");
    if (j == 0)
      data.sizes.push_back(lower);
    data.sizes.push_back(bound(j, "upper", "upper_power"));
    const std::string share = achieved == nullptr ? "" : (*achieved)[j].get<std::string>();
    data.masses.push_back(achieved == nullptr ? decimal(classes[j], "mass", place)
                          : share == "0"      ? Rational(0)
                                              : fraction(share, fmt::format("achieved[{}]", j)));
    if (classes[0].contains("factor"))
      data.factors.push_back(decimal(classes[j], "factor", place));
    else if (classes[j].contains("factor"))
      refuse(place + "factor", "is of a class behind one without: give the JSON answer of mdm solve");
  }
  if (!data.factors.empty())
    data.factors.emplace_back(1);
  if (achieved != nullptr) { // fractions, of which a file of a gradation may have none
    const CommonDenominator integers(data.masses);
    data.masses.assign(integers.numerators.begin(), integers.numerators.end());
  }
  data.masses.push_back(0);
  data.notes.push_back(fmt::format("the gradation is that of the {} particles of an answer{}",
                                   to_string(of.particles),
                                   achieved == nullptr ? "" : ", with the shares that they have"));
  if (is_rounded)
    data.notes.emplace_back("Sizes of phi that is no integer were rounded to 15 significant digits in mm.");
  return Gradation(std::move(data));
}

Gradation AnswerReader::curve() {
  const AnswerSample of = of_one_material(sample());
  if (of.has_spread)
    return curve_of_spread(of);
  Gradation::Data data;
  data.id = of.id;
  data.unit = of.unit;
  data.sizes = {0};
  for (const AnswerSample::Class &c : of.classes)
    add_step(data, c.size_lo, c.size_hi, c.mass);
  data.masses.emplace_back(0);
  data.notes.push_back(
      fmt::format("the curve is that of the {} particles of an answer: it rises at their sizes",
                  to_string(of.particles)));
  return Gradation(std::move(data));
}

StatedParticles AnswerReader::particles() const {
  StatedParticles stated;
  const Json &classes = array("classes");
  for (std::size_t j = 0; j < classes.size(); ++j) {
    const std::string place = class_place(j);
    if (member(classes[j], "quantity", place).is_null())
      return {};
    if (classes[j].contains("material"))
      refuse(place + "material", several_materials);
    stated.classes.push_back({natural(classes[j], "quantity", place), {}, {}});
    if (classes[j].contains("lower") && classes[j].contains("upper"))
      stated.classes.back().bounds = {decimal(classes[j], "lower", place),
                                      decimal(classes[j], "upper", place)};
    const Json &size = member(classes[j], "size", place);
    if (!size.is_null())
      stated.classes.back().size = enclosure(size, place + "size");
  }
  stated.unit = unit();
  if (answer_.contains("particles") && !answer_.at("particles").is_null())
    stated.particles = natural(answer_, "particles", "");
  return stated;
}

namespace {

/// What `read` makes of the answer's reader; messages name the file and the line.
template <class Read>
auto read_with(std::string_view content, const std::string &file, Read read) {
  const Source source(file);
  content = without_byte_order_mark(content);
  const std::size_t first = std::min(content.find_first_not_of(" \t\r\n"), content.size());
  // Where the answer begins, mostly its only line: the key says where in it.
  const std::size_t line = line_number(content, first);
  if (!content.substr(first).starts_with('{'))
    source.refuse(line,
                  "this is neither the JSON answer of mdm solve nor a file of particles: give one of them");
  try {
    const Json answer = json_tree(content);
    AnswerReader reader(answer);
    return read(reader);
  } catch (const JsonError &error) {
    const std::size_t end = content.find('\n', first);
    const std::size_t next = content.find_first_not_of(" \t\r\n", std::min(end, content.size()));
    if (next != std::string_view::npos && content[next] == '{')
      source.refuse(line + 1, "another answer begins here: give one of them");
    source.refuse(error.line, error.what());
  } catch (const InputError &error) {
    source.refuse(line, error.what());
  }
}

} // namespace

bool is_answer(std::string_view begin) {
  const std::string_view text = trimmed(without_byte_order_mark(begin));
  const std::size_t key = text.find("\"schema\"");
  return text.starts_with('{') && key != std::string_view::npos &&
         text.find(answer_schema, key) != std::string_view::npos;
}

AnswerSample read_answer(std::string_view content, const std::string &file) {
  return read_with(content, file, [](AnswerReader &reader) { return of_one_material(reader.sample()); });
}

AnswerSample read_material_answer(std::string_view content, const std::string &file) {
  return read_with(content, file, [](AnswerReader &reader) { return reader.sample(); });
}

Gradation answer_curve(std::string_view content, const std::string &file) {
  return read_with(content, file, [](AnswerReader &reader) { return reader.curve(); });
}

Gradation answer_gradation(std::string_view content, const std::string &file, PhiReading phi) {
  return read_with(content, file, [phi](AnswerReader &reader) { return reader.gradation(phi); });
}

} // namespace mdm
