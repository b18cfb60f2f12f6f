#pragma once
/// \file
/// Smallest matches within a tolerance by enumeration, each vector of counts judged by the closed forms of
/// one variable, the sample's mass M: nothing of linear programs.

#include "match/tolerant_problem.hpp"

#include <algorithm>
#include <functional>
#include <random>
#include <set>

namespace tolerant_brute {

using namespace mdm;

/// What must be above 0, or at least 0.
struct Demand {
  Rational slack;
  bool strict = false;

  bool holds() const { return slack > 0 || (slack == 0 && !strict); }
};

struct Class {
  Rational f, F, factor;
  bool has_mass; ///< m_j > 0
};

struct Problem {
  std::vector<Class> classes;
  std::vector<Rational> target; ///< g_j
  Tolerance tolerance;
  TolerantDemands demands;
};

using Counts = std::vector<int>;

/// Bounds lo <= hi on a sum, the lower one perhaps excluded.
struct Interval {
  Rational lo, hi;
  bool open = false;
};

/// The masses that each class can hold at the total mass M, its share within the bounds on what is retained.
/// Every way in which there are none is a demand that does not hold.
inline std::vector<Interval> boxes(const Problem &p, const Counts &q, const Rational &M,
                                   std::vector<Demand> &demands) {
  std::vector<Interval> result;
  for (std::size_t j = 0; j < q.size(); ++j) {
    Interval box{p.classes[j].f * q[j], p.classes[j].F * q[j], q[j] > 0};
    if (!p.tolerance.retained.empty()) {
      const ShareBounds &share = p.tolerance.retained[j];
      demands.push_back({share.hi - share.lo, false});
      demands.push_back({box.hi - share.lo * M, false});
      demands.push_back({share.hi * M - box.lo, box.open});
      if (share.lo * M > box.lo) {
        box.lo = share.lo * M;
        box.open = false;
      }
      box.hi = std::min(box.hi, Rational(share.hi * M));
    }
    result.push_back(box);
  }
  return result;
}

/// All demands on M for which masses exist, where bounds on what passes are absent: the sum of the least
/// masses is at most M, that of the greatest at least; and with a total, d_j = t_j - g_j M, which sum up to
/// 0, can have positive (and so negative) parts of at most e M / 2 in sum.
inline std::vector<Demand> retained_and_total(const Problem &p, const Counts &q, const Rational &M) {
  std::vector<Demand> demands;
  const std::vector<Interval> box = boxes(p, q, M, demands);
  Rational least = 0, greatest = 0, above = 0, below = 0;
  bool open = false, open_above = false;
  for (std::size_t j = 0; j < box.size(); ++j) {
    const Rational middle = p.target[j] * M;
    least += box[j].lo;
    greatest += box[j].hi;
    open = open || box[j].open;
    above += std::max(Rational(0), Rational(box[j].lo - middle));
    open_above = open_above || (box[j].open && box[j].lo >= middle);
    below += std::max(Rational(0), Rational(middle - box[j].hi));
  }
  demands.push_back({M - least, open});
  demands.push_back({greatest - M, false});
  if (p.tolerance.total) {
    demands.push_back({*p.tolerance.total / 2 * M - above, open_above});
    demands.push_back({*p.tolerance.total / 2 * M - below, false});
  }
  return demands;
}

/// The masses at which a class's bounds cross.
inline std::set<Rational> breakpoints(const Problem &p, const Counts &q) {
  std::set<Rational> points;
  const auto add = [&points](const Rational &mass, const Rational &share) {
    if (share > 0 && mass > 0)
      points.insert(mass / share);
  };
  for (std::size_t j = 0; j < q.size(); ++j)
    for (const Rational &mass : {Rational(p.classes[j].f * q[j]), Rational(p.classes[j].F * q[j])}) {
      add(mass, p.target[j]);
      if (!p.tolerance.retained.empty()) {
        add(mass, p.tolerance.retained[j].lo);
        add(mass, p.tolerance.retained[j].hi);
      }
    }
  return points;
}

/// Some M satisfies all demands, which are linear in M between breakpoints: tries these, where a demand's
/// line crosses 0, the end of the weight, and the middles between all of them.
inline bool some_mass(std::set<Rational> points, const Rational &least,
                      const std::function<std::vector<Demand>(const Rational &)> &demands) {
  const auto holds = [&](const Rational &M) {
    if (M <= 0 || M < least)
      return false;
    for (const Demand &d : demands(M))
      if (!d.holds())
        return false;
    return true;
  };
  points.insert(least);
  points.insert(0);
  points.insert(2 * *points.rbegin() + 1);
  std::set<Rational> crossings = points;
  for (auto next = std::next(points.begin()); next != points.end(); ++next) {
    const Rational from = *std::prev(next), to = *next;
    const Rational x = (2 * from + to) / 3, y = (from + 2 * to) / 3;
    const std::vector<Demand> at_x = demands(x), at_y = demands(y);
    for (std::size_t i = 0; i < at_x.size(); ++i)
      if (const Rational slope = at_y[i].slack - at_x[i].slack; slope != 0)
        if (const Rational zero = x - at_x[i].slack * (y - x) / slope; from < zero && zero < to)
          crossings.insert(zero);
    // Beyond the last point the lines go on.
    if (std::next(next) == points.end())
      for (std::size_t i = 0; i < at_x.size(); ++i)
        if (const Rational slope = at_y[i].slack - at_x[i].slack; slope != 0)
          if (const Rational zero = x - at_x[i].slack * (y - x) / slope; zero >= to)
            crossings.insert(zero);
  }
  crossings.insert(*crossings.rbegin() + 1);
  for (auto i = crossings.begin(); i != crossings.end(); ++i)
    if (holds(*i) || (i != crossings.begin() && holds((*i + *std::prev(i)) / 2)))
      return true;
  return false;
}

/// Bounds on what passes alone: for all i < j what classes i + 1 to j can hold meets what may lie between the
/// two bounds, linear in M.
inline bool is_passing_match(const Problem &p, const Counts &q) {
  const std::size_t k = q.size();
  std::vector<ShareBounds> bounds = {{0, 0}};
  bounds.insert(bounds.end(), p.tolerance.passing.begin(), p.tolerance.passing.end());
  // All passes the largest sieve.
  if (bounds[k].lo > 1 || bounds[k].hi < 1)
    return false;
  bounds[k] = {1, 1};
  for (const ShareBounds &b : bounds)
    if (b.lo > b.hi)
      return false;
  Rational above = 0, least = p.demands.weight.value_or(Rational(0)); // above < M, least <= M
  std::optional<Rational> most;
  for (std::size_t i = 0; i < k; ++i) {
    Rational f = 0, F = 0;
    for (std::size_t j = i + 1; j <= k; ++j) {
      f += p.classes[j - 1].f * q[j - 1];
      F += p.classes[j - 1].F * q[j - 1];
      const bool empty = F == 0;
      if (const Rational need = bounds[j].lo - bounds[i].hi; need > 0)
        most = most ? std::min(*most, Rational(F / need)) : Rational(F / need);
      const Rational room = bounds[j].hi - bounds[i].lo;
      if (room < 0 || (room == 0 && !empty))
        return false;
      if (!empty)
        above = std::max(above, Rational(f / room));
    }
  }
  return !most || (above < *most && least <= *most);
}

inline bool is_match(const Problem &p, const Counts &q) {
  int sum = 0;
  for (std::size_t j = 0; j < q.size(); ++j) {
    sum += q[j];
    if (p.classes[j].has_mass && q[j] < p.demands.min_per_class)
      return false;
  }
  if (sum < 1 || sum < p.demands.at_least)
    return false;
  if (!p.tolerance.passing.empty())
    return is_passing_match(p, q);
  return some_mass(breakpoints(p, q), p.demands.weight.value_or(Rational(0)),
                   [&](const Rational &M) { return retained_and_total(p, q, M); });
}

/// A match of n particles, the first of all vectors of counts.
inline std::optional<Counts> match_of(const Problem &p, int n) {
  Counts q(p.classes.size(), 0);
  q.back() = n;
  for (;;) {
    if (is_match(p, q))
      return q;
    // The next vector of the same sum: move one particle down from the last class that has any, the rest of
    // them back to the end.
    std::size_t j = q.size() - 1;
    while (j > 0 && q[j] == 0)
      --j;
    if (j == 0)
      return std::nullopt;
    const int rest = q[j] - 1;
    q[j] = 0;
    ++q[j - 1];
    q.back() = rest;
  }
}

/// The least number of particles of a match up to `limit`.
inline std::optional<int> least_particles(const Problem &p, int limit) {
  for (int n = 1; n <= limit; ++n)
    if (match_of(p, n))
      return n;
  return std::nullopt;
}

} // namespace tolerant_brute
