// One gradation of two. Both are cut at the joint, exactly: it is a sieve of theirs, or no mass lies around
// it. Of the coarse one the classes above the joint stay as they are; of the fine one those below it, with
// their masses times M / F, M the mass that passes the joint in the coarse one and F that in the fine one. So
// the whole keeps its mass, and every share below the joint is P(joint) times its share of what passes there.

#include "gradation/joined.hpp"

#include "gradation/exact_cut.hpp"
#include "gradation/shown.hpp"
#include "text/file_names.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

/// A gradation cut at the joint, its sizes in the unit of the result.
struct CutPart {
  const NamedGradation &of;
  std::vector<Rational> sizes;
  std::size_t below; ///< classes
  Rational passing;  ///< mass that passes the joint
};

CutPart cut_part(const NamedGradation &of, SizeUnit unit, const Rational &at) {
  return in_file(of.name, [&] {
    const Gradation &g = of.gradation;
    refuse_tolerances(g);
    const Rational in_result = in_mm(g.unit()) / in_mm(unit);
    CutPart part{of, g.sizes(), classes_below(g, Rational(at / in_result), "the joint"), 0};
    for (Rational &size : part.sizes)
      size *= in_result;
    part.passing = mass_of(g, 0, part.below);
    return part;
  });
}

void check_passing(const CutPart &part, const Rational &mass, const std::string &joint) {
  if (mass == 0)
    throw InputError(
        fmt::format("{}: nothing passes {}, where the two are joined: give a larger size, or leave the "
                    "other file out",
                    part.of.name, joint));
}

/// Two analyses of the whole: the coarse one must have something above the joint.
void check_above(const CutPart &coarse, const std::string &joint) {
  const Gradation &g = coarse.of.gradation;
  if (mass_of(g, coarse.below, g.classes()) == 0)
    throw InputError(fmt::format("{}: it has no mass above {}, where the two are joined: check the unit of "
                                 "{}, and give the coarse file before the fine one",
                                 coarse.of.name, joint, option("at")));
}

/// Adds a row whose class has the factor of class j of g.
void add_row(Gradation::Data &data, const Gradation &g, std::size_t j, const Rational &size,
             const Rational &mass) {
  data.sizes.push_back(size);
  data.masses.push_back(mass);
  data.factors.push_back(g.factor(std::min(j, g.classes())));
}

/// The rows of both. \param factor of the masses of the fine part
Gradation rows_of_both(const CutPart &coarse, const CutPart &fine, const Rational &at,
                       const Rational &factor) {
  const Gradation &c = coarse.of.gradation, &f = fine.of.gradation;
  Gradation::Data data;
  data.id = c.id();
  data.unit = c.unit();
  for (std::size_t i = 0; i <= fine.below && fine.sizes[i] < at; ++i)
    add_row(data, f, i, fine.sizes[i], i < fine.below ? Rational(f.mass(i) * factor) : Rational(0));
  const std::size_t j = coarse.below;
  add_row(data, c, j, at, j < c.classes() ? c.mass(j) : Rational(0));
  for (std::size_t i = j; i < coarse.sizes.size(); ++i)
    if (coarse.sizes[i] > at)
      add_row(data, c, i, coarse.sizes[i], c.masses()[i]);
  if (!c.has_factors() && !f.has_factors())
    data.factors.clear();
  for (const CutPart *part : {&coarse, &fine})
    for (const std::string &note : part->of.gradation.notes())
      data.notes.push_back(part->of.name + ": " + note);
  return Gradation(std::move(data));
}

/// The share that passes the i-th size.
Rational share_passing(const Gradation &g, std::size_t i) {
  return mass_of(g, 0, i) / mass_of(g, 0, g.classes());
}

/// The sizes of the one part that the other's take the place of, and which both have.
struct Overlap {
  std::vector<std::pair<std::size_t, std::size_t>> both; ///< places in coarse, in fine
  std::vector<Rational> left_out_of_coarse, left_out_of_fine;
};

Overlap overlap_of(const CutPart &coarse, const CutPart &fine, const Rational &at) {
  Overlap o;
  for (std::size_t i = 0; i < coarse.sizes.size(); ++i)
    if (const Rational &size = coarse.sizes[i]; size > 0 && size < at) {
      o.left_out_of_coarse.push_back(size);
      const auto found = std::find(fine.sizes.begin(), fine.sizes.end(), size);
      if (found != fine.sizes.end())
        o.both.emplace_back(i, static_cast<std::size_t>(found - fine.sizes.begin()));
    }
  const Gradation &f = fine.of.gradation;
  if (mass_of(f, fine.below, f.classes()) == 0)
    return o; // its larger sizes say nothing but that all passes the joint
  for (std::size_t i = 0; i < fine.sizes.size(); ++i)
    if (fine.sizes[i] > at) {
      o.left_out_of_fine.push_back(fine.sizes[i]);
      const auto found = std::find(coarse.sizes.begin(), coarse.sizes.end(), fine.sizes[i]);
      if (found != coarse.sizes.end())
        o.both.emplace_back(static_cast<std::size_t>(found - coarse.sizes.begin()), i);
    }
  return o;
}

void add_left_out(std::vector<std::string> &history, const CutPart &part, const std::vector<Rational> &sizes,
                  SizeUnit unit) {
  if (sizes.empty())
    return;
  std::vector<std::string> texts;
  for (const Rational &size : sizes)
    texts.push_back(shown(size));
  history.push_back(
      fmt::format("left out of {}: what it has at {} {}", part.of.name, fmt::join(texts, ", "), name(unit)));
}

