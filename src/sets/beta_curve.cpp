// The cumulative beta model h(d) = I_x(a, b) of a grading curve. Its values are enclosed by Arb, and exact
// where a or b is an integer or the curve has a known value; its inverse is found by bisection, near 0 and
// 1 of the exponent of x, and then by interval Newton steps, which keep the solution enclosed and square
// the error. If a step gains nothing, as where the density is 0 or infinite, bisection goes on. It ends at
// some 2^-bits.

#include "sets/beta_curve.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <map>
#include <memory>

namespace mdm {
namespace {

/// Closed forms have so many terms of so many bits at most; beyond, enclosures must do.
constexpr unsigned most_terms = 200;
constexpr unsigned most_surd_terms = 100;
constexpr std::size_t most_closed_bits = std::size_t{1} << 18;

bool is_small_integer(const Rational &r) {
  return denominator(r) == 1 && r >= 1 && r <= most_terms;
}

unsigned to_unsigned(const Integer &n) {
  return static_cast<unsigned>(n);
}

/// sum_{j<b} (a)_j / j! z^j, from the inside out.
template <class Number>
Number polynomial(const Rational &a, unsigned b, const Number &z) {
  Number sum = 1;
  for (unsigned j = b - 1; j > 0; --j)
    sum = Number(1) + Number((a + (j - 1)) / j) * z * sum;
  return sum;
}

/// x^a, if it is a fraction and not too long.
std::optional<Rational> exact_power(const Rational &x, const Rational &a) {
  const Integer &p = numerator(a), &q = denominator(a);
  if (p > 1000000 || q > 1000)
    return std::nullopt;
  const std::optional<Rational> root = exact_root(x, to_unsigned(q));
  if (!root || std::max(bit_length(numerator(*root)), bit_length(denominator(*root))) * to_unsigned(p) >
                   most_closed_bits)
    return std::nullopt;
  return power(*root, to_unsigned(p));
}

/// I_x(a, b) for an integer b, if x^a is a fraction.
std::optional<Rational> with_integer_b(const Rational &x, const Rational &a, const Rational &b) {
  if (!is_small_integer(b))
    return std::nullopt;
  const std::optional<Rational> x_a = exact_power(x, a);
  if (!x_a)
    return std::nullopt;
  return Rational(*x_a * polynomial(a, to_unsigned(numerator(b)), Rational(1 - x)));
}

/// An interval of x that holds the inverse.
struct Bracket {
  Rational lo = 0, hi = 1;
  Rational width() const { return hi - lo; }
};

/// r rounded to a multiple of 2^-bits, down or up.
Rational rounded_down(const Rational &r, unsigned bits) {
  const Integer unit = Integer(1) << bits;
  return ratio(floor(Rational(r * Rational(unit))), unit);
}

Rational rounded_up(const Rational &r, unsigned bits) {
  return -rounded_down(-r, bits);
}

class Inverse {
public:
  Inverse(const Rational &y, const Rational &a, const Rational &b, unsigned bits)
      : y_(y), a_(a), b_(b), bits_(bits), work_(bits + 64) {}

  Bracket find() {
    const Rational enough = ratio(1, Integer(Integer(1) << bits_));
    while (x_.width() > enough)
      if (!newton() && !halve_exponent() && !halve())
        break;
    return x_;
  }

private:
  Ball ball(const Rational &r) const { return Ball(r, work_); }

  /// Makes m an end of the bracket; false if the precision does not tell on which side of m the inverse is.
  bool split(const Rational &m) {
    const Order order = compare(incomplete_beta(ball(m), a_, b_), ball(y_));
    if (order != Order::less && order != Order::greater)
      return false;
    (order == Order::less ? x_.lo : x_.hi) = m;
    return true;
  }

  /// One bisection; false if the precision does not tell anywhere near the middle.
  bool halve() {
    for (const int eighth : {4, 3, 5})
      if (split(x_.lo + x_.width() * ratio(eighth, 8)))
        return true;
    return false;
  }

  /// One bisection of the exponent of the distance from 0 or 1, which may be thousands; false where that is
  /// nearly known, or as for halve().
  bool halve_exponent() {
    const Rational middle = ratio(1, 2);
    const bool low = x_.hi <= middle;
    if (!low && x_.lo < middle)
      return false;
    const Rational nearest = low ? x_.lo : Rational(1 - x_.hi), farthest = low ? x_.hi : Rational(1 - x_.lo);
    if (4 * nearest >= farthest)
      return false;
    const unsigned from = zeros(farthest);
    const unsigned to = nearest == 0 ? std::min(3 * from + 2, bits_) : zeros(nearest);
    const Rational distance = ratio(1, Integer(Integer(1) << (from + to + 1) / 2));
    return nearest < distance && distance < farthest && split(low ? distance : Rational(1 - distance));
  }

