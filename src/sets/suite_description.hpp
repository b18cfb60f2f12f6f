#pragma once
/// \file
/// What a suite of gradations is to be made of.

#include "number/random_stream.hpp"

#include <mdm/gradation/mass_law.hpp>
#include <mdm/gradation/size_unit.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mdm {

/// One of from, from + 1, ..., to.
struct CountRange {
  std::uint32_t from, to;
  std::uint32_t drawn(RandomStream &random) const { return from + random.below(to - from + 1); }
};

/// One of 1,001 numbers, equally spaced from `from` to `to`.
struct NumberRange {
  Rational from, to;
  Rational drawn(RandomStream &random) const;
};

/// Sieves of a list, ascending: any of them, or neighbours.
struct ListedSieves {
  std::vector<Rational> openings;
  bool neighbours = false;
};

/// Sieves of equal ratios to `digits` significant digits: from `from` to `to`, or each `ratio` times the one
/// before.
struct GeometricSieves {
  NumberRange from;
  std::optional<NumberRange> to, ratio;
  unsigned digits;
};

/// Shares uniform among all that are above 0.
struct RandomMasses {};

/// The same, but a run of so many inner classes has none.
struct GapMasses {
  CountRange empty;
};

/// Shares of the cumulative beta curve (BetaCurve) on the sizes from the least sieve to the largest.
struct BetaMasses {
  NumberRange a, b;
};

/// Shares of a lognormal curve cut at the least sieve and the largest.
struct LognormalMasses {
  NumberRange median;    ///< its place between these two on the log scale, 0 to 1
  NumberRange deviation; ///< of ln x
};

/// Masses of a normal distribution over the classes, whatever their widths, with noise around it, as the
/// gradations of Arnold's paper were made.
struct NormalMasses {
  NumberRange centre;    ///< its place among the classes, from the smallest sieve, 0, to the largest, 1
  NumberRange deviation; ///< in classes
  NumberRange noise;     ///< the most that is added to a class, over the height of the distribution
};

/// Masses q f(x): that of q particles of the size of one of the class's sieves, so that bounds on the scale
/// coincide.
struct TiedMasses {
  enum class At { upper, lower, either };
  At at;
  CountRange quantities; ///< q
  unsigned power;        ///< f(x) = x^power
};

using SuiteMasses =
    std::variant<RandomMasses, GapMasses, BetaMasses, LognormalMasses, NormalMasses, TiedMasses>;

struct SuiteDescription {
  std::string id;
  SizeUnit unit;
  std::variant<ListedSieves, GeometricSieves> sieves;
  CountRange classes;
  std::vector<SuiteMasses> masses; ///< each line has one of them
  unsigned digits;                 ///< shares are multiples of 10^-digits of the whole
};

/// Reads a description in JSON; every number may be a string, too.
/// \throws InputError with the file and the line of what is no JSON, else with the file and the member
SuiteDescription read_suite_description(std::string_view json, std::string_view file);

} // namespace mdm
