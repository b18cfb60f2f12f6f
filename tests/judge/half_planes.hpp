#pragma once
/// Curves with two unknown percents as a polygon.

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

} // namespace judge_test
