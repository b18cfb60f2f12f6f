// Gaskets. What comes in are four circles that touch each other, the outermost among them, and a bound on
// the curvature k; what goes out are all circles of the gasket up to it, or their number, with the sums of
// 1 / k^2.
//
// Of four circles that touch, any one can be reflected in the other three: w' = 2 (w1 + w2 + w3) - w for
// its curvature, and for the curvature times each coordinate of the centre (Descartes; Lagarias, Mallows,
// Wilks 2002). From a reduced root every circle comes once, by reflections of which none is undone by the
// next, and the new circle is always the smallest of its four. So what is beyond the bound has nothing
// within it behind, and a walk in depth (apollonian_walk.hpp) ends with memory for a path alone.
//
// Numbers are p + q sqrt 3 with 64-bit integers, all below 2^58. k <= T is decided in doubles where their
// error allows it and in integers elsewhere; the sum of 1 / k^2 is enclosed by a bound on all its
// roundings.

#include "packing/apollonian.hpp"

#include "packing/apollonian_walk.hpp"
#include "packing/disc_sizes.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {
namespace {

using packing::CurvatureBound;

/// A curvature p + q sqrt 3 alone.
struct Curvature {
  std::int64_t p, q;

  friend Curvature operator+(Curvature a, Curvature b) { return {a.p + b.p, a.q + b.q}; }
  /// 2 (this - w) - w: this is the sum of all four.
  Curvature twice_without(Curvature w) const { return {2 * p - 3 * w.p, 2 * q - 3 * w.q}; }
};

struct Circle : ApollonianCircle {
  friend Circle operator+(const Circle &a, const Circle &b) {
    return {{a.p + b.p, a.q + b.q, a.x + b.x, a.y + b.y}};
  }
  Circle twice_without(const Circle &w) const {
    return {{2 * p - 3 * w.p, 2 * q - 3 * w.q, 2 * x - 3 * w.x, 2 * y - 3 * w.y}};
  }
};

/// A sum of doubles above 0 with its error (Kahan, Neumaier).
class Sum {
public:
  void add(double v) {
    const double next = sum_ + v;
    lost_ += sum_ >= v ? (sum_ - next) + v : (v - next) + sum_;
    sum_ = next;
  }
  double value() const { return sum_ + lost_; }

private:
  double sum_ = 0, lost_ = 0;
};

void check_bound(const Rational &most) {
  if (most > ApollonianGasket::most_curvature)
    throw InputError("curvatures beyond 10^12: the smallest radius is at least 1/10^12");
}

std::string shown(const std::array<Integer, 4> &w) {
  return to_string(w[0]) + "," + to_string(w[1]) + "," + to_string(w[2]) + "," + to_string(w[3]);
}

/// The quadruple from which all others of the gasket follow: the largest is replaced while that makes it
/// smaller.
std::array<Integer, 4> reduced(std::array<Integer, 4> w) {
  for (;;) {
    std::sort(w.begin(), w.end());
    const Integer other = 2 * (w[0] + w[1] + w[2]) - w[3];
    if (other >= w[3])
      return w;
    w[3] = other;
  }
}

Integer square(const Integer &n) {
  return n * n;
}

/// \throws InputError if the four are no root of a bounded gasket
void check_root(const std::array<Integer, 4> &w) {
  constexpr int largest = 1000000;
  for (const Integer &k : w)
    if (abs(k) > largest)
      throw InputError("curvatures " + shown(w) + ": each must be from -10^6 to 10^6");
  if (2 * (square(w[0]) + square(w[1]) + square(w[2]) + square(w[3])) !=
      square(Integer(w[0] + w[1] + w[2] + w[3])))
    throw InputError(
        "curvatures " + shown(w) +
        ": they do not satisfy Descartes' relation 2 sum k^2 = (sum k)^2: such circles do not touch");
  if (w[0] + w[1] + w[2] + w[3] <= 0)
    throw InputError("curvatures " + shown(w) +
                     ": a circle that holds the others is below 0, they are above: "
                     "change all signs");
  const std::array<Integer, 4> root = reduced(w);
  if (root[0] >= 0)
    throw InputError("curvatures " + shown(w) + ": the gasket " + shown(root) +
                     " is a strip between lines without end: take one in a circle, for example -1,2,2,3");
  if (root != w)
    throw InputError("curvatures " + shown(w) + ": they are not the gasket's reduced ones, " + shown(root) +
                     ": give these");
}

/// k and k times the centre for the circles of a root; the outer one is around the origin, the second has its
/// centre on the x axis.
struct ExactCircle {
  Rational k, x, y;
};

std::array<ExactCircle, 4> placed(const std::array<Integer, 4> &w) {
  const Rational n = Rational(-w[0]), b(w[1]), c(w[2]), d(w[3]);
  // Distances of centres: 1/n - 1/k from the outer one, 1/k + 1/l between others.
  const Rational x_b = 1 / n - 1 / b;
  const auto x_of = [&](const Rational &k) -> Rational {
    const Rational from_outer = 1 / n - 1 / k, from_b = 1 / b + 1 / k;
    return (from_outer * from_outer + x_b * x_b - from_b * from_b) / (2 * x_b);
  };
  const auto height2 = [&](const Rational &k) -> Rational {
    const Rational from_outer = 1 / n - 1 / k, x = x_of(k);
    return from_outer * from_outer - x * x;
  };
  const Rational y_c = exact_root(height2(c), 2).value(), y_d = exact_root(height2(d), 2).value();
  // Of the two places of the fourth, the one that touches the third.
  const Rational apart = 1 / c + 1 / d, dx = x_of(c) - x_of(d);
  const Rational side = apart * apart == dx * dx + (y_c - y_d) * (y_c - y_d) ? Rational(1) : Rational(-1);
  return {{{-n, 0, 0}, {b, b * x_b, 0}, {c, c * x_of(c), c * y_c}, {d, d * x_of(d), side * d * y_d}}};
}

std::int64_t whole(const Rational &r) {
  return static_cast<std::int64_t>(numerator(r));
}

Real sqrt3() {
  return pow(Real(3), ratio(1, 2));
}

} // namespace

