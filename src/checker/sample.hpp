#pragma once

#include "gradation.hpp"
#include "sample_certificate.hpp"
#include "sample_file.hpp"
#include "verify.hpp"

#include <vector>

namespace mdm::checker {

/// A number that is known to lie from lo to hi.
struct Enclosed {
  mpq_class lo, hi;
};

/// The mass w(z) of particles of section 12: exactly, or from places times 10^-P to one such more.
class SampleMass {
public:
  /// \param N  the power of sizes that rows have
  SampleMass(const Certificate &question, unsigned long N, unsigned long places);

  struct Mass {
    bool is_exact;
    mpq_class exact;
    mpz_class places; ///< where it is not exact
  };
  /// \param z  of the first row: hi; it is the unit where masses can be irrational
  Mass of(const mpq_class &z, const mpq_class &unit) const;
  /// The bits that a number of h bits makes (limit 1).
  std::uint64_t bits_of(std::uint64_t h) const { return 2 * h * exponent_ + std::uint64_t{4} * e_ * places_; }
  /// e of section 12.
  unsigned long root() const { return e_; }
  const mpz_class &unit_of_places() const { return ten_to_places_; }

private:
  unsigned long exponent_, e_, places_;
  mpz_class ten_to_places_;
};

/// A sum of fractions over one denominator.
class FractionSum {
public:
  void add(const mpq_class &value, const mpz_class &times);
  mpq_class value() const;

private:
  mpz_class numerator_ = 0, denominator_ = 1;
};

/// The rows of a sample in their classes. Memory does not depend on their number.
class SampleTally {
public:
  /// \param gradation  with the question's changes
  SampleTally(const Gradation &gradation, const SampleCertificate &certificate, unsigned long N);

  /// Throws Malformed where limits are passed.
  void add(const SampleRow &row);

  /// The rows of one class, and what bounds its mass without its factor.
  struct Class {
    mpz_class count = 0;
    FractionSum least, most;
    mpz_class least_places = 0, most_places = 0;
    mpq_class least_lo, most_lo, least_hi, most_hi; ///< of the rows; none without particles
  };
  const std::vector<Class> &classes() const { return classes_; }
  const mpz_class &below() const { return below_; }
  const mpz_class &above() const { return above_; }
  const mpz_class &unplaced() const { return unplaced_; }
  bool may_be_outside() const { return may_be_outside_; } ///< some that are unplaced
  mpz_class particles() const;
  const SampleMass &mass() const { return mass_; }

private:
  std::size_t openings_below(const mpq_class &z, bool or_at) const;
  void limit_row(const SampleRow &row);
  void limit_rows() const;
  static void see(Class &in, const SampleRow &row);
  SampleMass::Mass weighed(const mpq_class &z);

  unsigned long root_;
  const Certificate &question_;
  SampleMass mass_;
  Rationals openings_; ///< Y_j^N
  std::uint64_t opening_bits_ = 0, longest_ = 0, rows_ = 0;
  mpz_class common_ = 1; ///< denominator of all exact masses
  mpq_class unit_ = 0;
  std::vector<Class> classes_;
  mpz_class below_ = 0, above_ = 0, unplaced_ = 0;
  bool may_be_outside_ = false;
};

/// Verifies what the certificate says of the sample. Throws Refused at the first thing that fails, Malformed
/// where limits are passed.
void verify_sample(const Gradation &gradation, const SampleCertificate &certificate,
                   const SampleTally &tally);

} // namespace mdm::checker
