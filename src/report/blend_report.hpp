#pragma once
/// \file
/// Blends of stockpiles as text, JSON and CSV.

#include "soil/bailey.hpp"

#include <mdm/blend/blend.hpp>

namespace mdm {

/// A mass and its unit, such as 1000 and kg.
struct NamedMass {
  Rational value;
  std::string unit;
};

/// The ratios of the Bailey method of the best blend.
struct BaileyReport {
  BaileySieves sieves;
  std::array<Rational, 4> passing; ///< percents at half, primary, secondary and tertiary sieve
  bool is_interpolated = false;    ///< between two sieves of a stockpile, linear in size
};

/// What is told of the best blends.
struct BlendReport {
  const BlendProblem &problem;
  const BlendAnswer &answer;
  std::string specification;                      ///< its name
  std::optional<NamedMass> mass;                  ///< of a blend, where steps were given in masses
  std::optional<Rational> relaxed = std::nullopt; ///< the sieve whose limits alone are widened, mm
  std::string id = {};                            ///< of the problem, in JSON; empty: none
  std::optional<BaileyReport> bailey = std::nullopt;
};

/// One line of JSON, schema `mdm-blend-1`, without a newline at its end. Exact numbers are strings `p/q`.
std::string blend_json(const BlendReport &r);

/// rank, value and the percent of each stockpile: a row a blend.
std::string blend_csv(const BlendReport &r);

/// For people.
std::string blend_text(const BlendReport &r);

} // namespace mdm
