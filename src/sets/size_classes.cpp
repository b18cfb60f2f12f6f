// Size classes of a curve: bounds by a rule, and the share f_v = h(upper) - h(lower) of each. Bounds of
// regular classes are fractions, those of geometric ones powers of one root, kept as such (Surd), and those
// of isochoric ones the inverse of the curve at i / N: a real number that is refined when it is needed. So
// shares are exact wherever the model is, and ties between classes are seen.

#include "sets/size_classes.hpp"

#include <mdm/text/error.hpp>

namespace mdm {
namespace {

std::vector<SizeClass> classes_between(const std::vector<CurveSize> &bounds, const ModelCurve &curve) {
  std::vector<SizeClass> classes;
  classes.reserve(bounds.size() - 1);
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i)
    classes.push_back({bounds[i], bounds[i + 1], curve.between(bounds[i], bounds[i + 1])});
  return classes;
}

CurveSize bound(const ModelCurve &curve, Classing classing, unsigned i, unsigned n) {
  const Rational low = curve.d_min(), high = curve.d_max();
  if (i == 0)
    return Surd(low);
  if (i == n)
    return Surd(high);
  if (classing == Classing::regular)
    return Surd(Rational(low + (high - low) * ratio(i, n)));
  if (classing == Classing::geometric)
    return Surd(low) * Surd::root_power(high / low, i, n);
  return curve.diameter(ratio(i, n));
}

} // namespace

const char *name(Classing classing) {
  switch (classing) {
  case Classing::regular:
    return "regular";
  case Classing::geometric:
    return "geometric";
  case Classing::isochoric:
    break;
  }
  return "isochoric";
}

std::vector<SizeClass> size_classes(const ModelCurve &curve, Classing classing, unsigned n) {
  if (n == 0 || n > max_size_classes)
    throw InputError("the number of classes must be from 1 to " + std::to_string(max_size_classes));
  std::vector<CurveSize> bounds;
  bounds.reserve(n + 1);
  for (unsigned i = 0; i <= n; ++i)
    bounds.push_back(bound(curve, classing, i, n));
  if (classing != Classing::isochoric)
    return classes_between(bounds, curve);
  std::vector<SizeClass> classes;
  for (unsigned i = 0; i < n; ++i) {
    if (compare(bounds[i].real, bounds[i + 1].real) != Order::less)
      throw InputError("isochoric classes are not possible: the curve has a step where a class would have no "
                       "width; use other classes");
    classes.push_back({bounds[i], bounds[i + 1], Real(ratio(1, n))});
  }
  return classes;
}

std::vector<SizeClass> sieve_classes(const SieveCurve &curve) {
  std::vector<CurveSize> bounds;
  for (const Rational &sieve : curve.sieves())
    bounds.emplace_back(Surd(sieve));
  return classes_between(bounds, curve);
}

} // namespace mdm
