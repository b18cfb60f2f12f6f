// Numbers of particles by the paper's method (Voivret, Delenne, Radjai, Eq. 7-9). What comes in are size
// classes with shares f_v and the least number N_pc; what goes out is N_j = floor(N_pc n_j / min n) for n =
// f_v / V(median size), raised in proportion where the sum is below N_min.
//
// Floors are decisions: a count next to an integer is refined, and where refining leaves two integers the
// field of the bounds (Surd) says whether it is exactly the upper one, to the power D - 1 so that no second
// root comes in. Which class is the scarcest is a decision as well; several that 4096 bits do not tell
// apart are all tried, and a count is given only if they agree.

#include "sets/class_counts.hpp"

#include <mdm/number/interval.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

constexpr unsigned most_count_digits = 1000;

/// n^p up to a constant, p = D - 1: f_v^p / (d_m^p)^D.
Real amount(const SizeClass &c, unsigned dimension) {
  return pow(c.volume_fraction, Rational(dimension - 1)) /
         pow(median_power(c, dimension), Rational(dimension));
}

/// The same in the field of the bounds, where it is known there.
std::optional<Surd> exact_amount(const SizeClass &c, const ModelCurve &curve, unsigned dimension) {
  if (!c.lower.exact || !c.upper.exact)
    return std::nullopt;
  const unsigned p = dimension - 1;
  const Surd &l = *c.lower.exact, &u = *c.upper.exact;
  const std::optional<Rational> fraction = c.volume_fraction.exact();
  const std::optional<Surd> f = fraction ? Surd(*fraction) : curve.exact_between(l, u);
  if (!f)
    return std::nullopt;
  const Surd inverse_median =
      (power(l, p) + power(u, p)) * inverse(power(l, p)) * inverse(power(u, p)) * Surd(ratio(1, 2));
  return power(*f, p) * power(inverse_median, dimension);
}

/// Computes the counts of one curve.
class Counting {
public:
  Counting(const std::vector<SizeClass> &classes, const ModelCurve &curve, const Representativity &wanted)
      : classes_(classes), curve_(curve), wanted_(wanted) {
    for (std::size_t j = 0; j < classes.size(); ++j)
      if (!classes[j].is_empty()) {
        if (compare(classes[j].volume_fraction, 0) != Order::greater)
          throw InputError("the volume fraction of class " + std::to_string(j + 1) +
                           " is too small to be told from 0: use fewer classes or a wider curve");
        filled_.push_back(j);
      }
    if (filled_.empty())
      throw InputError("no class has volume: use other classes");
    amounts_.resize(classes.size(), Real(0));
    least_.resize(classes.size());
    for (const std::size_t j : filled_) {
      amounts_[j] = amount(classes[j], wanted.dimension);
      least_[j] = least_in_class(classes[j], wanted);
    }
  }

  ClassCounts run() {
    ClassCounts counts;
    const std::vector<std::size_t> least = scarcest();
    counts.scarcest = least.front();
    counts.estimate.resize(classes_.size());
    for (const std::size_t j : filled_) {
      IntegerBounds &bounds = counts.estimate[j];
      bounds = estimate(j, least.front());
      for (std::size_t i = 1; i < least.size(); ++i) {
        const IntegerBounds other = estimate(j, least[i]);
        bounds = {std::min(bounds.lo, other.lo), std::max(bounds.hi, other.hi)};
      }
    }
    if (std::all_of(counts.estimate.begin(), counts.estimate.end(),
                    [](const auto &n) { return n.is_point(); }))
      set_numbers(counts);
    return counts;
  }

private:
  /// The class with the least n for what it is to get; with it those that 4096 bits do not tell from it.
  std::vector<std::size_t> scarcest() const {
    const auto rest = [this](std::size_t j) {
      return amounts_[j] / Real(Rational(power(least_[j], wanted_.dimension - 1)));
    };
    std::vector<std::size_t> least;
    for (const std::size_t j : filled_) {
      const Order order = least.empty() ? Order::less : compare(rest(j), rest(least.front()));
      if (order == Order::less)
        least = {j};
      else if (order == Order::undecided)
        least.push_back(j);
    }
    return least;
  }

  IntegerBounds estimate(std::size_t j, std::size_t least) const {
    if (j == least)
      return {least_[j], least_[j]};
    const unsigned p = wanted_.dimension - 1;
    const Real quotient = amounts_[j] / amounts_[least];
    const Real n = Real(Rational(least_[least])) * (p == 1 ? quotient : pow(quotient, ratio(1, p)));
    check_length(n);
    const IntegerBounds bounds = floor_of(n, [&](const Integer &k) { return is_exactly(j, least, k); });
    // n over what the class is to get is not below that of the scarcest class.
    return {std::max(bounds.lo, least_[j]), std::max(bounds.hi, least_[j])};
  }