ApollonianGasket ApollonianGasket::equal() {
  // Centres (-1, -1/sqrt 3), (1, -1/sqrt 3), (0, 2/sqrt 3); y is by sqrt 3 larger.
  return {{{{3, -2, 0, 0}, {1, 0, -1, -1}, {1, 0, 1, -1}, {1, 0, 0, 2}}}, 1, true};
}

ApollonianGasket ApollonianGasket::integral(const std::array<Integer, 4> &curvatures) {
  std::array<Integer, 4> w = curvatures;
  std::sort(w.begin(), w.end());
  check_root(w);
  const std::array<ExactCircle, 4> exact = placed(w);
  Integer scale = 1;
  for (const ExactCircle &c : exact)
    scale = lcm(lcm(scale, denominator(c.x)), denominator(c.y));
  // |k x| <= k / n for a circle inside that of radius 1/n; sums of eight such numbers come up.
  if (scale * most_curvature > Integer(1) << 58)
    throw InputError("curvatures " + shown(w) +
                     ": centres are fractions too long for 64 bits: take smaller ones");
  std::array<ApollonianCircle, 4> root{};
  for (std::size_t i = 0; i < root.size(); ++i)
    root[i] = {whole(exact[i].k), 0, whole(Rational(exact[i].x * Rational(scale))),
               whole(Rational(exact[i].y * Rational(scale)))};
  return {root, static_cast<std::int64_t>(scale), false};
}

Real ApollonianGasket::outer_curvature() const {
  return curvature(root_[0]);
}

Real ApollonianGasket::curvature(const ApollonianCircle &c) const {
  return c.q == 0 ? Real(Rational(c.p)) : Real(Rational(c.p)) + Real(Rational(c.q)) * sqrt3();
}

Real ApollonianGasket::centre_x(const ApollonianCircle &c) const {
  return Real(ratio(c.x, scale_)) / curvature(c);
}

Real ApollonianGasket::centre_y(const ApollonianCircle &c) const {
  const Real y = Real(ratio(c.y, scale_)) / curvature(c);
  return surd_ ? y / sqrt3() : y;
}

void ApollonianGasket::each(const Rational &most,
                            const std::function<void(const ApollonianCircle &)> &take) const {
  check_bound(most);
  const CurvatureBound bound(most);
  const auto within = [&bound](const ApollonianCircle &c) { return bound.holds(c.p, c.q); };
  std::array<Circle, 4> root{};
  for (std::size_t i = 0; i < root.size(); ++i) {
    root[i] = {root_[i]};
    if (i > 0 && within(root_[i]))
      take(root_[i]);
  }
  packing::each_reflected(root, within, take);
}

