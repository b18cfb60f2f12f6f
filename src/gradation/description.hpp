#pragma once
/// \file
/// A gradation G as the description of a sample S: the paper's conditions and its Error.

#include "gradation/sample.hpp"
#include "gradation/size_range.hpp"
#include "number/fraction_sum.hpp"

#include <mdm/gradation/gradation.hpp>
#include <mdm/gradation/mass_law.hpp>
#include <mdm/number/interval.hpp>

#include <optional>

namespace mdm {

/// The distance of a description from Cond4: the Error of Arnold, Eq. 13, class by class, target minus found.
/// t_j is the mass of the particles in class j, M the sum of all t_j. Numbers are exact where the law is
/// rational at the sizes; shares also where they are rational and few masses are incommensurable.
struct MatchError {
  std::vector<Interval> as_given;   ///< m_j - t_j
  std::vector<Rational> targets;    ///< m_j / sum m
  std::vector<Interval> shares;     ///< t_j / M; 0 where M = 0
  std::vector<Interval> normalised; ///< m_j / sum m - t_j / M
  std::size_t worst = 0;            ///< the finest class with the largest |normalised| (upper ends compared)
  Interval maximum;                 ///< largest |normalised|
  Interval total;                   ///< sum of |normalised|
};

/// The options of a description, beside G and S.
struct DescriptionOptions {
  MassLaw law;
  /// Sizes within snap * x_j of an opening x_j are taken as that opening: for sizes computed in double.
  Rational snap = 0;
  /// u^unit_power for the unit u in which masses are summed. Roots with a common irrational factor u are so
  /// summed exactly.
  Rational mass_unit = 1;
  unsigned unit_power = 1;
};

/// The particles of a sample, added one by one and counted class by class. Memory does not
/// depend on their number (as long as sizes are decimals of bounded length). Class j has x_j < x <= x_{j+1}:
/// a particle passes an opening of its own size. Since G is complete, Cond1 (Eq. 9) holds.
class Description {
public:
  /// Particles outside all classes, on one side.
  struct Outside {
    Integer count = 0;
    std::optional<RootSize> first; ///< the first that came
  };

  /// The particles of one class.
  struct Class {
    Integer count = 0;
    std::optional<RootSize> first;             ///< the first size that came
    std::optional<RootSize> second;            ///< one that differs from it
    std::optional<RootSize> least_hi, most_lo; ///< of the ranges that came; nothing without
    bool may_differ = false;                   ///< particles of ranges have several sizes, maybe
  };

  /// \throws InputError if snap is negative or makes neighbouring openings one
  explicit Description(Gradation g, DescriptionOptions options = {});
  Description(Gradation g, const Sample &sample, DescriptionOptions options = {});

  /// Adds particles of one size. Cost: a binary search, a power and an exact sum; a root of 4096 bits where
  /// the law is irrational at the size.
  /// \pre size > 0, quantity >= 1
  void add(const Rational &size, const Integer &quantity = 1) { add(RootSize{size, 1}, quantity); }
  void add(const RootSize &size, const Integer &quantity) { add(size, quantity, all_rows()); }
  void add(const Sample &sample);
  /// Adds particles of sizes in a range, each of its own maybe: what is then said holds for all such sizes.
  /// Cost: two binary searches and sums.
  /// \pre 0 <= lo, quantity >= 1, the options' mass_unit is 1
  void add(const SizeRange &size, const Integer &quantity) { add(size, quantity, all_rows()); }
  /// The same of a material, in whose classes alone its particles can be; where the gradation does not have
  /// it, they lie outside all classes.
  void add_of(const std::string &material, const RootSize &size, const Integer &quantity);
  void add_of(const std::string &material, const SizeRange &size, const Integer &quantity);

  /// Adds particles that are known by their mass, f(x), under a law by table or sum. \param near  a decimal
  /// next to their size, for reports
  /// \pre mass > 0, quantity >= 1
  void add_of_mass(const Rational &mass, const Rational &near, const Integer &quantity);

