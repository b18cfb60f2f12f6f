#include "match/smallest_match.hpp"
#include "particles/description_sink.hpp"
#include "report/allowed_error.hpp"
#include "report/verification.hpp"

#include <mdm/ask/verify.hpp>
#include <mdm/text/error.hpp>

#include <istream>

namespace mdm {

struct SampleVerifier::State {
  State(const Gradation &given, const Question &asked)
      : question(asked), g(asked_gradation(given, asked)),
        allowed(allowed_error(g, asked.tolerances, asked.band, asked.size_factor)),
        sizes(Description(g, {asked.law, 0, 1, 1})) {}

  Question question;
  Gradation g;
  AllowedError allowed;
  DescriptionSink sizes;
  std::vector<std::string> notes;
};

SampleVerifier::SampleVerifier(const Gradation &g, const Question &asked)
    : state_(std::make_shared<State>(g, asked)) {}

void SampleVerifier::add(const Rational &size, const Integer &quantity) {
  if (size <= 0 || quantity < 1)
    throw InputError("the sample has a size or a quantity that is not above 0: leave it out");
  state_->sizes.add(RootSize{size}, quantity);
}

void SampleVerifier::read(std::istream &particles, const std::string &file, std::optional<SizeUnit> unit) {
  ParticleOptions options;
  options.target = state_->g.unit();
  if (unit)
    options.unit = length_unit(*unit);
  ParticleReader reader(file, state_->sizes, options);
  for (std::string line; std::getline(particles, line);)
    reader.line(line);
  if (particles.bad())
    throw InputError(printable(file) + ": it cannot be read: see whether it is a file");
  reader.end();
  const std::vector<std::string> notes = reader.notes();
  state_->notes.insert(state_->notes.end(), notes.begin(), notes.end());
}

SampleVerdict SampleVerifier::verdict(const std::string &name) const {
  const State &s = *state_;
  Verification v(s.sizes.description(), s.question, s.allowed.most);
  v.bounds = s.allowed.bounds;
  v.within = s.allowed.within;
  v.smallest = smallest_match(s.g, s.question.law);
  v.sample = name;
  v.notes = s.g.notes();
  v.notes.insert(v.notes.end(), s.notes.begin(), s.notes.end());
  const Verdict verdict = v.verdict();
  const Description &d = v.description;
  SampleVerdict said{verdict == Verdict::undecided ? std::nullopt : std::optional(verdict == Verdict::match),
                     d.particles(),
                     d.below().count + d.above().count,
                     v.error.maximum,
                     {},
                     verification_json(v),
                     verification_text(v)};
  for (std::size_t j = 0; j < s.g.classes(); ++j)
    said.classes.push_back(
        {s.g.opening(j), s.g.opening(j + 1), d.of_class(j).count, v.error.targets[j], v.error.shares[j]});
  return said;
}

} // namespace mdm
