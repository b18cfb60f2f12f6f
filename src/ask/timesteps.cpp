#include "ask/timesteps.hpp"

#include <algorithm>
#include <stdexcept>

namespace mdm {
namespace {

/// The same sieves with a pan below them, so that nothing is outside that passes them.
Gradation with_pan(const Gradation &g) {
  Gradation::Data data;
  data.unit = g.unit();
  data.root = g.root();
  data.sizes = g.powers();
  data.masses = g.masses();
  if (!g.has_pan()) {
    data.sizes.insert(data.sizes.begin(), 0);
    data.masses.insert(data.masses.begin(), 0);
  }
  return Gradation(std::move(data));
}

/// What passes each opening, of all that is not larger than the largest.
std::vector<Interval> passing(const Description &d) {
  std::vector<Interval> passed = {Interval(Rational(0))};
  for (const Interval &share : d.error().shares) {
    const Interval sum = passed.back() + share;
    passed.emplace_back(std::min(sum.lo, Rational(1)), std::min(sum.hi, Rational(1)));
  }
  return passed;
}

/// Bounds of what is known to some 60 digits.
Interval bounds(const RealRange &y) {
  constexpr unsigned bits = 256;
  const Ball lo = y.lo.ball(bits), hi = y.hi.ball(bits);
  return {lo.lower(), hi.upper()};
}

} // namespace

Timesteps::Timesteps(Verifier &verifier, const std::string &sample)
    : verifier_(verifier),
      sieved_(Description(with_pan(verifier.gradation()), {verifier.law(), verifier.snap(), 1, 1})),
      before_(with_pan(verifier.gradation())), report_{verifier.gradation(), sample} {}

void Timesteps::restart() {
  verifier_.particles().restart();
  sieved_.restart();
}

void Timesteps::begin_timestep(const Integer &number) {
  take_down();
  restart();
  timestep_ = number;
}

void Timesteps::add(const RootSize &diameter, const Integer &quantity) {
  verifier_.particles().add(diameter, quantity);
  sieved_.add(diameter, quantity);
}

void Timesteps::add(const SizeRange &diameter, const Integer &quantity) {
  verifier_.particles().add(diameter, quantity);
  sieved_.add(diameter, quantity);
}

void Timesteps::add_at(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) {
  verifier_.particles().add_at(place, unit, diameter);
  sieved_.add(diameter, 1);
}

void Timesteps::add_notes(const std::vector<std::string> &notes) {
  for (const std::string &note : notes)
    if (std::find(report_.notes.begin(), report_.notes.end(), note) == report_.notes.end())
      report_.notes.push_back(note);
}

void Timesteps::take_down() {
  if (!timestep_)
    return;
  const Verification v = verifier_.verification(report_.sample);
  report_.digits = v.digits;
  TimestepState s;
  s.timestep = *timestep_;
  s.verdict = v.verdict();
  s.headline = headline(v);
  s.particles = v.description.particles();
  s.below = v.description.below().count;
  s.above = v.description.above().count;
  const std::vector<Rational> &masses = report_.gradation.masses();
  const auto finest = std::find_if(masses.begin(), masses.end(), [](const Rational &m) { return m > 0; });
  s.finest = v.description.of_class(static_cast<std::size_t>(finest - masses.begin())).count;
  s.shares = v.error.shares;
  s.maximum_error = v.error.maximum;
  s.total_error = v.error.total;
  s.packing = v.packing;
  const Breakage broken = breakage(before_, passing(sieved_.description()));
  add_notes(v.notes);
  if (broken.hardin)
    s.hardin = bounds(*broken.hardin);
  else
    add_notes({"B_r of Hardin is not available: " + broken.hardin.why().reason + "."});
  if (broken.einav)
    s.einav = bounds(*broken.einav);
  else
    add_notes({"B of Einav is not available: " + broken.einav.why().reason + "."});
  report_.states.push_back(std::move(s));
}

TimestepsReport Timesteps::report(const ReadParticles &read) {
  verifier_.end(read);
  take_down();
  if (report_.states.empty())
    throw std::logic_error("a file of timesteps had none");
  return report_;
}

} // namespace mdm
