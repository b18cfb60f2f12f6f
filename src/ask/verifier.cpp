#include "ask/verifier.hpp"

#include "answer/answer_sample.hpp"
#include "ask/option_values.hpp"
#include "gradation/likelier_unit.hpp"
#include "particles/unasked_texture.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <stdexcept>

namespace mdm {
namespace {

/// Calls action() and names whose mistake it is in what it throws.
template <class Action>
auto about(const std::string &source, Action action) {
  try {
    return action();
  } catch (const InputError &e) {
    throw InputError(source.empty() ? e.what() : printable(source) + ": " + e.what());
  }
}

/// What is wrong with the options about places is found before a file is read.
VerifyQuestion checked(VerifyQuestion asked, SizeUnit unit) {
  asked.places.check();
  asked.places.space(std::nullopt, unit);
  return asked;
}

/// What a certificate states.
Question certified_question(const VerifyQuestion &asked) {
  if (asked.snap > 0)
    throw InputError(option("snap") + ": a certificate is of sizes as they are: leave it out, or " +
                     option("proof"));
  return asked.question;
}

/// A note where the sizes may have another unit.
std::optional<std::string> unit_note(const Description &d, const std::optional<SizeUnit> &unit) {
  const std::optional<SizeUnit> other = unit ? likelier_unit(d, *unit) : std::nullopt;
  if (!other)
    return std::nullopt;
  return fmt::format("The sizes were read in {}, and no particle lies in a class (the pan's aside); in "
                     "{} the first would: say so by {}, or in the header that names the unit.",
                     name(*unit), name(*other), option("size-unit"));
}

} // namespace

const std::vector<OptionRow<VerifyTexts>> VerifyTexts::options = {
    {"tolerance", "WHICH", OptionKind::tolerances,
     "what shares may differ by: retained:1% or 1% (percentage points, of each class), passing:0.5%, "
     "total:1%, retained:file, passing:file, laboratory, rounding; none is 0; may be repeated, and all hold",
     &VerifyTexts::tolerances},
    {"band", "FILE", OptionKind::file, "what passes lies within the envelope in FILE, as for solve",
     &VerifyTexts::band},
    {"snap", "EPS", OptionKind::number,
     "take a size within EPS times an opening of it as that opening (0), for sizes computed in double: "
     "1e-12",
     &VerifyTexts::snap}};

const std::vector<OptionRow<VerifyTexts>> VerifyTexts::answer_options = {
    {"digits", "D", OptionKind::number, "significant digits of percents (6)", &VerifyTexts::digits}};

Question measured(const Question &asked) {
  Question q;
  q.law = asked.law;
  q.pan_size = asked.pan_size;
  q.cut_below = asked.cut_below;
  q.size_factor = asked.size_factor;
  return q;
}

VerifyQuestion VerifyTexts::question(const Gradation &g, const std::optional<Envelope> &envelope) const {
  VerifyQuestion q;
  if (snap)
    q.snap = not_negative("snap", *snap);
  if (digits)
    q.digits = digits_of("digits", *digits);
  q.question = gradation.question().of(g);
  for (const std::string &text : tolerances)
    q.question.tolerances.push_back(named("tolerance", text, parse_tolerance));
  q.question.band = envelope;
  q.particles = particles;
  q.places = places;
  return q;
}

Verifier::Verifier(Gradation g, const std::string &source, VerifyQuestion asked,
                   const std::optional<AskedProof> &proof)
    : asked_(checked(std::move(asked), g.unit())),
      gradation_(about(source, [&] { return asked_gradation(std::move(g), asked_.question); })),
      smallest_(about(source, [&] { return smallest_match(gradation_, asked_.question.law); })),
      allowed_(about(source,
                     [&] {
                       const Question &q = asked_.question;
                       return allowed_error(gradation_, q.tolerances, q.band, q.size_factor);
                     })),
      reading_(asked_.particles.reading(gradation_.unit())),
      sizes_(Description(gradation_, {asked_.question.law, asked_.snap, 1, 1})),
      certifier_(proof ? std::optional<SampleCertifier>(std::in_place, gradation_, certified_question(asked_),
                                                        proof->begin, &sizes_)
                       : std::nullopt),
      placed_(gradation_, sizes(), are_places_asked() ? std::nullopt : std::optional(most_unasked_places),
              [this](const std::optional<ParticleBox> &box) { return asked_.places.space(box, unit()); }) {
  const std::optional<Envelope> &band = asked_.question.band;
  if (const std::optional<std::string> why = band ? contradiction(*band) : std::nullopt)
    note({"The band contradicts itself: " + *why + "."});
}

void Verifier::end(const ReadParticles &read) {
  read_unit_ = read.unit;
  note(read.notes);
}

void Verifier::take_answer(const std::string &json, const std::string &file) {
  const AnswerSample answer = read_answer(json, file);
  about(file, [&] {
    if (asked_.particles.say_sizes() || asked_.particles.timestep)
      throw InputError("an answer of mdm says what its sizes are: leave out " + option("radius") + ", " +
                       option("diameter") + ", " + option("size-unit") + " and " + option("timestep"));
    AnswerDescription described = describe_answer(answer, gradation_, asked_.question.law, asked_.snap);
    if (certifier_)
      for (const auto &[size, quantity] : described.particles)
        certifier_->add(size, quantity);
    is_spread_ = described.is_spread;
    answer_ = std::move(described.description);
    objections_ = std::move(described.objections);
    note(described.notes);
  });
}

std::optional<SphereTexture> Verifier::texture(std::vector<std::string> &notes) const {
  if (!has_particles_) {
    if (are_places_asked())
      throw InputError("it has no places of particles: leave out " + option("packing") +
                       " and the options about places");
    return std::nullopt;
  }
  const SphereTextureOptions options = asked_.places.texture(placed_.box(), unit());
  if (are_places_asked() && placed_.sample().is_of_discs())
    throw InputError("all centres are in a plane, as of discs, and a packing is of spheres: leave out " +
                     option("packing") + " and the options about places");
  return are_places_asked()
             ? sphere_texture(placed_.sample(), gradation_.classes(), options)
             : unasked_texture(placed_, gradation_.classes(), options, option("packing").c_str(), notes);
}

Verification Verifier::verification(const std::string &sample) const {
  Verification v(answer_ ? *answer_ : sizes_.description(), measured(asked_.question), allowed_.most);
  v.bounds = allowed_.bounds;
  v.within = allowed_.within;
  v.smallest = smallest_;
  v.sample = sample;
  v.digits = asked_.digits;
  v.objections = objections_;
  v.notes = gradation_.notes();
  v.notes.insert(v.notes.end(), notes_.begin(), notes_.end());
  v.packing = about(sample, [&] { return texture(v.notes); });
  if (std::optional<std::string> objection = placed_.objection(option("periodic").c_str()))
    v.objections.push_back(std::move(*objection));
  if (const std::optional<std::string> note = unit_note(v.description, read_unit_))
    v.notes.push_back(*note);
  if (!answer_ && v.description.hair_above() > 0)
    v.notes.push_back(
        fmt::format("Particles larger than a sieve by less than 1e-12 of it: {}; {} 1e-12 takes "
                    "sizes as near as that as the sieve.",
                    to_string(v.description.hair_above()), option("snap")));
  return v;
}

Verifier::Proof Verifier::proof(const Verification &v) {
  const std::optional<CertifiedSample> made = certifier_->certified();
  if (!v.objections.empty())
    return {"", v.objections.front()};
  if (is_spread_)
    return {"",
            "the answer is a spread, of which certificates say nothing: verify what mdm export --spread --to "
            "csv writes"};
  const Verdict verdict = v.verdict();
  if (verdict == Verdict::undecided)
    return {"", v.description.knows_sizes()
                    ? "4096 bits do not tell whether it matches"
                    : "the ranges that are known of the sizes do not tell whether it matches"};
  if (!made)
    return {
        "",
        "the enclosures of the shares that certificates have, of ranges or of an irrational law, do not tell "
        "whether it matches"};
  if (made->matches != (verdict == Verdict::match))
    throw std::logic_error("certificate and verdict differ: please report this file");
  return {made->text, ""};
}

} // namespace mdm
