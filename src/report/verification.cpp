#include "text_buffer.hpp"

#include <mdm/error.hpp>
#include <mdm/json_text.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/report/text_table.hpp>
#include <mdm/report/verification.hpp>
#include <mdm/report/versions.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace mdm {
namespace {

std::string counted(const Integer &n) {
  return to_string(n) + (n == 1 ? " particle" : " particles");
}

/// The digits of 100 y that are certain, at most so many.
std::string percent(const Interval &y, unsigned digits) {
  const std::string lo = approximate(Rational(100 * y.lo), digits);
  if (y.exact())
    return lo;
  const std::string hi = approximate(Rational(100 * y.hi), digits);
  return lo == hi ? lo : "[" + lo + ", " + hi + "]";
}

/// Enough digits for a reader who computes on with an enclosure.
constexpr unsigned enclosure_digits = 30;

/// Outer decimals of y that differ from it by no more than 10^-enclosure_digits.
std::string json_number(const Interval &y) {
  if (y.exact())
    return "\"" + to_string(y.lo) + "\"";
  const Rational unit(power_of_ten(enclosure_digits));
  const auto outer = [](const Integer &n) {
    return n < 0 ? "-" + decimal_string(Integer(-n), enclosure_digits) : decimal_string(n, enclosure_digits);
  };
  return fmt::format(R"(["{}","{}"])", outer(floor(Rational(y.lo * unit))),
                     outer(ceil(Rational(y.hi * unit))));
}

/// A size as a message shows it.
std::string shown(const RootSize &x, SizeUnit unit) {
  constexpr unsigned most_digits = 40;
  const Enclosure size = enclose_root(numerator(x.power), denominator(x.power), x.degree, 15);
  const std::string text = size.text();
  return (text.size() <= most_digits ? text : approximate(size.lower(), 15)) + " " + std::string(name(unit));
}

/// True if an error is 0, and known to be.
bool is_zero(const Interval &error) {
  return error.lo == 0 && error.hi == 0;
}

/// True if all errors are 0; nothing if that is open.
std::optional<bool> all_zero(const std::vector<Interval> &errors) {
  if (std::any_of(errors.begin(), errors.end(), [](const Interval &e) { return e.lo > 0 || e.hi < 0; }))
    return false;
  if (std::all_of(errors.begin(), errors.end(), is_zero))
    return true;
  return std::nullopt;
}

/// A condition of Arnold, Eq. 9-12, with the first reason why it does not hold, or is open.
struct ConditionReport {
  const char *key;
  const char *words;
  std::optional<bool> holds;
  std::string reason;
};

std::string json_truth(const std::optional<bool> &truth) {
  return !truth ? "null" : *truth ? "true" : "false";
}

std::string class_name(std::size_t j) {
  return "class " + std::to_string(j + 1);
}

ConditionReport describes(const Description &d) {
  const Gradation &g = d.gradation();
  std::string reason;
  if (d.below().count > 0)
    reason =
        fmt::format("{} not larger than the finest opening, {} {}, the first of {}", counted(d.below().count),
                    to_decimal(g.lower(0)), name(g.unit()), shown(*d.below().first, g.unit()));
  if (d.above().count > 0)
    reason +=
        fmt::format("{}{} larger than the largest opening, {} {}, the first of {}",
                    reason.empty() ? "" : "; ", counted(d.above().count),
                    to_decimal(g.upper(g.classes() - 1)), name(g.unit()), shown(*d.above().first, g.unit()));
  return {"describes", "describes the sample (no particle outside)", d.describes(), reason};
}

ConditionReport articulately(const Description &d) {
  std::string reason;
  if (!d.describes()) {
    reason = "particles lie outside all classes";
  } else if (const std::optional<std::size_t> j = d.inarticulate_class()) {
    const Description::Class &c = d.of_class(*j);
    reason = fmt::format("{} has several sizes, such as {} and {}", class_name(*j),
                         shown(*c.first, d.gradation().unit()), shown(*c.second, d.gradation().unit()));
  }
  return {"articulately", "articulately (one size a class)", d.articulately(), reason};
}

/// Cond4 for one scale of the masses.
ConditionReport accurately(const Verification &v) {
  const MatchError &e = v.error;
  ConditionReport c{"accurately", "accurately (the shares are equal)", all_zero(e.normalised), ""};
  if (!v.description.describes()) {
    c.holds = false;
    c.reason = "particles lie outside all classes";
  } else if (!c.holds) {
    c.reason = "4096 bits do not tell";
  } else if (!*c.holds) {
    const auto wrong = std::find_if(e.normalised.begin(), e.normalised.end(),
                                    [](const Interval &error) { return error.lo > 0 || error.hi < 0; });
    const auto j = static_cast<std::size_t>(wrong - e.normalised.begin());
    c.reason = fmt::format("{} has {} % of the mass, not {} %", class_name(j), percent(e.shares[j], v.digits),
                           percent(e.targets[j], v.digits));
  }
  return c;
}

/// Cond4 as Eq. 12 has it: at scale 1.
std::optional<bool> accurately_as_given(const Verification &v) {
  return v.description.describes() ? all_zero(v.error.as_given) : false;
}

std::array<ConditionReport, 4> conditions(const Verification &v) {
  return {ConditionReport{"complete", "complete", true, ""}, describes(v.description),
          articulately(v.description), accurately(v)};
}

void add_table(Buffer &out, const Verification &v) {
  using Line = std::vector<std::string>;
  const Gradation &g = v.description.gradation();
  std::vector<Line> lines = {Line{"class", fmt::format("sizes ({}]", name(g.unit())), "particles", "target %",
                                  "found %", "target - found"}};
  for (std::size_t j = 0; j < g.classes(); ++j)
    lines.push_back({std::to_string(j + 1),
                     "(" + to_decimal(g.lower(j)) + ", " + to_decimal(g.upper(j)) + "]",
                     to_string(v.description.of_class(j).count), percent(v.error.targets[j], v.digits),
                     percent(v.error.shares[j], v.digits), percent(v.error.normalised[j], v.digits)});
  add(out, "{}", text_table(lines, "><>"));
}

} // namespace