/// What both have beside the joint, and what was left out. \param factor of shares of the fine part
void add_overlap(std::vector<std::string> &history, const CutPart &coarse, const CutPart &fine,
                 const Rational &at, const Rational &factor) {
  const Overlap o = overlap_of(coarse, fine, at);
  const SizeUnit unit = coarse.of.gradation.unit();
  for (const auto &[i, j] : o.both) {
    const Rational of_coarse = share_passing(coarse.of.gradation, i),
                   of_fine = share_passing(fine.of.gradation, j) * factor;
    history.push_back(fmt::format("compared at {}: {} passes in {}, {} in {}", shown(coarse.sizes[i], unit),
                                  shown_percent(of_coarse), coarse.of.name, shown_percent(of_fine),
                                  fine.of.name));
    if (of_fine > 1)
      history.push_back(
          fmt::format("more than 100 % passes {} in {}, measured by {}: check the unit of {} and "
                      "the order of the files",
                      shown(coarse.sizes[i], unit), fine.of.name, coarse.of.name, option("at")));
  }
  if (o.both.empty() && !(o.left_out_of_coarse.empty() && o.left_out_of_fine.empty()))
    history.emplace_back("the two have no size in common beside the joint: nothing is compared");
  add_left_out(history, coarse, o.left_out_of_coarse, unit);
  add_left_out(history, fine, o.left_out_of_fine, unit);
}

/// Factors are of classes: of one part alone nothing says what the other's are.
void check_factors(const CutPart &coarse, const CutPart &fine) {
  const bool has_coarse = coarse.of.gradation.has_factors();
  if (has_coarse == fine.of.gradation.has_factors())
    return;
  throw InputError(
      fmt::format("{}: its classes have factors, and those of {} have none: give both the column "
                  "factor, or neither",
                  (has_coarse ? coarse : fine).of.name, (has_coarse ? fine : coarse).of.name));
}

/// Joins the parts. \param passing  mass that passes the joint, of `whole`
Regraded joined_parts(const CutPart &coarse, const CutPart &fine, const Rational &at,
                      const Rational &passing) {
  const SizeUnit unit = coarse.of.gradation.unit();
  const std::string joint = shown(at, unit);
  check_passing(coarse, passing, joint);
  check_passing(fine, fine.passing, joint);
  const Gradation &c = coarse.of.gradation, &f = fine.of.gradation;
  check_factors(coarse, fine);
  const Rational whole = mass_of(c, coarse.below, c.classes()) + passing;
  const Rational share = passing / whole, share_of_fine = fine.passing / mass_of(f, 0, f.classes());
  const Gradation both = rows_of_both(coarse, fine, at, passing / fine.passing);
  std::vector<std::string> history = {
      fmt::format("joined at {}: {} above, {} below", joint, coarse.of.name, fine.of.name),
      fmt::format("{} passes {}: the mass {} of {} in {}; in {} it is {}", shown_percent(share), joint,
                  shown(passing), shown(whole), coarse.of.name, fine.of.name, shown(fine.passing)),
      fmt::format("the masses of {} are multiplied by {}", fine.of.name, to_string(passing / fine.passing))};
  add_overlap(history, coarse, fine, at, share / share_of_fine);
  Gradation::Data data{both.id(),      both.unit(), both.sizes(), both.masses(),
                       both.factors(), {},          {},           both.notes()};
  add_multiple(history, make_decimals(data.masses));
  return {Gradation(std::move(data)), std::move(history)};
}

} // namespace

Regraded joined(const NamedGradation &coarse, const NamedGradation &fine, const Rational &at) {
  const SizeUnit unit = coarse.gradation.unit();
  const CutPart c = cut_part(coarse, unit, at), f = cut_part(fine, unit, at);
  check_above(c, shown(at, unit));
  return joined_parts(c, f, at, c.passing);
}

Regraded composed(const NamedGradation &coarse, const NamedGradation &fine, const Rational &at,
                  const std::optional<Rational> &passed) {
  const SizeUnit unit = coarse.gradation.unit();
  const CutPart c = cut_part(coarse, unit, at), f = cut_part(fine, unit, at);
  const std::string split = shown(at, unit);
  const Gradation &part = fine.gradation;
  if (const Rational above = mass_of(part, f.below, part.classes()); above != 0)
    throw InputError(fmt::format("{}: the mass {} is above {}, and so no part of what passes it: correct it, "
                                 "or join two analyses of the whole",
                                 fine.name, shown(above), split));
  if (const std::size_t first = c.sizes.front() > 0 ? 0 : 1;
      first < c.below && mass_of(coarse.gradation, first, c.below) != 0)
    throw InputError(fmt::format(
        "{}: the mass {} was weighed on sieves below {}, and the part takes its place: "
        "split at its finest sieve, {}, or join two analyses of the whole",
        coarse.name, shown(mass_of(coarse.gradation, first, c.below)), split, shown(c.sizes[first], unit)));
  if (c.passing == 0 && !passed)
    throw InputError(fmt::format("{}: it has no mass below {}: give a row for the pan, or the mass of all "
                                 "that passed",
                                 coarse.name, split));
  if (c.sizes.front() < at && passed && *passed != c.passing)
    throw InputError(fmt::format("{}: the mass {} passes {}, and {} was given: leave one of them out",
                                 coarse.name, shown(c.passing), split, shown(*passed)));
  if (c.sizes.front() > at)
    throw InputError(fmt::format("{}: its finest sieve is {}, and nothing says what passes {}: split at that "
                                 "sieve",
                                 coarse.name, shown(c.sizes.front(), unit), split));
  return joined_parts(c, f, at, passed.value_or(c.passing));
}

} // namespace mdm
