#pragma once
/// Curves with two unknown percents as a polygon.

#include "catch.hpp"
#include "judge/conformity.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace judge_test {

/// a x + b y <= c, for the percents x and y that pass two sieves, in sixths of a percent.
struct HalfPlane {
  std::int64_t a, b, c;
};

/// The second method: the corners of a polygon are where two of its half planes end.
inline bool has_corner(const std::vector<HalfPlane> &inside, const std::vector<HalfPlane> &also_not) {
  for (std::size_t i = 0; i < inside.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const HalfPlane &p = inside[i], &q = inside[j];
      std::int64_t det = p.a * q.b - q.a * p.b, x = p.c * q.b - q.c * p.b, y = p.a * q.c - q.a * p.c;
      if (det == 0)
        continue;
      if (det < 0) {
        det = -det;
        x = -x;
        y = -y;
      }
      const auto keeps = [&](const HalfPlane &h) { return h.a * x + h.b * y <= h.c * det; };
      if (!std::all_of(inside.begin(), inside.end(), keeps))
        continue;
      if (also_not.empty() || !std::all_of(also_not.begin(), also_not.end(), keeps))
        return true;
    }
  return false;
}

inline void add_range(std::vector<HalfPlane> &to, std::int64_t a, std::int64_t b, std::int64_t lo,
                      std::int64_t hi) {
  to.push_back({-a, -b, -lo});
  to.push_back({a, b, hi});
}

inline std::vector<HalfPlane> both(std::vector<HalfPlane> a, const std::vector<HalfPlane> &b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// By the corners of all curves, which are the box, and of those that keep what is wanted.
inline mdm::Compliance expected_verdict(const std::vector<HalfPlane> &box,
                                        const std::vector<HalfPlane> &wanted) {
  if (!has_corner(both(box, wanted), {}))
    return mdm::Compliance::fails;
  return wanted.empty() || !has_corner(box, wanted) ? mdm::Compliance::holds : mdm::Compliance::hangs;
}

/// \param first  the place of the first of the two unknown percents
inline bool keeps(const mdm::WitnessCurve &curve, const std::vector<HalfPlane> &all, std::size_t first) {
  const mdm::Rational x = curve.passing[first] * 6, y = curve.passing[first + 1] * 6;
  return std::all_of(all.begin(), all.end(), [&](const HalfPlane &h) {
    return mdm::Rational(h.a) * x + mdm::Rational(h.b) * y <= h.c;
  });
}

/// A verdict that hangs has a curve on either side, another has none.
inline void check_witnesses(const mdm::Conformity &c, const std::vector<HalfPlane> &box,
                            const std::vector<HalfPlane> &wanted, std::size_t first) {
  if (c.verdict != mdm::Compliance::hangs) {
    REQUIRE_FALSE(c.within);
    REQUIRE_FALSE(c.outside);
    return;
  }
  REQUIRE(c.within);
  REQUIRE(c.outside);
  REQUIRE(keeps(*c.within, both(box, wanted), first));
  REQUIRE(keeps(*c.outside, box, first));
  REQUIRE_FALSE(keeps(*c.outside, wanted, first));
}

} // namespace judge_test
