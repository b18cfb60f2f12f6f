#pragma once
/// \file
/// Matches by enumeration, in plain fractions: the definitions, nothing of the algorithms under test.

#include "match/problem.hpp"

#include <mdm/gradation/gradation.hpp>

#include <algorithm>
#include <random>
#include <set>

namespace brute {

using namespace mdm;

/// Ends of a class: q particles hold s m iff q a < s <= q b.
struct Class {
  Rational a, b;
  Integer floor;
};

using Problem = std::vector<Class>;
using Vector = std::vector<Integer>;

/// Spheres, from Arnold's Eq. 12 and 14.
inline Problem problem(const Gradation &g, const Integer &min_per_class) {
  Problem p;
  for (std::size_t j = 0; j < g.classes(); ++j)
    if (g.mass(j) > 0)
      p.push_back({g.factor(j) * g.lower(j) * g.lower(j) * g.lower(j) / g.mass(j),
                   g.factor(j) * g.upper(j) * g.upper(j) * g.upper(j) / g.mass(j), min_per_class});
  return p;
}

/// Least counts at the scale s, if it is feasible.
inline std::optional<Vector> counts(const Problem &p, const Rational &s) {
  Vector q;
  for (const Class &c : p) {
    q.push_back(std::max(c.floor, ceil(Rational(s / c.b))));
    if (!(Rational(q.back()) * c.a < s))
      return std::nullopt;
  }
  return q;
}

/// Most particles at the scale s; nothing if there is no bound.
inline std::optional<Integer> most(const Problem &p, const Rational &s) {
  Integer n = 0;
  for (const Class &c : p) {
    if (c.a == 0)
      return std::nullopt;
    n += ceil(Rational(s / c.a)) - 1;
  }
  return n;
}

/// All scales q a and q b up to `highest`, ascending.
inline std::vector<Rational> breakpoints(const Problem &p, const Rational &highest) {
  std::vector<Rational> points;
  for (const Class &c : p) {
    for (Rational s = c.a; c.a > 0 && s <= highest; s += c.a)
      points.push_back(s);
    for (Rational s = c.b; s <= highest; s += c.b)
      points.push_back(s);
  }
  std::sort(points.begin(), points.end());
  return points;
}

/// The least match with s >= start, if it has a scale up to `highest`: the first feasible scale among the
/// upper ends q b and the start, where every window has its last scale.
inline std::optional<Vector> least_match(const Problem &p, const Rational &highest,
                                         const Rational &start = 0) {
  for (const Rational &s : breakpoints(p, highest))
    if (s >= start)
      if (std::optional<Vector> q = counts(p, s))
        return q;
  return std::nullopt;
}

/// A scale that is low enough for enumeration, and high enough for most least matches.
inline Rational some_scale(const Problem &p) {
  Rational coarsest = 0, finest = p.front().b;
  for (const Class &c : p) {
    coarsest = std::max(coarsest, c.b);
    finest = std::min(finest, c.b);
  }
  return std::min(Rational(8 * coarsest), Rational(2000 * finest));
}

/// All N up to `limit` that have a match: at the breakpoints and between them.
inline std::set<Integer> reachable(const Problem &p, const Integer &limit) {
  std::set<Integer> n;
  Rational finest = p.front().b;
  for (const Class &c : p)
    finest = std::min(finest, c.b);
  // Above this scale the finest class alone has more than `limit` particles.
  std::vector<Rational> scales = breakpoints(p, Rational((Rational(limit) + 1) * finest));
  for (std::size_t i = scales.size(); i-- > 1;)
    scales.push_back((scales[i] + scales[i - 1]) / 2);
  for (const Rational &s : scales)
    if (const std::optional<Vector> q = counts(p, s))
      for (Integer i = total(*q); i <= std::min(limit, most(p, s).value_or(limit)); ++i)
        n.insert(i);
  return n;
}

/// A small gradation with ties, touching classes, empty classes, wide or narrow ones, sometimes a pan at 0
/// and factors.
inline Gradation random_gradation(std::mt19937_64 &random) {
  Gradation::Data data;
  const std::size_t n = 2 + random() % 4;
  std::set<int> sizes;
  const int finest = random() % 2 == 0 ? 0 : 6;
  while (sizes.size() < n)
    sizes.insert(finest + static_cast<int>(random() % 9));
  for (const int x : sizes)
    data.sizes.emplace_back(x);
  for (std::size_t j = 0; j + 1 < n; ++j)
    data.masses.emplace_back(static_cast<int>(random() % 8));
  if (std::all_of(data.masses.begin(), data.masses.end(), [](const Rational &m) { return m == 0; }))
    data.masses.front() = 1;
  data.masses.emplace_back(0);
  if (random() % 4 == 0)
    for (std::size_t j = 0; j < n; ++j)
      data.factors.push_back(ratio(static_cast<int>(1 + random() % 4), static_cast<int>(1 + random() % 3)));
  return Gradation(std::move(data));
}

} // namespace brute
