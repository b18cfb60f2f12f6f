#pragma once
/// \file
/// Particles on their way into a certificate.

#include "particles/particle_reader.hpp"
#include "proof/sample_certificate.hpp"
#include "text/sink.hpp"

#include <functional>
#include <optional>
#include <string>

namespace mdm {

/// Tallies particles for a certificate, and writes them as the canonical sample that the
/// checker reads (proofs/certificate-format.md, section 12).
class SampleCertifier : public ParticleSink {
public:
  /// Begins a new canonical sample, and gives what its text goes to.
  using Begin = std::function<Sink()>;

  /// \param g  with the question's changes
  /// \param begin  empty: the canonical sample is there
  /// \param next  takes the particles as well, if there is one, and must outlive the certifier
  SampleCertifier(Gradation g, Question question, Begin begin, ParticleSink *next = nullptr);

  void restart() override;
  /// \throws InputError where the format has no place for the particles
  void add(const RootSize &diameter, const Integer &quantity) override;
  void add(const SizeRange &diameter, const Integer &quantity) override;

  /// Writes the rest of the sample; the certificate, or nothing where it is open whether the sample matches.
  /// \pre there was a particle
  /// \throws InputError as certified_sample
  std::optional<CertifiedSample> certified();

private:
  void add_row(const SampleRow &row, bool is_range, unsigned power);
  void begin_rows(bool is_range, unsigned power);
  std::string text(const Rational &size) const;
  void write(const SampleRow &row);

  Gradation g_;
  Question question_;
  Begin begin_;
  ParticleSink *next_;
  std::optional<SampleTally> tally_; ///< open before the first row
  bool has_ranges_ = false;
  unsigned power_ = 1; ///< of all sizes
  Sink sink_;
  std::string waiting_; ///< to be written with more
};

/// Tells whether a text, given in pieces, is a canonical sample, which the checker reads as it is.
class CanonicalSampleTest {
public:
  /// Takes the next piece. Returns false where the text is certainly none.
  bool take(std::string_view piece);
  /// True if all of it was one.
  bool is_canonical() const { return is_canonical_ && lines_ > 1 && line_.empty(); }

private:
  bool take_line(std::string_view line);

  bool is_canonical_ = true, has_range_ = false, has_quantity_ = false, has_power_ = false;
  std::string line_; ///< of which the end is still to come
  std::uint64_t lines_ = 0;
};

} // namespace mdm