  const Gradation &gradation() const { return g_; }
  const MassLaw &law() const { return options_.law; }
  const Class &of_class(std::size_t j) const { return classes_[j].seen; }
  const Outside &below() const { return below_; } ///< x <= x_1
  const Outside &above() const { return above_; } ///< x > x_n
  /// Of materials that the gradation does not have; the name of the first that came.
  const Integer &foreign() const { return foreign_; }
  const std::string &foreign_material() const { return foreign_material_; }
  /// Particles in a range with an opening in it: none of the other counts has them.
  const Outside &unplaced() const { return unplaced_; }
  /// True if the size of every particle is known, and not its range alone.
  bool knows_sizes() const { return knows_sizes_; }
  /// N, particles outside all classes included.
  Integer particles() const;
  /// Particles whose size was taken as an opening, and was not that opening.
  const Integer &snapped() const { return snapped_; }
  /// Particles larger than an opening by at most 1e-12 of it: an error of rounding, it may be.
  const Integer &hair_above() const { return hair_above_; }

  /// Cond2 (Eq. 10): no particle lies outside all classes, of those whose class is known.
  bool describes() const { return outside() == 0; }
  /// All particles that lie outside all classes.
  Integer outside() const { return below_.count + above_.count + foreign_; }
  /// The finest class that certainly has particles of several sizes.
  std::optional<std::size_t> inarticulate_class() const;
  /// Cond3: Cond2, and an opening x_j with x_i <= x_j < x_{i+1} separates neighbouring sizes. (Eq. 11 has the
  /// two signs exchanged, against Eq. 12.)
  /// Nothing where ranges of sizes leave it open.
  std::optional<bool> articulately() const;

  /// The errors that Cond4 (Eq. 12) forbids. Cond4 holds iff Cond2 does and all `as_given` are 0; for one
  /// scale of the masses, iff Cond2 does and all `normalised` are 0. Cost: some fractions a class.
  MatchError error() const;

private:
  struct Tally {
    Class seen;
    std::vector<FractionSum> multiples = std::vector<FractionSum>(1); ///< of units_, their sum is the mass
    Integer roots = 0;        ///< sum of the masses left, each rounded down to a multiple of 2^-root_bits
    Integer rooted_count = 0; ///< number of these
    FractionSum least, most;  ///< masses of particles of which a range is known
    std::optional<Rational> first_mass; ///< of the first that is known by its mass
  };

  static void see(Class &seen, const RootSize &size, const Integer &quantity);
  static void see(Class &seen, const SizeRange &size, const Integer &quantity);
  void weigh(Tally &tally, const RootSize &size, const Integer &quantity);
  const MaterialRows *rows_of(const std::string &material, const Integer &quantity);
  void add(const RootSize &size, const Integer &quantity, const MaterialRows &of);
  void add(const SizeRange &size, const Integer &quantity, const MaterialRows &of);
  MaterialRows all_rows() const { return {"", 0, highest_.size()}; }
  std::size_t openings_below(const RootSize &size, const MaterialRows &of) const;
  Interval mass(const Tally &tally) const;
  std::vector<std::optional<Rational>> exact_shares() const;

  static void note(Outside &side, const RootSize &size, const Integer &quantity);

  Gradation g_;
  DescriptionOptions options_;
  std::vector<RootSize> lowest_, highest_; ///< sizes that are taken as each opening
  std::vector<RootSize> hair_beyond_;      ///< each opening and 1e-12 of it
  std::vector<Tally> classes_;
  std::vector<RootSize> units_ = {{1, 1}}; ///< of masses; none is a rational multiple of another
  Outside below_, above_, unplaced_;
  Integer foreign_ = 0;
  std::string foreign_material_;
  bool knows_sizes_ = true;
  Integer snapped_ = 0;
  Integer hair_above_ = 0;
};

} // namespace mdm
