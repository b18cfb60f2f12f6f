#pragma once
/// \file
/// What the rows of a sample say of its shares, as proofs/certificate-format.md, section 12, derives it.

#include <mdm/gradation/gradation.hpp>
#include <mdm/gradation/mass_law.hpp>
#include <mdm/number/interval.hpp>

#include <array>
#include <string_view>
#include <vector>

namespace mdm {

/// Particles of a sample, each of a size whose N-th power is from lo to hi, above lo if that is open.
struct SampleRow {
  Rational lo, hi;
  Integer quantity = 1;
  bool is_open = false;
};

/// What follows of the rows of a sample.
struct SampleFindings {
  Integer particles = 0, below = 0, above = 0, unplaced = 0;
  std::vector<Integer> counts;
  std::vector<Interval> shares, passing;              ///< of each class, and of what passes its upper opening
  std::vector<Interval> share_errors, passing_errors; ///< the latter but for the last class
  Interval total;                                     ///< sum of the shares' errors
  std::array<std::string_view, 4> conditions;         ///< yes, no or open
};

/// Counts the rows of a sample into the classes of a gradation, with bounds of their masses (Theorem 23).
/// Memory does not depend on their number.
class SampleTally {
public:
  /// \param g  with the question's changes
  /// \param N  the power of sizes that rows have
  /// \throws InputError where the limits of the format are passed
  SampleTally(const Gradation &g, const MassLaw &law, unsigned N);

  /// \pre 0 <= lo <= hi, hi > 0, quantity >= 1; lo < hi if it is open
  /// \throws InputError likewise
  void add(const SampleRow &row);

  /// Decimal places that masses are enclosed to; nothing where all of them are exact.
  std::optional<unsigned> places() const;
  /// \throws InputError likewise
  SampleFindings findings() const;

private:
  /// A sum of fractions, and of multiples of 10^-places.
  struct Sum {
    Integer numerator = 0, denominator = 1, places = 0;
  };
  /// w(z): a fraction, or from `places` to 1 more, times 10^-places.
  struct Mass {
    std::optional<Rational> exact;
    Integer places;
  };
  struct Class {
    Integer count = 0;
    Sum least, most;
    Rational least_lo, most_lo, least_hi, most_hi; ///< of the rows; 0 without particles
  };

  std::size_t openings_below(const Rational &z, bool or_at) const;
  Mass mass(const Rational &z);
  static void add(Sum &sum, const Mass &mass, const Integer &quantity, bool upper);
  static void see(Class &seen, const SampleRow &row);
  Interval mass_of_class(std::size_t j) const;
  void check_work() const;
  void find_shares(SampleFindings &f) const;
  void find_errors(SampleFindings &f) const;
  void find_conditions(SampleFindings &f) const;

  Gradation g_;
  unsigned exponent_, root_, places_; ///< a/g, e and P of the format
  Integer unit_of_places_;
  std::vector<Rational> openings_; ///< Y_j^N
  std::size_t opening_bits_ = 0, longest_ = 0;
  std::uint64_t rows_ = 0;
  Integer common_ = 1; ///< denominator of all exact masses
  Rational unit_ = 1;
  std::vector<Class> classes_;
  Integer below_ = 0, above_ = 0, unplaced_ = 0;
  bool may_be_outside_ = false;
};

} // namespace mdm
