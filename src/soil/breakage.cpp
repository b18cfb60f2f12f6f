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

/// A size above 0 with what passed it before, and what passes now.
struct Passed {
  PowerProduct size;
  Real before, now;
};

/// Two curves, linear in log size between these points, which ascend.
using Curves = std::vector<Passed>;

/// The sum over all strips of width times the mean of height at both sides.
template <class Height>
Real area(const Curves &c, Height height) {
  Real sum = 0;
  for (std::size_t i = 0; i + 1 < c.size(); ++i)
    sum = sum + log_of(c[i].size, c[i + 1].size) * (height(c[i]) + height(c[i + 1])) * Rational(1, 2);
  return sum;
}

Real broken(const Curves &c) {
  return area(c, [](const Passed &p) { return p.now - p.before; });
}

/// The index of the first opening above 0.
std::size_t first_sieve(const GradingCurve &curve) {
  return curve.has_pan() ? 1 : 0;
}

/// The curves from the finest sieve on. \param side  the end of each share that counts
Curves from_finest(const GradingCurve &before, const std::vector<Interval> &passing,
                   Rational Interval::*side) {
  Curves c;
  for (std::size_t i = first_sieve(before); i < passing.size(); ++i)
    c.push_back({before.power_of(i), before.shares()[i], passing[i].*side});
  return c;
}

const Rational finest_counted(74, 1000); // mm

/// The curves from 0.074 mm on; there it is taken that `finer` passes now, where the finest sieve is above.
Curves from_hardins_size(const GradingCurve &before, Curves c, const Rational &finer) {
  const RootSize from{finest_counted};
  const std::size_t finest = first_sieve(before);
  std::size_t first = 0; // of the points that are not below
  while (first < c.size() && compare(before.opening(finest + first), from) < 0)
    ++first;
  if (first == 0 && compare(before.opening(finest), from) == 0)
    return c;
  const PowerProduct size(finest_counted);
  if (first == 0) {
    // Below the finest sieve the curve is taken to be level: two points there, of which the upper has no
    // width.
    c.insert(c.begin(), {{size, 0, finer}, {c.front().size, 0, finer}});
    return c;
  }
  const Passed &lower = c[first - 1], &upper = c[first];
  const Real place = log_of(lower.size, size) / log_of(lower.size, upper.size);
  const Passed cut{size, lower.before + place * (upper.before - lower.before),
                   lower.now + place * (upper.now - lower.now)};
  c.erase(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(first));
  c.insert(c.begin(), cut);
  return c;
}

Real hardin(const GradingCurve &before, const std::vector<Interval> &passing, Rational Interval::*side) {
  const Rational finer = side == &Interval::hi ? passing[first_sieve(before)].hi : Rational(0);
  const Curves c = from_hardins_size(before, from_finest(before, passing, side), finer);
  return broken(c) / area(c, [](const Passed &p) { return Real(1) - p.before; });
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
  c.erase(c.begin() + static_cast<std::ptrdiff_t>(before.coarsest() + 2 - first_sieve(before)), c.end());
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
  if (lower.size() < 2)
    return NotAvailable{"all passed the finest sieve at the beginning"};
  const Real was = area(lower, [](const Passed &p) { return p.before; });
  const Real possible = area_of_fractal(lower.front().size, lower.back().size) - was;
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
