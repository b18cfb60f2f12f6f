#pragma once
/// \file
/// Vectors in space.
///
/// Only + - * / and square roots, so that results are the same on every machine.

#include <cmath>

namespace mdm::packing {

/// A vector or a point; of length 1 where it is a direction.
struct Vector3 {
  double x = 0, y = 0, z = 0;

  bool operator==(const Vector3 &) const = default;
  friend Vector3 operator+(Vector3 a, Vector3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector3 operator-(Vector3 a, Vector3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector3 operator*(double f, Vector3 a) { return {f * a.x, f * a.y, f * a.z}; }
};

inline double dot(Vector3 a, Vector3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vector3 cross(Vector3 a, Vector3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(Vector3 a) {
  return std::sqrt(dot(a, a));
}

/// \pre a is not 0
inline Vector3 direction(Vector3 a) {
  return (1 / length(a)) * a;
}

} // namespace mdm::packing