  /// The n with 2^-(n + 1) < r <= 2^-n or so, for 0 < r <= 1.
  static unsigned zeros(const Rational &r) {
    return static_cast<unsigned>(bit_length(denominator(r)) - bit_length(numerator(r)));
  }

  /// One step of the interval Newton method, with the density x^(a-1) (1-x)^(b-1) / B(a, b) over the whole
  /// bracket; false if it does not make the bracket much smaller.
  bool newton() {
    if (x_.lo == 0 || x_.hi == 1 || x_.width() > ratio(1, 16))
      return false;
    const Rational m = (x_.lo + x_.hi) / 2;
    const Ball x = hull(ball(x_.lo), ball(x_.hi));
    const Ball density = pow(x, a_ - 1) * pow(ball(1) - x, b_ - 1) / beta_function(a_, b_, work_);
    const Ball next = ball(m) - (incomplete_beta(ball(m), a_, b_) - ball(y_)) / density;
    if (!next.is_finite())
      return false;
    const Bracket result{std::max(x_.lo, rounded_down(next.lower(), work_)),
                         std::min(x_.hi, rounded_up(next.upper(), work_))};
    if (result.width() > x_.width() / 4)
      return false;
    x_ = result;
    return true;
  }

  Rational y_, a_, b_;
  unsigned bits_, work_;
  Bracket x_;
};

/// The inverse of p, if it is a short fraction that is known to be it.
std::optional<Rational> exact_inverse(const Rational &p, const Rational &a, const Rational &b) {
  constexpr unsigned bits = 64;
  constexpr std::size_t most_bits_of_guess = 24; // beyond, it is no more than the middle of what is known
  const Bracket x = Inverse(p, a, b, bits).find();
  if (x.lo == 0 || x.hi == 1)
    return std::nullopt;
  const Rational guess = simplest_between(x.lo, x.hi);
  if (bit_length(denominator(guess)) > most_bits_of_guess || exact_incomplete_beta(guess, a, b) != p)
    return std::nullopt;
  return guess;
}

std::string decimal_or_fraction(const Rational &r) {
  return exact_decimal(r).value_or(to_string(r));
}

} // namespace

std::optional<Rational> exact_incomplete_beta(const Rational &x, const Rational &a, const Rational &b) {
  const Rational half = ratio(1, 2);
  if (x == 0 || x == 1)
    return x;
  if (a == b && x == half)
    return half;
  if (a == half && b == half && (x == ratio(1, 4) || x == ratio(3, 4)))
    return x == ratio(1, 4) ? ratio(1, 3) : ratio(2, 3);
  if (const std::optional<Rational> value = with_integer_b(x, a, b))
    return value;
  if (const std::optional<Rational> value = with_integer_b(1 - x, b, a))
    return Rational(1 - *value);
  return std::nullopt;
}

Ball inverse_incomplete_beta(const Rational &y, const Rational &a, const Rational &b, unsigned bits) {
  if (y == 0 || y == 1)
    return Ball(y, bits);
  const Bracket x = Inverse(y, a, b, bits).find();
  return hull(Ball(x.lo, bits + 64), Ball(x.hi, bits + 64));
}

const Rational &BetaCurve::least_parameter() {
  static const Rational least = ratio(1, 1000);
  return least;
}

const Rational &BetaCurve::largest_parameter() {
  static const Rational largest = 1000;
  return largest;
}

BetaCurve::BetaCurve(Rational a, Rational b, Rational d_min, Rational d_max)
    : a_(std::move(a)), b_(std::move(b)), d_min_(std::move(d_min)), width_(d_max - d_min_) {
  for (const Rational &parameter : {a_, b_})
    if (parameter < least_parameter() || parameter > largest_parameter())
      throw InputError("a parameter of the beta curve is " + in_quotes(decimal_or_fraction(parameter)) +
                       ": a and b must be from 0.001 to 1000");
  if (d_min_ <= 0)
    throw InputError("the smallest size is not positive: particles have a size; give d_min > 0, a span below "
                     "1 or a finite ratio");
  if (width_ <= 0)
    throw InputError("the smallest size is not below the largest: give d_min < d_max, a span above 0 or a "
                     "ratio above 1");
}

CurveSize BetaCurve::reduced(const CurveSize &d) const {
  if (d.exact)
    return CurveSize((*d.exact - Surd(d_min_)) * Surd(1 / width_));
  return CurveSize((d.real - Real(d_min_)) / Real(width_));
}

std::optional<Surd> BetaCurve::exact_passing(const Surd &x) const {
  if (const std::optional<Rational> r = x.exact()) {
    const std::optional<Rational> value = exact_incomplete_beta(*r, a_, b_);
    return value ? std::optional(Surd(*value)) : std::nullopt;
  }
  if (!is_small_integer(a_) || !is_small_integer(b_) || a_ + b_ > most_terms ||
      std::min<Rational>(x.degree(), a_ + b_) > most_surd_terms)
    return std::nullopt;
  return power(x, to_unsigned(numerator(a_))) * polynomial(a_, to_unsigned(numerator(b_)), Surd(1) - x);
}

Real BetaCurve::passing(const CurveSize &d) const {
  const CurveSize x = reduced(d);
  const auto exact = [x, *this]() -> std::optional<Rational> {
    const std::optional<Surd> value = x.exact ? exact_passing(*x.exact) : std::nullopt;
    return value ? value->exact() : std::nullopt;
  };
  if (x.real.fraction())
    if (const std::optional<Rational> value = exact())
      return Real(*value);
  return Real([x = x.real, a = a_, b = b_](unsigned bits) { return incomplete_beta(x.ball(bits), a, b); },
              exact);
}

Real BetaCurve::between(const CurveSize &lower, const CurveSize &upper) const {
  const Real l = passing(lower), u = passing(upper);
  // Near 1 the difference of the complements loses no digits.
  const auto is_near_1 = [](const Real &h) {
    constexpr unsigned glance = 64;
    const Ball ball = h.ball(glance);
    return ball.is_finite() && ball.upper() > ratio(1, 2);
  };
  if ((l.fraction() && u.fraction()) || !is_near_1(l))
    return u - l;
  const auto complement = [this](const CurveSize &d) {
    const CurveSize x = reduced(d);
    if (x.real.fraction() == Rational(1))
      return Real(0);
    return Real([x = x.real, a = a_, b = b_](unsigned bits) {
      return incomplete_beta(Ball(1, bits) - x.ball(bits), b, a);
    });
  };
  const Real difference = complement(lower) - complement(upper);
  return Real([difference](unsigned bits) { return difference.ball(bits); },
              [l, u] { return (u - l).exact(); });
}

std::optional<Surd> BetaCurve::exact_between(const Surd &lower, const Surd &upper) const {
  const auto h = [this](const Surd &d) { return exact_passing((d - Surd(d_min_)) * Surd(1 / width_)); };
  const std::optional<Surd> l = h(lower);
  const std::optional<Surd> u = l ? h(upper) : std::nullopt;
  return u ? std::optional(*u - *l) : std::nullopt;
}

Real BetaCurve::diameter(const Rational &p) const {
  const auto closed = [this, p]() -> std::optional<Real> {
    if (p == 1)
      return Real(1);
    if (b_ == 1)
      return pow(Real(p), 1 / a_);
    if (a_ == 1)
      return Real(1) - pow(Real(Rational(1 - p)), 1 / b_);
    if (const std::optional<Rational> x = exact_inverse(p, a_, b_))
      return Real(*x);
    return std::nullopt;
  }();
  // Bounds and indices ask for the same inverse again and again.
  const auto known = std::make_shared<std::map<unsigned, Ball>>();
  const Real x = closed ? *closed : Real([known, p, a = a_, b = b_](unsigned bits) {
    const auto at = known->find(bits);
    return at != known->end() ? at->second
                              : known->emplace(bits, inverse_incomplete_beta(p, a, b, bits)).first->second;
  });
  const Real size = Real(d_min_) + x * Real(width_);
  if (const std::optional<Rational> value = size.exact())
    return Real(*value);
  return size;
}

std::string BetaCurve::shape() const {
  const bool symmetric = a_ == b_;
  if (a_ == 1 && b_ == 1)
    return "uniform";
  if (a_ < 1 && b_ < 1)
    return symmetric ? "U-shaped, symmetric" : "U-shaped";
  if (a_ > 1 && b_ > 1)
    return symmetric ? "unimodal, symmetric" : "unimodal";
  // If a or b is 1, the density is a power of x or 1 - x.
  const auto power_law = [](const Rational &exponent) -> std::string {
    if (exponent < 1)
      return ", a power law";
    return exponent > 2    ? ", strictly convex, a power law"
           : exponent == 2 ? ", a straight line"
                           : ", strictly concave, a power law";
  };
  const bool falls = a_ < 1 || (a_ == 1 && b_ > 1);
  return (falls ? "strictly decreasing" : "strictly increasing") + (a_ == 1   ? power_law(b_)
                                                                    : b_ == 1 ? power_law(a_)
                                                                              : "");
}

std::string BetaCurve::course() const {
  if (a_ == 1 && b_ == 1)
    return "a straight line";
  if (a_ < 1 && b_ < 1)
    return "concave, then convex";
  if (a_ > 1 && b_ > 1)
    return "double curved: convex, then concave";
  return a_ < 1 || (a_ == 1 && b_ > 1) ? "strictly concave" : "strictly convex";
}

} // namespace mdm
