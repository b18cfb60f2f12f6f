#include "ask/verifier.hpp"

#include <mdm/ask/verify.hpp>
#include <mdm/text/error.hpp>

#include <istream>

namespace mdm {

struct SampleVerifier::State {
  Verifier verifier;
};

SampleVerifier::SampleVerifier(const Gradation &g, const Question &asked)
    : state_(new State{Verifier(g, "", {asked})}) {}

void SampleVerifier::add(const Rational &size, const Integer &quantity) {
  if (size <= 0 || quantity < 1)
    throw InputError("the sample has a size or a quantity that is not above 0: leave it out");
  state_->verifier.particles().add(RootSize{size}, quantity);
}

void SampleVerifier::read(std::istream &particles, const std::string &file, std::optional<SizeUnit> unit) {
  Verifier &verifier = state_->verifier;
  ParticleOptions options = verifier.reading();
  options.unit = unit;
  ParticleReader reader(file, verifier.particles(), options);
  for (std::string line; std::getline(particles, line);)
    reader.line(line);
  if (particles.bad())
    throw InputError(printable(file) + ": it cannot be read: see whether it is a file");
  reader.end();
  verifier.note(reader.notes());
}

SampleVerdict SampleVerifier::verdict(const std::string &name) const {
  const Verification v = state_->verifier.verification(name);
  const Verdict verdict = v.verdict();
  const Description &d = v.description;
  const Gradation &g = d.gradation();
  SampleVerdict said{verdict == Verdict::undecided ? std::nullopt : std::optional(verdict == Verdict::match),
                     d.particles(),
                     d.outside(),
                     v.error.maximum,
                     {},
                     verification_json(v),
                     verification_text(v)};
  for (std::size_t j = 0; j < g.classes(); ++j)
    said.classes.push_back(
        {g.opening(j), g.opening(j + 1), d.of_class(j).count, v.error.targets[j], v.error.shares[j]});
  return said;
}

} // namespace mdm
