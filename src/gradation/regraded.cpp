#include "gradation/regraded.hpp"

#include "gradation/exact_cut.hpp"
#include "gradation/shown.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

/// g without the classes from `kept` on. \pre g has no tolerances
Gradation::Data lowest_classes(const Gradation &g, std::size_t kept) {
  Gradation::Data data{g.id(), g.unit(), g.sizes(), g.masses(), g.factors(), {}, {}, g.notes()};
  data.sizes.resize(kept + 1);
  data.masses.resize(kept + 1);
  data.masses.back() = 0;
  if (g.has_factors())
    data.factors.resize(kept + 1);
  return data;
}

/// The classes in (from, to].
struct ReplacedClasses {
  std::size_t begin, end;
};

ReplacedClasses replaced_classes(const Gradation &g, const Replacement &r) {
  if (r.from >= r.to)
    throw InputError(fmt::format("the grains that replace others lie between {} and {}: give the finer size "
                                 "first",
                                 shown(r.from, g.unit()), shown(r.to, g.unit())));
  if (r.to > r.above)
    throw InputError(fmt::format("grains up to {} would replace grains above {}: give a size of at most {}",
                                 shown(r.to, g.unit()), shown(r.above, g.unit()), shown(r.above, g.unit())));
  return {classes_below(g, r.from, "the finer end"), classes_below(g, r.to, "the coarser end")};
}

} // namespace

void refuse_tolerances(const Gradation &g) {
  if (!g.tolerances().empty())
    throw InputError("it has tolerances, which are of its shares as they are: leave that column out");
}

Integer make_decimals(std::vector<Rational> &masses) {
  Integer multiple = 1;
  for (const Rational &mass : masses) {
    Integer rest = denominator(mass);
    for (const unsigned prime : {2U, 5U})
      while (rest % prime == 0)
        rest /= prime;
    multiple = lcm(multiple, rest);
  }
  if (multiple != 1)
    for (Rational &mass : masses)
      mass *= Rational(multiple);
  return multiple;
}

void add_multiple(std::vector<std::string> &history, const Integer &multiple) {
  if (multiple != 1)
    history.push_back(
        fmt::format("all masses are multiplied by {}, so that they are decimals", to_string(multiple)));
}

std::string shown_percent(const Rational &share) {
  const Rational percent = share * 100;
  const std::string exact = shown(percent), near = shown_hundredths(percent);
  const bool is_short = exact.size() <= 12 && parse_decimal(exact) == percent;
  return (is_short ? exact : "about " + near) + " %";
}

Regraded scalped(const Gradation &g, const Rational &size) {
  refuse_tolerances(g);
  const std::size_t kept = classes_below(g, size, "scalping");
  const Rational above = mass_of(g, kept, g.classes()), all = mass_of(g, 0, g.classes());
  if (above == all)
    throw InputError(fmt::format("nothing is at or below {}: scalp at a larger size", shown(size, g.unit())));
  return {Gradation(lowest_classes(g, kept)),
          {fmt::format("scalped: the mass {} of {} above {}, {}, is left out", shown(above), shown(all),
                       shown(size, g.unit()), shown_percent(above / all))}};
}

Regraded replaced(const Gradation &g, const Replacement &r) {
  refuse_tolerances(g);
  const ReplacedClasses band = replaced_classes(g, r);
  const std::size_t kept = classes_below(g, r.above, "replacing");
  const Rational above = mass_of(g, kept, g.classes()), all = mass_of(g, 0, g.classes()),
                 there = mass_of(g, band.begin, band.end);
  if (above != 0 && there == 0)
    throw InputError(fmt::format("there is no mass between {} and {} in whose shares that above {} could "
                                 "be replaced: give other sizes",
                                 shown(r.from, g.unit()), shown(r.to, g.unit()), shown(r.above, g.unit())));
  Gradation::Data data = lowest_classes(g, kept);
  if (above != 0)
    for (std::size_t j = band.begin; j < band.end; ++j)
      data.masses[j] *= (there + above) / there;
  const Integer multiple = make_decimals(data.masses);
  std::vector<std::string> history = {
      fmt::format("replaced: the mass {} of {} above {}, {}, is now between {} and {}, where it was {}",
                  shown(above), shown(all), shown(r.above, g.unit()), shown_percent(above / all),
                  shown(r.from, g.unit()), shown(r.to, g.unit()), shown(there))};
  add_multiple(history, multiple);
  return {Gradation(std::move(data)), std::move(history)};
}

Regraded parallel(const Gradation &g, const Rational &factor) {
  Gradation scaled = g.scaled(factor);
  for (const Rational &size : scaled.sizes())
    if (!exact_decimal(size))
      throw InputError(fmt::format("a size times {} is no decimal, which a file could not hold: give a ratio "
                                   "that is one, as 0.2",
                                   to_string(factor)));
  const std::string before = shown(g.sizes().back(), g.unit()),
                    after = shown(scaled.sizes().back(), g.unit());
  return {std::move(scaled),
          {fmt::format("parallel gradation: all sizes times {}, the largest sieve from {} to {}",
                       to_string(factor), before, after)}};
}

std::string history_comments(const std::vector<std::string> &history) {
  std::string text;
  for (const std::string &line : history)
    text += "# " + printable(line) + "\n";
  return text;
}

} // namespace mdm