Verification::Verification(Description d, Question asked, Rational within)
    : description(std::move(d)), error(description.error()), question(std::move(asked)),
      tolerance(std::move(within)) {}

Verdict Verification::verdict() const {
  if (!description.describes() || !objections.empty() || error.maximum.lo > tolerance)
    return Verdict::no_match;
  return error.maximum.hi <= tolerance ? Verdict::match : Verdict::undecided;
}

std::string headline(const Verification &v) {
  const std::string tolerance = v.tolerance == 0 ? "" : " within " + percent(v.tolerance, 15) + " %";
  const std::string worst = fmt::format("the largest error of a share is {} %, in {}",
                                        percent(v.error.maximum, v.digits), class_name(v.error.worst));
  const Integer outside = v.description.below().count + v.description.above().count;
  switch (v.verdict()) {
  case Verdict::match:
    return is_zero(v.error.maximum) ? "matches exactly" : "matches" + tolerance + ": " + worst;
  case Verdict::undecided:
    return "undecided: 4096 bits do not tell whether it matches" + tolerance + ": " + worst;
  default:
    if (!v.objections.empty())
      return "does not match: " + v.objections.front();
    if (outside > 0)
      return "does not match: " + counted(outside) + " outside all classes";
    return "does not match" + tolerance + ": " + worst;
  }
}

std::string verification_text(const Verification &v) {
  Buffer out;
  const std::string words = in_words(v.question);
  add(out, "{} against {}: {}{}\n\n", printable(v.sample), printable(v.description.gradation().id()),
      headline(v), words.empty() ? "" : " (" + words + ")");
  add_table(out, v);
  const Integer n = v.description.particles();
  out.push_back('\n');
  if (!is_zero(v.error.maximum))
    add(out, "  largest error: {} % in {}; all together: {} %\n", percent(v.error.maximum, v.digits),
        class_name(v.error.worst), percent(v.error.total, v.digits));
  add(out, "  particles: {}; the smallest exact match has {} (ratio {})\n", to_string(n), v.smallest.text(),
      v.smallest.ratio_text(n));
  if (v.description.snapped() > 0)
    add(out, "  taken as an opening near by: {}\n", counted(v.description.snapped()));
  add(out, "\n  conditions, the gradation\n");
  std::size_t number = 0;
  for (const ConditionReport &c : conditions(v)) {
    add(out, "    {} {}: {}{}\n", ++number, c.words,
        !c.holds   ? "open"
        : *c.holds ? "yes"
                   : "no",
        c.reason.empty() ? "" : ", " + c.reason);
  }
  for (const std::string &objection : v.objections)
    add(out, "  objection: {}\n", objection);
  for (const std::string &note : v.notes)
    add(out, "  note: {}\n", note);
  return fmt::to_string(out);
}

