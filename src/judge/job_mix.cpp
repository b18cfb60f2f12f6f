#include "judge/job_mix.hpp"

#include "gradation/length.hpp"
#include "gradation/shown.hpp"
#include "soil/grading_curve.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

namespace mdm {
namespace {

constexpr const char *within_forms = "write 4.75mm=7,0.075mm=2, or one number for all sieves";

[[noreturn]] void refuse_points(const std::string &text, const std::string &why) {
  throw InputError(option("within") + ": " + in_quotes(text) + why);
}

Rational points_in(std::string_view text, const std::string &whole) {
  if (text.ends_with('%'))
    text.remove_suffix(1);
  try {
    if (const Rational points = parse_decimal(trimmed(text)); points >= 0)
      return points;
  } catch (const InputError &error) {
    refuse_points(whole, std::string(": ") + error.what());
  }
  refuse_points(whole, " is below 0: write how far what passes may be from the job mix, in points");
}

/// The place of a size among the sieves of the mix.
std::size_t sieve_of_mix(const Gradation &mix, std::string_view text, const std::string &whole) {
  std::vector<std::string> sizes;
  try {
    const Rational size = parse_length(text).in(mix.unit());
    for (std::size_t j = 0; j < mix.sizes().size(); ++j) {
      if (mix.sizes()[j] == size)
        return j;
      if (mix.sizes()[j] > 0)
        sizes.push_back(shown(mix.sizes()[j]));
    }
  } catch (const InputError &error) {
    refuse_points(whole, fmt::format(": {}; a sieve is given by its opening, such as 4.75mm", error.what()));
  }
  refuse_points(whole, fmt::format(": the job mix has no sieve {}; there are {} {}", in_quotes(text),
                                   fmt::join(sizes, ", "), name(mix.unit())));
}

/// Points of each sieve of the mix that is to be judged.
std::map<std::size_t, Rational> points_of(const Gradation &mix, const std::vector<std::string> &within) {
  std::map<std::size_t, Rational> points;
  std::optional<Rational> of_all;
  for (const std::string &text : within) {
    const std::vector<std::string> parts = between_commas(text);
    for (const std::string &one : parts) {
      const std::string_view part = trimmed(one);
      const std::size_t equals = part.find('=');
      if (equals == std::string_view::npos) {
        if (of_all || parts.size() > 1)
          refuse_points(text, std::string(" has a number without a sieve beside others: ") + within_forms);
        of_all = points_in(part, text);
      } else if (!points
                      .emplace(sieve_of_mix(mix, trimmed(part.substr(0, equals)), text),
                               points_in(part.substr(equals + 1), text))
                      .second) {
        refuse_points(text, fmt::format(": {} has its points twice: give them once",
                                        in_quotes(trimmed(part.substr(0, equals)))));
      }
    }
  }
  for (std::size_t j = 0; of_all && j < mix.sizes().size(); ++j)
    if (mix.sizes()[j] > 0)
      points.emplace(j, *of_all);
  return points;
}

} // namespace

Specification job_mix_limits(const Gradation &mix, const std::vector<std::string> &within) {
  const GradingCurve curve(mix);
  Specification limits;
  limits.id = "job mix " + mix.id();
  for (const auto &[j, points] : points_of(mix, within)) {
    const Rational passing = 100 * curve.shares()[j];
    limits.sieves.push_back({mix.sizes()[j] * in_mm(mix.unit()), std::max<Rational>(0, passing - points),
                             std::min<Rational>(100, passing + points)});
    limits.about.push_back(fmt::format("{} points about {} % passing {} {}", shown(points), shown(passing),
                                       shown(mix.sizes()[j]), name(mix.unit())));
  }
  for (const std::string &note : mix.notes())
    limits.notes.push_back(printable(mix.id()) + ": " + note);
  return limits;
}

} // namespace mdm
