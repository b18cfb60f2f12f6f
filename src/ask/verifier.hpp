#pragma once
/// \file
/// Whether a sample matches a gradation: what is asked, the sample as it comes in, and the verdict.

#include "ask/particle_options.hpp"
#include "ask/place_options.hpp"
#include "ask/solve_options.hpp"
#include "particles/description_sink.hpp"
#include "particles/placed_sink.hpp"
#include "particles/sample_certifier.hpp"
#include "report/allowed_error.hpp"
#include "report/verification.hpp"

#include <string>
#include <vector>

namespace mdm {

/// What is asked of a sample.
struct VerifyQuestion {
  Question question; ///< its law, pan, cut, size factor, tolerances and band; what else it has is not judged
  Rational snap = 0;
  unsigned digits = 6;
  ParticleTexts particles = {};
  PlaceTexts places = {};
};

/// The question in which shares are measured, for the report: what they may differ by is told apart.
Question measured(const Question &asked);

/// What is asked of a sample, as texts.
struct VerifyTexts {
  GradationTexts gradation;
  std::vector<std::string> tolerances;
  OptionText band, snap, digits; ///< band: the name of what the judge gets as an envelope
  ParticleTexts particles;
  PlaceTexts places;

  /// All but those of particles, places and gradation.
  static const std::vector<OptionRow<VerifyTexts>> options, answer_options;

  /// The question to a gradation. \throws InputError naming the option where its value does not serve
  VerifyQuestion question(const Gradation &g, const std::optional<Envelope> &envelope) const;
};

/// The judge of one sample, which is handed on to its sinks while it is read, or taken as an answer. One
/// thread at a time. Memory: that of the classes, and of the places that are kept.
class Verifier {
public:
  /// A certificate that is asked for, with the canonical sample that goes with it; without `begin` none does.
  struct AskedProof {
    SampleCertifier::Begin begin;
  };

  /// \param g  as it was read; its smallest match is found here
  /// \param source  names it in messages; empty: not
  /// \throws InputError naming the option where its value does not serve, or the gradation
  Verifier(Gradation g, const std::string &source, VerifyQuestion asked,
           const std::optional<AskedProof> &proof = std::nullopt);
  Verifier(const Verifier &) = delete;
  Verifier &operator=(const Verifier &) = delete;

  /// How particles are to be read.
  const ParticleOptions &reading() const { return reading_; }
  bool are_places_asked() const { return asked_.places.are_asked(); }
  SizeUnit unit() const { return gradation_.unit(); }
  /// The gradation that is asked about, after its cut and with its pan and factor.
  const Gradation &gradation() const { return gradation_; }
  const MassLaw &law() const { return asked_.question.law; }
  const Rational &snap() const { return asked_.snap; }

  /// Takes particles whose places, if they have some, are judged too.
  ParticleSink &particles() {
    has_particles_ = true;
    return placed_;
  }
  /// Takes sizes alone.
  ParticleSink &sizes() { return certifier_ ? static_cast<ParticleSink &>(*certifier_) : sizes_; }
  /// What the reader of particles() says at their end, or of the last of several timesteps.
  void end(const ReadParticles &read);
  /// Takes the notes that belong to what sizes() was given.
  void note(const std::vector<std::string> &notes) {
    notes_.insert(notes_.end(), notes.begin(), notes.end());
  }
  /// An answer in JSON instead of particles. \throws InputError where options say how particles are read
  void take_answer(const std::string &json, const std::string &file);

  /// The verdict. \param sample  its name
  /// \throws InputError naming the sample where its places are not what was asked about
  Verification verification(const std::string &sample) const;

  /// The certificate of what was verified, or why there is none.
  struct Proof {
    std::string text, missing;
  };
  /// \pre a certificate was asked for, and all particles are in
  /// \throws InputError if it is beyond the limits of the format
  Proof proof(const Verification &v);

private:
  VerifyQuestion asked_;
  Gradation gradation_;
  SmallestMatch smallest_;
  AllowedError allowed_;
  ParticleOptions reading_;
  DescriptionSink sizes_;
  std::optional<SampleCertifier> certifier_;
  PlacedSink placed_;
  bool has_particles_ = false;
  std::optional<SizeUnit> read_unit_;
  std::optional<Description> answer_;
  bool is_spread_ = false; ///< the answer
  std::vector<std::string> objections_, notes_;

  std::optional<SphereTexture> texture(std::vector<std::string> &notes) const;
};

} // namespace mdm