  /// True if c n_j = k n_least, c being what the scarcest gets, which is decided to the power p.
  bool is_exactly(std::size_t j, std::size_t least, const Integer &k) const {
    const unsigned p = wanted_.dimension - 1;
    const std::optional<Surd> a = exact_amount(classes_[j], curve_, wanted_.dimension);
    const std::optional<Surd> b = a ? exact_amount(classes_[least], curve_, wanted_.dimension) : std::nullopt;
    if (!b)
      return false;
    const Surd difference = Surd(Rational(power(least_[least], p))) * *a - Surd(Rational(power(k, p))) * *b;
    return difference.exact() == Rational(0);
  }

  void check_length(const Real &n) const {
    static const Rational most(power_of_ten(most_count_digits));
    if (compare(n, Real(most)) != Order::less)
      throw TooManyParticles(
          "a class would need more than 10^1000 particles: use fewer or isochoric classes, "
          "or a curve with more volume at its ends");
  }

  void set_numbers(ClassCounts &counts) const {
    const Integer sum = counts.estimated().lo;
    for (const IntegerBounds &n : counts.estimate)
      counts.numbers.push_back(sum < wanted_.at_least ? floor_div(wanted_.at_least * n.lo, sum) : n.lo);
  }

  const std::vector<SizeClass> &classes_;
  const ModelCurve &curve_;
  const Representativity &wanted_;
  std::vector<std::size_t> filled_;
  std::vector<Real> amounts_;
  std::vector<Integer> least_; ///< what each class is to get
};

} // namespace

IntegerBounds ClassCounts::estimated() const {
  IntegerBounds sum{0, 0};
  for (const IntegerBounds &n : estimate) {
    sum.lo += n.lo;
    sum.hi += n.hi;
  }
  return sum;
}

Integer ClassCounts::particles() const {
  Integer sum = 0;
  for (const Integer &n : numbers)
    sum += n;
  return sum;
}

Real median_power(const SizeClass &c, unsigned dimension) {
  const Rational p = dimension - 1;
  const Real l = pow(c.lower.real, p), u = pow(c.upper.real, p);
  return Real(2) * l * u / (l + u);
}

Integer least_in_class(const SizeClass &c, const Representativity &wanted) {
  if (!wanted.largest_share)
    return wanted.min_per_class;
  const unsigned p = wanted.dimension - 1;
  const Real times = pow(c.upper.real, Rational(p)) / median_power(c, wanted.dimension);
  const Real needed = pow(times, ratio(wanted.dimension, p)) / Real(*wanted.largest_share);
  const std::optional<Rational> exact = needed.fraction();
  return std::max(wanted.min_per_class, exact ? ceil(*exact) : Integer(floor_of(needed).hi + 1));
}

ClassCounts class_counts(const std::vector<SizeClass> &classes, const ModelCurve &curve,
                         const Representativity &wanted) {
  return Counting(classes, curve, wanted).run();
}

Real rounding_cost(const std::vector<SizeClass> &classes, const ClassCounts &counts, unsigned dimension) {
  assert(counts.decided());
  std::vector<Real> volumes;
  for (std::size_t j = 0; j < classes.size(); ++j)
    volumes.push_back(counts.numbers[j] == 0
                          ? Real(0)
                          : Real(Rational(counts.numbers[j])) *
                                pow(median_power(classes[j], dimension), ratio(dimension, dimension - 1)));
  return Real([volumes, classes](unsigned bits) {
    std::vector<Ball> of;
    Ball total(0, bits);
    for (const Real &volume : volumes) {
      of.push_back(volume.ball(bits));
      total = total + of.back();
    }
    Interval worst = Rational(0);
    for (std::size_t j = 0; j < of.size(); ++j) {
      const Ball error = of[j] / total - classes[j].volume_fraction.ball(bits);
      if (!error.is_finite())
        return error;
      worst = greater(worst, absolute({error.lower(), error.upper()}));
    }
    return hull(Ball(worst.lo, bits), Ball(worst.hi, bits));
  });
}

std::optional<bool> is_accessible(const ClassCounts &counts, const Representativity &wanted,
                                  const Integer &at_most) {
  const IntegerBounds sum = counts.estimated();
  if (std::max(sum.hi, wanted.at_least) <= at_most)
    return true;
  if (std::max(sum.lo, wanted.at_least) > at_most)
    return false;
  return std::nullopt;
}

} // namespace mdm
