#include "ask/regrading.hpp"

#include "ask/option_values.hpp"
#include "gradation/joined.hpp"
#include "text/file_names.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// The size behind `above:`.
Length size_above(const std::string &name, const std::string &text) {
  constexpr std::string_view word = "above:";
  if (!text.starts_with(word))
    throw InputError(
        fmt::format("{}: {} is not above:SIZE: write as above:20mm", option(name), in_quotes(text)));
  return length(name, text.substr(word.size()));
}

/// `FROM..TO`.
std::pair<Length, Length> range_of_sizes(const std::string &name, const std::string &text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos)
    throw InputError(
        fmt::format("{}: {} is not FROM..TO: write as 5mm..20mm", option(name), in_quotes(text)));
  return {length(name, text.substr(0, dots)), length(name, text.substr(dots + 2))};
}

/// `1/5` or `0.2`.
Rational ratio_of(const std::string &name, const std::string &text) {
  if (text.ends_with('%'))
    throw InputError(fmt::format("{}: {} is a percentage: write the ratio of the sizes, as 0.2 or 1/5",
                                 option(name), in_quotes(text)));
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos)
    return positive(name, text);
  return positive(name, text.substr(0, slash)) / positive(name, text.substr(slash + 1));
}

/// Percents that were rounded are masses from here on, which nothing says of them by itself.
void add_lost_rounding(std::vector<std::string> &history, const Gradation &before, const Gradation &after,
                       const std::string &file) {
  if (!before.roundings().empty() && after.roundings().empty())
    history.push_back(
        fmt::format("the percents of {} were rounded to their last digit; here they are masses, which mdm "
                    "judge takes as exact unless {} says otherwise",
                    file, option("rounding", OptionSpelling::program)));
}

/// The change of a gradation, with its history behind that so far; messages name the file and the option.
template <class Change>
Regraded then(Regraded before, const std::string &file, const std::string &name, Change change) {
  try {
    Regraded after = change(before.gradation);
    before.history.insert(before.history.end(), after.history.begin(), after.history.end());
    add_lost_rounding(before.history, before.gradation, after.gradation, file);
    return {std::move(after.gradation), std::move(before.history)};
  } catch (const InputError &e) {
    throw file_error(file, option(name) + ": " + e.what());
  }
}

} // namespace

bool RegradingTexts::is_given() const {
  return !files().empty() || at || fine_mass || scalp || !replace.empty() || parallel_ratio;
}

void RegradingTexts::check(const std::optional<std::string> &file) const {
  if (!join.empty() && !split.empty())
    throw InputError(option("join") + " and " + option("split") + " exclude each other: give one of them");
  if (files().empty()) {
    if (at || fine_mass)
      throw InputError(option(at ? "at" : "fine-mass") + " is about two files: give " + option("join") +
                       " or " + option("split") + " too");
    if (!file)
      throw InputError("mdm: FILE is required, or two with " + option("join") + " or " + option("split") +
                       "; see mdm convert " + option("help"));
    return;
  }
  const std::string name = option(join.empty() ? "split" : "join");
  if (file)
    throw InputError(fmt::format("{}: {} has the files: leave it out", in_quotes(*file), name));
  if (!at)
    throw InputError(name + " needs " + option("at") + ": give the sieve at which the two are joined");
  if (!join.empty() && fine_mass)
    throw InputError(option("fine-mass") + " is of " + option("split") + ": leave it out");
  if (std::count(files().begin(), files().end(), "-") == 2)
    throw InputError("-: standard input is one file: give the other by name");
}

Regraded RegradingTexts::joined_parts(const UnderstoodGradation &c, const UnderstoodGradation &f,
                                      const std::vector<std::string> &names) const {
  if (fine_mass && c.kind != "mass" && c.kind != "retained_g")
    throw file_error(names[0], option("fine-mass") + ": it is a mass beside masses, and this file has " +
                                   c.kind + ": give the pan a row there");
  const NamedGradation coarse{c.gradation, names[0]}, fine{f.gradation, names[1]};
  const Rational joint = length("at", *at).in(coarse.gradation);
  Regraded both = !join.empty()
                      ? joined(coarse, fine, joint)
                      : composed(coarse, fine, joint,
                                 fine_mass ? std::optional(positive("fine-mass", *fine_mass)) : std::nullopt);
  for (const NamedGradation *part : {&coarse, &fine})
    add_lost_rounding(both.history, part->gradation, both.gradation, part->name);
  return both;
}

Regraded RegradingTexts::changed(Regraded g, const std::string &file) const {
  if (scalp) {
    const Rational above = size_above("scalp", *scalp).in(g.gradation);
    g = then(std::move(g), file, "scalp", [&](const Gradation &of) { return scalped(of, above); });
  }
  if (!replace.empty()) {
    if (replace[1] != "into")
      throw InputError(fmt::format("{}: {} is not the word into: write as above:20mm into 5mm..20mm",
                                   option("replace"), in_quotes(replace[1])));
    const Length above = size_above("replace", replace[0]);
    const auto [from, to] = range_of_sizes("replace", replace[2]);
    const Replacement r{above.in(g.gradation), from.in(g.gradation), to.in(g.gradation)};
    g = then(std::move(g), file, "replace", [&](const Gradation &of) { return replaced(of, r); });
  }
  if (parallel_ratio) {
    const Rational factor = ratio_of("parallel", *parallel_ratio);
    g = then(std::move(g), file, "parallel", [&](const Gradation &of) { return parallel(of, factor); });
  }
  return g;
}

} // namespace mdm
