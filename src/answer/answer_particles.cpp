#include "answer/answer_particles.hpp"

#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

/// \throws InputError if the answer's class c does not say what its scale, mass and quantity make, or begins before
/// `above`, the end of those before it
void check_class(const AnswerSample::Class &c, const RootSize &size, const RootSize *above,
                 const MassLaw &law, SizeUnit unit) {
  // Signs of the size less another: under a law by table or sum that of their masses.
  const auto against = [&](const RootSize &other) {
    return law.is_power() ? compare(size, other) : size.power.compare(law.powered(other.power));
  };
  if (against(RootSize{c.size_lo}) < 0 || against(RootSize{c.size_hi}) > 0)
    throw InputError(fmt::format("scale, mass and quantity do not give the size in class {} of the answer "
                                 "with the law {}: say which with {}, or export the gradation "
                                 "itself if it has factors",
                                 c.number, law.formula(unit), option("law")));
  if (c.lower.power < 0 || (above != nullptr && compare(c.lower, *above) < 0))
    throw InputError(fmt::format("class {} of the answer does not begin at or above the end of those before "
                                 "it: solve again",
                                 c.number));
  if (against(c.lower) <= 0 || against(c.upper) > 0)
    throw InputError(
        fmt::format("the size in class {} of the answer is not in the class: solve again", c.number));
}

} // namespace

ParticleSet particle_set(const AnswerSample &answer, const MassLaw &law, const ParticleSetOptions &options) {
  check_power(answer, law);
  if (answer.has_spread)
    throw InputError(
        fmt::format("the answer has a spread of sizes, which are rounded: export the gradation with {} "
                    "and the same {}",
                    option("spread"), option("seed")));
  SizedSample sample{answer.id, answer.unit, answer.size_power, {}, answer.errors};
  const RootSize *above = nullptr;
  for (const AnswerSample::Class &c : answer.classes) {
    const RootSize size{answer.scale * power(Rational(c.mass / c.quantity), answer.scale_power),
                        law.a * answer.size_power};
    check_class(c, size, above, law, answer.unit);
    above = &c.upper;
    sample.classes.push_back({c.number, c.lower, c.upper, size.power, c.quantity});
  }
  const ParticleSet set = particle_set(sample, law, options);
  if (set.particles() != answer.particles)
    throw InputError(fmt::format("the answer says that it has {} particles, its classes have {}: solve again",
                                 to_string(answer.particles), to_string(set.particles())));
  return set;
}

} // namespace mdm
