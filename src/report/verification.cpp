#include "report/verification.hpp"

#include "answer/json_values.hpp"
#include "gradation/shown.hpp"
#include "number/counted.hpp"
#include "report/interval_json.hpp"
#include "report/share_bounds.hpp"
#include "report/sphere_report.hpp"
#include "text/option_name.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace mdm {
namespace {

/// The share of class j in the sample in percent; as a difference from the target, `44.86 - 3e-8`, where as
/// many digits would not tell them apart or only look different for being cut.
std::string found_percent(const MatchError &e, std::size_t j, unsigned digits) {
  const Interval &difference = e.normalised[j]; // target - found
  constexpr unsigned few_digits = 2;
  if (difference.lo < 0 && difference.hi > 0) {
    const Rational most = std::max(abs(difference.lo), difference.hi);
    if (most * Rational(power_of_ten(digits - 1)) < e.targets[j]) // a tenth more, before it is cut
      return percent_text(e.targets[j], digits) + " +- " + approximate(Rational(110 * most), few_digits);
  }
  const Rational least = std::min(abs(difference.lo), abs(difference.hi));
  const bool is_sure = difference.lo > 0 || difference.hi < 0;
  if (!is_sure || least * Rational(power_of_ten(digits - 1)) >= e.shares[j].lo)
    return percent_text(e.shares[j], digits);
  return percent_text(e.targets[j], digits) + (difference.lo > 0 ? " - " : " + ") +
         approximate(Rational(100 * least), few_digits);
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

/// The place of class j among all that are classes, from 1.
std::size_t place_in_classes(const Gradation &g, std::size_t j) {
  std::size_t place = 0;
  for (std::size_t i = 0; i <= j; ++i)
    place += g.is_class(i) ? std::size_t{1} : 0;
  return place;
}

std::string class_name(std::size_t j) {
  return "class " + std::to_string(j + 1);
}

ConditionReport describes(const Description &d) {
  const Gradation &g = d.gradation();
  const auto opening = [&g](std::size_t j) {
    return g.materials().empty() ? ", " + g.opening_text(j) + " " + std::string(name(g.unit()))
                                 : " of their material";
  };
  std::string reason;
  const auto add = [&reason](const std::string &part) { reason += (reason.empty() ? "" : "; ") + part; };
  if (d.below().count > 0)
    add(fmt::format("{} not larger than the finest opening{}, the first of {}", counted(d.below().count),
                    opening(0), shown(*d.below().first, g.unit())));
  if (d.above().count > 0)
    add(fmt::format("{} larger than the largest opening{}, the first of {}", counted(d.above().count),
                    opening(g.classes()), shown(*d.above().first, g.unit())));
  if (d.foreign() > 0)
    add(fmt::format("{} of materials that the gradation does not have, the first of {}", counted(d.foreign()),
                    in_quotes(d.foreign_material())));
  return {"describes", "nothing outside (describes)", d.describes(), reason};
}

ConditionReport articulately(const Description &d) {
  std::string reason;
  if (!d.describes()) {
    reason = "particles lie outside all classes";
  } else if (const std::optional<std::size_t> j = d.inarticulate_class()) {
    const Description::Class &c = d.of_class(*j);
    reason = fmt::format("{} has several sizes, such as {} and {}", class_name(*j),
                         shown(*c.first, d.gradation().unit()), shown(*c.second, d.gradation().unit()));
  } else if (!d.articulately()) {
    reason = "of sizes ranges are known";
  }
  return {"articulately", "one size per class (articulately)", d.articulately(), reason};
}

/// Cond4 for one scale of the masses.
ConditionReport accurately(const Verification &v) {
  const MatchError &e = v.error;
  ConditionReport c{"accurately", "shares exact (accurately)", all_zero(e.normalised), ""};
  if (!v.description.describes()) {
    c.holds = false;
    c.reason = "particles lie outside all classes";
  } else if (!c.holds) {
    c.reason = v.description.knows_sizes() ? "4096 bits do not tell" : "of sizes ranges are known";
  } else if (!*c.holds) {
    const auto wrong = std::find_if(e.normalised.begin(), e.normalised.end(),
                                    [](const Interval &error) { return error.lo > 0 || error.hi < 0; });
    const auto j = static_cast<std::size_t>(wrong - e.normalised.begin());
    c.reason = fmt::format("{} has {} % of the mass, not {} %{}", class_name(j),
                           found_percent(e, j, v.digits), percent_text(e.targets[j], v.digits),
                           v.verdict() == Verdict::match ? "; every share is within the tolerance" : "");
  }
  return c;
}

/// Cond4 as Eq. 12 has it: at scale 1.
std::optional<bool> accurately_as_given(const Verification &v) {
  return v.description.describes() ? all_zero(v.error.as_given) : false;
}

std::array<ConditionReport, 4> conditions(const Verification &v) {
  return {ConditionReport{"complete", "nothing on the largest sieve (complete)", true, ""},
          describes(v.description), articulately(v.description), accurately(v)};
}

void add_table(TextBuffer &out, const Verification &v) {
  using Cells = std::vector<std::string>;
  const Gradation &g = v.description.gradation();
  const bool has_materials = !g.materials().empty();
  std::vector<Cells> lines = {Cells{"class", fmt::format("sizes, {} (above, up to]", name(g.unit())),
                                    "particles", "target %", "found %", "target - found"}};
  if (has_materials)
    lines.front().insert(std::next(lines.front().begin()), "material");
  for (std::size_t j = 0; j < g.classes(); ++j) {
    if (!g.is_class(j))
      continue;
    Cells &line = lines.emplace_back(Cells{std::to_string(j + 1)});
    if (has_materials)
      line.push_back(printable(g.material(j)));
    for (const std::string &cell :
         {"(" + g.opening_text(j) + ", " + g.opening_text(j + 1) + "]",
          to_string(v.description.of_class(j).count), percent_text(v.error.targets[j], v.digits),
          found_percent(v.error, j, v.digits), percent_text(v.error.normalised[j], v.digits)})
      line.push_back(cell);
  }
  add(out, "{}", text_table(lines, has_materials ? "><<>" : "><>"));
}

} // namespace

const char *name(Verdict verdict) {
  constexpr std::array<const char *, 3> names = {"match", "no match", "undecided"};
  return names.at(static_cast<std::size_t>(verdict));
}

Verification::Verification(Description d, Question asked, Rational most_error)
    : description(std::move(d)), error(description.error()), question(std::move(asked)),
      tolerance(std::move(most_error)) {}

Verdict Verification::verdict() const {
  const std::optional<bool> is_within = check_bounds(bounds, error, description.gradation(), digits).holds;
  if (!description.describes() || !objections.empty() || error.maximum.lo > tolerance || is_within == false)
    return Verdict::no_match;
  const bool is_sure = is_within == true && description.unplaced().count == 0;
  return error.maximum.hi <= tolerance && is_sure ? Verdict::match : Verdict::undecided;
}

std::string headline(const Verification &v) {
  const std::string tolerance = !v.within.empty()  ? " within " + v.within
                                : v.tolerance == 0 ? ""
                                                   : " within " + percent_text(v.tolerance, 15) + " %";
  const std::string broken = check_bounds(v.bounds, v.error, v.description.gradation(), v.digits).reason;
  const std::string worst =
      fmt::format("the largest error of a share is {} %, in {}",
                  percent_text(v.error.maximum, digits_apart(v.error.maximum.lo, v.tolerance, v.digits)),
                  class_name(v.error.worst));
  const Integer outside = v.description.outside();
  switch (v.verdict()) {
  case Verdict::match:
    return is_zero(v.error.maximum) ? "matches exactly" : "matches" + tolerance + ": " + worst;
  case Verdict::undecided:
    return (v.description.unplaced().count > 0 ? "undecided: " + counted(v.description.unplaced().count) +
                                                     " of which only a range is known, with a sieve in it"
            : v.description.knows_sizes()
                ? "undecided: 4096 bits do not tell whether it matches" + tolerance
                : "undecided: the ranges that are known of the sizes do not tell whether it matches" +
                      tolerance +
                      (tolerance.empty() ? " (a " + option("tolerance") + " of 1e-6 or so does)" : "")) +
           ": " + worst;
  default:
    if (!v.objections.empty())
      return "does not match: " + v.objections.front();
    if (outside > 0)
      return "does not match: " + counted(outside) + " outside all classes";
    return "does not match" + tolerance + ": " + (broken.empty() ? worst : broken);
  }
}

std::string verification_text(const Verification &v) {
  TextBuffer out;
  const std::string words = in_words(v.question, v.description.gradation().unit());
  add(out, "{} against {}: {}{}\n\n", printable(v.sample), printable(v.description.gradation().id()),
      headline(v), words.empty() ? "" : " (" + words + ")");
  add_table(out, v);
  const Integer n = v.description.particles();
  out.push_back('\n');
  if (!is_zero(v.error.maximum))
    add(out, "  largest error: {} % in {}; all together: {} %\n", percent_text(v.error.maximum, v.digits),
        class_name(v.error.worst), percent_text(v.error.total, v.digits));
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
  if (v.packing)
    add(out, "{}", sphere_texture_text(*v.packing, v.description.gradation()));
  for (const std::string &objection : v.objections)
    add(out, "  objection: {}\n", objection);
  for (const std::string &note : v.notes)
    add(out, "  note: {}\n", note);
  return fmt::to_string(out);
}

std::string verification_csv(const Verification &v) {
  TextBuffer out;
  const Gradation &g = v.description.gradation();
  const bool has_materials = !g.materials().empty();
  add(out, "lower_{0},upper_{0},quantity,target_percent,found_percent,error_percent{1}\n", name(g.unit()),
      has_materials ? ",material" : "");
  for (std::size_t j = 0; j < g.classes(); ++j)
    if (g.is_class(j))
      add(out, "{},{},{},{},{},{}{}\n", g.opening_text(j), g.opening_text(j + 1),
          to_string(v.description.of_class(j).count), percent_text(v.error.targets[j], v.digits),
          percent_text(v.error.shares[j], v.digits), percent_text(v.error.normalised[j], v.digits),
          has_materials ? "," + csv_field(g.material(j)) : "");
  return fmt::to_string(out);
}

std::string verification_json(const Verification &v) {
  JsonWriter json;
  const Description &d = v.description;
  const Gradation &g = d.gradation();
  json.begin_object().key("schema").plain("mdm-verify-1").key("id").string(g.id());
  json.key("sample").string(v.sample);
  json.key("verdict").plain(name(v.verdict()));
  write(json.key("tolerance_percent"), Rational(100 * v.tolerance));
  write_text(json.key("within"), v.within);
  write(json.key("particles"), d.particles());
  json.key("smallest").bounds(to_string(v.smallest.lo), to_string(v.smallest.hi));
  json.key("ratio").plain(v.smallest.ratio_text(d.particles()));
  write(json.key("outside").begin_object().key("below"), d.below().count);
  write(json.key("above"), d.above().count);
  if (!g.materials().empty())
    write(json.key("other_materials"), d.foreign());
  json.end_object();
  write(json.key("snapped"), d.snapped());
  json.key("conditions").begin_object();
  for (const ConditionReport &c : conditions(v)) {
    write_truth(json.key(c.key).begin_object().key("holds"), c.holds);
    write_text(json.key("reason"), c.reason).end_object();
  }
  write_truth(json.key("accurately_as_given").begin_object().key("holds"), accurately_as_given(v));
  json.end_object().end_object();
  json.key("unit").plain(name(g.unit())).key("classes").begin_array();
  for (std::size_t j = 0; j < g.classes(); ++j) {
    if (!g.is_class(j))
      continue;
    json.begin_object();
    if (!g.materials().empty())
      json.key("material").string(g.material(j));
    json.key("lower").plain(g.opening_text(j)).key("upper").plain(g.opening_text(j + 1));
    write(json.key("quantity"), d.of_class(j).count);
    write(json.key("target"), v.error.targets[j]);
    write_number(json.key("found"), v.error.shares[j]);
    write_number(json.key("error"), v.error.normalised[j]);
    json.key("error_percent").plain(percent_text(v.error.normalised[j], v.digits));
    write_number(json.key("error_as_given"), v.error.as_given[j]);
    json.end_object();
  }
  json.end_array().key("worst_class");
  if (is_zero(v.error.maximum))
    json.null();
  else
    json.number(place_in_classes(g, v.error.worst));
  write_number(json.key("maximum_error"), v.error.maximum);
  json.key("maximum_error_percent").plain(percent_text(v.error.maximum, v.digits));
  write_number(json.key("total_error"), v.error.total);
  json.key("total_error_percent").plain(percent_text(v.error.total, v.digits));
  json.key("packing");
  if (v.packing)
    write_sphere_texture(json, *v.packing, g);
  else
    json.null();
  json.key("objections").strings(v.objections).key("notes").strings(v.notes);
  json.key("versions").raw(versions_json()).end_object();
  return json.take();
}

} // namespace mdm
