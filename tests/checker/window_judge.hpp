#pragma once
// Windows of the mass by definition: every count is tried, and bounds on shares are longest paths.

#include "mutants.hpp"

namespace mdm_check_test {

using Bounds = std::pair<Rational, Rational>;

/// l_j and h_j: the longest paths between neighbours, where P_0 = 0 and P_k = 1.
inline std::vector<Bounds> bounds_of_shares(const std::vector<Bounds> &retained,
                                            const std::vector<Bounds> &passing,
                                            const std::vector<Rational> &shares, const Rational &half_total) {
  struct Edge {
    std::size_t from, to;
    Rational weight;
  };
  const std::size_t k = shares.size();
  std::vector<Edge> edges{{0, k, 1}, {k, 0, -1}};
  const auto add = [&](std::size_t from, std::size_t to, const Bounds &bounds, const Rational &share) {
    edges.push_back({from, to, std::max<Rational>(bounds.first, share - half_total)});
    edges.push_back({to, from, -std::min<Rational>(bounds.second, share + half_total)});
  };
  Rational passed = 0;
  for (std::size_t j = 0; j < k; ++j) {
    passed += shares[j];
    add(j, j + 1, retained[j], shares[j]);
    if (j + 1 < k)
      add(0, j + 1, passing[j], passed);
  }
  std::vector<Bounds> result;
  const auto longest = [&](std::size_t from, std::size_t to) {
    std::vector<std::optional<Rational>> path(k + 1);
    path[from] = 0;
    for (std::size_t round = 0; round <= k; ++round)
      for (const Edge &e : edges)
        if (path[e.from] && (!path[e.to] || *path[e.from] + e.weight > *path[e.to]))
          path[e.to] = *path[e.from] + e.weight;
    return *path[to];
  };
  for (std::size_t j = 0; j < k; ++j)
    result.emplace_back(longest(j, j + 1), -longest(j + 1, j));
  return result;
}

/// A class in the window s < M <= S (0: no upper end), with its bounds on counts (-1: no upper bound).
struct WindowClass {
  Rational f, F, l, h, g, least, most, s, S;
};

/// What a class has at most of c y + e q - mu (y - g)^+, by trying counts.
struct WindowValue {
  enum Kind { some, empty, infinite, too_many } kind = some;
  Rational value = 0;
  bool is_reached = false;
};

inline WindowValue window_value(const WindowClass &w, const Rational &c, const Rational &e,
                                const Rational &mu) {
  // All conditions on q, taken literally, and a count from which on only e changes the value.
  const auto can_hold = [&](const Rational &q) {
    const bool counts = q >= w.least && (w.most < 0 || q <= w.most);
    return counts && (w.l <= 0 || (q >= 1 && q * w.F > w.l * w.s)) &&
           (q == 0 || (w.h > 0 && (w.S == 0 || q * w.f < w.h * w.S)));
  };
  Rational last = w.least + 2;
  for (const Rational &share : {w.l, w.h, w.g}) {
    last = std::max<Rational>(last, share * w.s / w.F + 2);
    if (w.f > 0)
      last = std::max<Rational>(last, share * w.S / w.f + 2);
  }
  if (w.most >= 0 && w.h > 0 && (w.S == 0 || w.f == 0))
    last = std::max<Rational>(last, w.most);
  if (last - w.least > 2000)
    return {WindowValue::too_many};
  WindowValue best{WindowValue::empty};
  const auto see = [&](const Rational &q, const Rational &y, bool is_reached) {
    const Rational value = c * y + e * q - mu * std::max<Rational>(0, y - w.g);
    if (best.kind == WindowValue::empty || value > best.value)
      best = {WindowValue::some, value, is_reached};
    else
      best.is_reached = best.is_reached || (value == best.value && is_reached);
  };
  for (Rational q = w.least; q <= last; q += 1) {
    if (!can_hold(q))
      continue;
    if (q == 0) {
      see(0, 0, true);
      continue;
    }
    const Rational of_f = w.S == 0 ? Rational(0) : Rational(q * w.f / w.S);
    const Rational low = std::max(of_f, w.l);
    const Rational high = w.s == 0 ? w.h : std::min<Rational>(q * w.F / w.s, w.h);
    std::vector<Rational> shares{low, high, (low + high) / 2};
    if (low < w.g && w.g < high)
      shares.push_back(w.g);
    for (const Rational &y : shares)
      see(q, y, y > of_f && (w.s == 0 || y < q * w.F / w.s));
  }
  const bool goes_on = w.most < 0 && w.h > 0 && (w.S == 0 || w.f == 0);
  if (best.kind == WindowValue::some && goes_on && e > 0)
    best.kind = WindowValue::infinite;
  return best;
}

} // namespace mdm_check_test
