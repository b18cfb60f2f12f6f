#include "papers/survey.hpp"

#include "match/fixed_size.hpp"
#include "match/least_match.hpp"
#include "match/spanned_integer.hpp"

namespace mdm {
namespace {

Published spanned_integer_at_middle(const Gradation &g) {
  SpannedIntegerOptions options;
  options.start = ratio(1, 2);
  options.increments = 1;
  return spanned_integer(g, {}, options);
}

std::optional<Integer> particles(const Published &run, bool reached) {
  return reached ? std::optional(total(run.result().q)) : std::nullopt;
}

SurveyCounts counts(const Gradation &g) {
  const Published fixed = fixed_size(g, {});
  const Published middle = spanned_integer_at_middle(g);
  const Published printed = spanned_integer(g, {});
  return {total(least_match(Problem(g, {}, 1)).q),
          particles(middle, middle.is_match()),
          particles(printed, printed.is_match()),
          particles(fixed, fixed.reached),
          total(fixed.tries.front().q),
          middle.tries.size(),
          printed.tries.size(),
          fixed.tries.size()};
}

Available<Real> real(const Available<PowerProduct> &value) {
  if (value)
    return value->real();
  return value.why();
}

} // namespace

SurveyRow survey(const Gradation &g) {
  const GradingCurve curve(g);
  return {g.id(),
          curve.sizes(),
          curve.shares(),
          curve.mass(curve.finest()),
          real(uniformity(curve)),
          real(curvature(curve)),
          grain_size_index(curve),
          curvature_index(curve),
          finest_mass_ratio(curve),
          coarsest_volume_ratio(curve).exact().value(),
          classify_uscs(curve),
          counts(g)};
}

Convergence convergence(const Gradation &g) {
  return {g.id(), spanned_integer_at_middle(g), fixed_size(g, {})};
}

} // namespace mdm
