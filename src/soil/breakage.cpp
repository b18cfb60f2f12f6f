// Both measures are quotients of areas over log size, between curves that are linear there: sums of trapezes,
// one for each two sieves, with logarithms of quotients of sieves as widths. The areas of what broke grow
// with each share that passes, so the lower ends of all shares give the lower bound, and the upper ends the
// upper one.

#include "soil/breakage.hpp"

#include <cassert>

namespace mdm {
namespace {

/// The natural logarithm of b / a.
Real log_of(const PowerProduct &a, const PowerProduct &b) {
  const PowerProduct quotient = b / a;
  return Real([quotient](unsigned bits) { return log(quotient, bits); });
}

/// Points of two curves over sizes above 0, ascending: what passed before, and what passes now.
struct Curves {
  std::vector<PowerProduct> sizes;
  std::vector<Real> before, now;

  std::size_t points() const { return sizes.size(); }
  Real width(std::size_t i) const { return log_of(sizes[i], sizes[i + 1]); }
};

/// The sum over all strips of width times the mean of height(i) at both sides.
template <class Height>
Real area(const Curves &c, Height height) {
  Real sum = 0;
  for (std::size_t i = 0; i + 1 < c.points(); ++i)
    sum = sum + c.width(i) * (height(i) + height(i + 1)) * Rational(1, 2);
  return sum;
}

Real broken(const Curves &c) {
  return area(c, [&c](std::size_t i) { return c.now[i] - c.before[i]; });
}

/// The index of the first opening above 0.
std::size_t first_sieve(const GradingCurve &curve) {
  return curve.has_pan() ? 1 : 0;
}

/// The curves from the finest sieve on. \param side  the end of each share that counts
Curves from_finest(const GradingCurve &before, const std::vector<Interval> &passing,
                   Rational Interval::*side) {
  Curves c;
  for (std::size_t i = first_sieve(before); i < passing.size(); ++i) {
    c.sizes.push_back(before.power_of(i));
    c.before.emplace_back(before.shares()[i]);
    c.now.emplace_back(passing[i].*side);
  }
  return c;
}

/// Index of the first of the sizes that is not below `size`.
std::size_t first_not_below(const GradingCurve &before, const Rational &size) {
  std::size_t i = first_sieve(before);
  while (i < before.shares().size() && compare(before.opening(i), RootSize{size}) < 0)
    ++i;
  return i - first_sieve(before);
}

const Rational finest_counted(74, 1000); // mm

/// The curves from 0.074 mm on; there it is taken that `finer` passes now, where the finest sieve is above.
Curves from_hardins_size(const GradingCurve &before, Curves c, const Rational &finer) {
  const std::size_t first = first_not_below(before, finest_counted);
  const PowerProduct from(finest_counted);
  if (first == 0) {
    const bool is_sieve = compare(before.opening(first_sieve(before)), RootSize{finest_counted}) == 0;
    if (is_sieve)
      return c;
    // Below the finest sieve the curve is taken to be level: two points there, of which the upper has no
    // width.
    c.sizes.insert(c.sizes.begin(), {from, c.sizes.front()});
    c.before.insert(c.before.begin(), {Real(0), Real(0)});
    c.now.insert(c.now.begin(), {Real(finer), Real(finer)});
    return c;
  }
  const Real place = log_of(c.sizes[first - 1], from) / c.width(first - 1);
  const auto at = [&](const std::vector<Real> &y) {
    return y[first - 1] + place * (y[first] - y[first - 1]);
  };
  Curves cut;
  const auto rest = static_cast<std::ptrdiff_t>(first);
  cut.sizes.assign(c.sizes.begin() + rest, c.sizes.end());
  cut.before.assign(c.before.begin() + rest, c.before.end());
  cut.now.assign(c.now.begin() + rest, c.now.end());
  const Real passed = at(c.before), passes = at(c.now);
  cut.sizes.insert(cut.sizes.begin(), from);
  cut.before.insert(cut.before.begin(), passed);
  cut.now.insert(cut.now.begin(), passes);
  return cut;
}

Real hardin(const GradingCurve &before, const std::vector<Interval> &passing, Rational Interval::*side) {
  const Rational finer = side == &Interval::hi ? passing[first_sieve(before)].hi : Rational(0);
  const Curves c = from_hardins_size(before, from_finest(before, passing, side), finer);
  return broken(c) / area(c, [&c](std::size_t i) { return Real(1) - c.before[i]; });
}

Available<RealRange> hardin(const GradingCurve &before, const std::vector<Interval> &passing) {
  const std::size_t finest = first_sieve(before);
  if (before.shares()[finest] > 0 && compare(before.opening(finest), RootSize{finest_counted}) > 0)
    return NotAvailable{"what passed the finest sieve at the beginning is not known down to 0.074 mm"};
  if (compare(before.opening(before.coarsest() + 1), RootSize{finest_counted}) <= 0)
    return NotAvailable{"nothing was coarser than 0.074 mm at the beginning"};
  return RealRange{hardin(before, passing, &Interval::lo), hardin(before, passing, &Interval::hi)};
}

/// The curves up to the sieve that all passed.
Curves up_to_coarsest(const GradingCurve &before, Curves c) {
  const std::size_t points = before.coarsest() + 2 - first_sieve(before);
  c.sizes.resize(points);
  c.before.erase(c.before.begin() + static_cast<std::ptrdiff_t>(points), c.before.end());
  c.now.erase(c.now.begin() + static_cast<std::ptrdiff_t>(points), c.now.end());
  return c;
}

/// The area below (x^a - m^a) / (M^a - m^a) over log x, from m to M: 1/a - m^a log(M/m) / (M^a - m^a).
Real area_of_fractal(const PowerProduct &m, const PowerProduct &M) {
  const Rational a(2, 5); // 3 less the dimension
  const Real finest = pow(m, a).real(), coarsest = pow(M, a).real();
  return Real(1 / a) - finest * log_of(m, M) / (coarsest - finest);
}

Available<RealRange> einav(const GradingCurve &before, const std::vector<Interval> &passing) {
  const Curves lower = up_to_coarsest(before, from_finest(before, passing, &Interval::lo));
  const Curves upper = up_to_coarsest(before, from_finest(before, passing, &Interval::hi));
  if (lower.points() < 2)
    return NotAvailable{"all passed the finest sieve at the beginning"};
  const Real was = area(lower, [&lower](std::size_t i) { return lower.before[i]; });
  const Real possible = area_of_fractal(lower.sizes.front(), lower.sizes.back()) - was;
  if (compare(possible, 0) != Order::greater)
    return NotAvailable{"the curve at the beginning is as fine as one of dimension 2.6 already"};
  return RealRange{broken(lower) / possible, broken(upper) / possible};
}

} // namespace

Breakage breakage(const GradingCurve &before, const std::vector<Interval> &passing) {
  assert(passing.size() == before.shares().size());
  return {hardin(before, passing), einav(before, passing)};
}

} // namespace mdm