std::string verification_csv(const Verification &v) {
  Buffer out;
  const Gradation &g = v.description.gradation();
  add(out, "lower_{0},upper_{0},quantity,target_percent,found_percent,error_percent\n", name(g.unit()));
  for (std::size_t j = 0; j < g.classes(); ++j)
    add(out, "{},{},{},{},{},{}\n", to_decimal(g.lower(j)), to_decimal(g.upper(j)),
        to_string(v.description.of_class(j).count), percent(v.error.targets[j], v.digits),
        percent(v.error.shares[j], v.digits), percent(v.error.normalised[j], v.digits));
  return fmt::to_string(out);
}

std::string verification_json(const Verification &v) {
  Buffer out;
  const Description &d = v.description;
  const Gradation &g = d.gradation();
  static constexpr std::array<const char *, 3> verdicts = {"match", "no match", "undecided"};
  add(out, R"({{"schema":"mdm-verify-1","id":{},"sample":{},"verdict":"{}","tolerance_percent":"{}")",
      json_string(g.id()), json_string(v.sample), verdicts.at(static_cast<std::size_t>(v.verdict())),
      to_string(Rational(100 * v.tolerance)));
  add(out, R"(,"particles":"{}","smallest":["{}","{}"],"ratio":"{}")", to_string(d.particles()),
      to_string(v.smallest.lo), to_string(v.smallest.hi), v.smallest.ratio_text(d.particles()));
  add(out, R"(,"outside":{{"below":"{}","above":"{}"}},"snapped":"{}","conditions":{{)",
      to_string(d.below().count), to_string(d.above().count), to_string(d.snapped()));
  const char *comma = "";
  for (const ConditionReport &c : conditions(v)) {
    add(out, R"({}"{}":{{"holds":{},"reason":{}}})", comma, c.key, json_truth(c.holds),
        c.reason.empty() ? "null" : json_string(c.reason));
    comma = ",";
  }
  add(out, R"(,"accurately_as_given":{{"holds":{}}}}},"unit":"{}","classes":[)",
      json_truth(accurately_as_given(v)), name(g.unit()));
  for (std::size_t j = 0; j < g.classes(); ++j)
    add(out,
        R"({}{{"lower":"{}","upper":"{}","quantity":"{}","target":"{}","found":{},"error":{},)"
        R"("error_percent":"{}","error_as_given":{}}})",
        j == 0 ? "" : ",", to_decimal(g.lower(j)), to_decimal(g.upper(j)), to_string(d.of_class(j).count),
        to_string(v.error.targets[j]), json_number(v.error.shares[j]), json_number(v.error.normalised[j]),
        percent(v.error.normalised[j], v.digits), json_number(v.error.as_given[j]));
  add(out,
      R"(],"worst_class":{},"maximum_error":{},"maximum_error_percent":"{}","total_error":{},)"
      R"("total_error_percent":"{}","objections":[)",
      is_zero(v.error.maximum) ? "null" : fmt::format("\"{}\"", v.error.worst + 1),
      json_number(v.error.maximum), percent(v.error.maximum, v.digits), json_number(v.error.total),
      percent(v.error.total, v.digits));
  for (std::size_t i = 0; i < v.objections.size(); ++i)
    add(out, "{}{}", i == 0 ? "" : ",", json_string(v.objections[i]));
  add(out, R"(],"notes":[)");
  for (std::size_t i = 0; i < v.notes.size(); ++i)
    add(out, "{}{}", i == 0 ? "" : ",", json_string(v.notes[i]));
  add(out, R"(],"versions":{}}})", versions_json());
  return fmt::to_string(out);
}

} // namespace mdm