ApollonianCensus ApollonianGasket::census(const Rational &most,
                                          const std::function<void(std::uint64_t)> &progress) const {
  check_bound(most);
  constexpr std::uint64_t often = 1 << 20;
  const CurvatureBound bound(most);
  std::vector<CurvatureBound> octaves;
  for (Rational t = most; t * 1000 > 1; t /= 2)
    octaves.emplace_back(t);
  ApollonianCensus census;
  census.octaves.resize(octaves.size());
  const auto near = most.convert_to<double>();
  Sum sum;
  double worst = 0; // relative error of a curvature
  const auto within = [&bound](Curvature k) { return bound.holds(k.p, k.q); };
  const auto take = [&](Curvature c) {
    const double k = CurvatureBound::value(c.p, c.q);
    worst = std::max(worst, CurvatureBound::error(c.p, c.q) / k);
    sum.add(1 / (k * k));
    // The octave as doubles see it; next to an end of it whole numbers decide.
    auto j = static_cast<std::size_t>(std::max(0, std::ilogb(near / k * (1 - 0x1p-40))));
    while (j + 1 < octaves.size() && octaves[j + 1].holds(c.p, c.q))
      ++j;
    ++census.octaves[j];
    if (++census.circles % often == 0 && progress)
      progress(census.circles);
  };
  std::array<Curvature, 4> root{};
  for (std::size_t i = 0; i < root.size(); ++i) {
    root[i] = {root_[i].p, root_[i].q};
    if (i > 0 && within(root[i]))
      take(root[i]);
  }
  packing::each_reflected(root, within, take);
  // Each term is off by twice the error of its curvature and three roundings; the sum by two, and by N 2^-104
  // of itself for fewer than 2^40 terms.
  const Rational error = Rational(3 * worst) + ratio(1, Integer(1) << 48);
  const Rational found(sum.value());
  census.inverse_squares = {found * (1 - error), found * (1 + error)};
  return census;
}

Interval ApollonianGasket::covered(const ApollonianCensus &census) const {
  constexpr unsigned bits = 128;
  const Ball outer = outer_curvature().ball(bits);
  const Ball square = outer * outer;
  return Interval(square.lower(), square.upper()) * census.inverse_squares;
}

Packing ApollonianGasket::packing(const Rational &most) const {
  const std::uint64_t n = census(most).circles;
  if (n > most_discs)
    throw InputError(std::to_string(n) + " circles are more than a packing holds, 10^7: give a larger " +
                     option("smallest") + ", or take " + option("format") + " csv");
  constexpr unsigned bits = 192;
  const auto value = [](const Real &r) -> Rational {
    const Ball b = r.ball(bits);
    return (b.lower() + b.upper()) / 2;
  };
  const Rational radius = -1 / value(outer_curvature()), sqrt_3 = value(sqrt3());
  Packing p;
  p.rule = DepositRule::apollonian;
  p.periodic = false;
  while (floor(Rational(2 * radius * Rational(power_of_ten(p.places + 1)))) < Integer(1) << 51)
    ++p.places;
  const Rational unit(power_of_ten(p.places));
  if (unit / most < Integer(1) << 16)
    throw InputError("the smallest circle is too small for the lattice: give a larger " + option("smallest"));
  const Integer half = ceil(Rational(radius * unit));
  p.width = static_cast<std::int64_t>(2 * half);
  const auto nearest = [](const Rational &r) {
    return static_cast<std::int64_t>(floor(Rational(r + ratio(1, 2))));
  };
  each(most, [&](const ApollonianCircle &c) {
    const Rational k = Rational(c.p) + Rational(c.q) * sqrt_3, scaled = k * Rational(scale_) / unit;
    const Rational x = Rational(c.x) / scaled,
                   y = Rational(c.y) / (surd_ ? Rational(scaled * sqrt_3) : scaled);
    p.discs.push_back({nearest(Rational(x + Rational(half))), nearest(Rational(y + Rational(half))),
                       static_cast<std::int64_t>(floor(Rational(unit / k))) - 2, unsupported, unsupported});
  });
  return p;
}

Real apollonian_slope(std::uint64_t all, std::uint64_t half) {
  if (all == half)
    return {0};
  const Rational times = ratio(all, half);
  return Real([times](unsigned bits) { return log(Ball(times, bits)) / log(Ball(2, bits)); });
}

} // namespace mdm
