#pragma once
/// \file
/// Published blending problems: what passes the stockpiles, limits, costs.

#include <mdm/blend/blend_problem.hpp>
#include <mdm/number/decimal.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace mdm_test {

/// A problem of a table with a line a sieve, from the coarsest on: its size in mm, the limits, and what
/// passes each stockpile.
inline mdm::BlendProblem problem_of(const std::vector<std::string> &names, const std::string &table) {
  mdm::BlendProblem p;
  for (const std::string &name : names)
    p.stockpiles.push_back({name, {}, 0, 1, 0});
  std::istringstream lines(table);
  std::string word;
  const auto number = [&lines, &word] {
    lines >> word;
    return mdm::parse_decimal(word);
  };
  while (lines >> word) {
    mdm::BlendSieve sieve{mdm::parse_decimal(word), 0, 100, {}};
    sieve.least = number();
    sieve.most = number();
    p.sieves.insert(p.sieves.begin(), sieve);
    for (mdm::Stockpile &s : p.stockpiles)
      s.passing.insert(s.passing.begin(), number());
  }
  return p;
}

/// tutorsglobe.com, question 52609483: four stockpiles with their costs.
inline mdm::BlendProblem four_stockpiles() {
  mdm::BlendProblem p = problem_of({"A", "B", "C", "D"}, R"(
    18 100 100 100 100 100 100
    16 95 100 92 100 100 95
    12.5 70 85 59.8 100 95.7 80
    5 40 50 5.9 95.8 95.2 45
    2 30 38 2.5 59.5 94.9 35
    0.9 27 33 2.3 42 94.6 35
    0.4 22 28 2.2 31.2 84.1 35
    0.16 6 10 1.7 19.3 14.7 20
    0.071 3 6 1.2 11.5 4.4 15
  )");
  p.aim = mdm::BlendAim::cost;
  const std::vector<std::string> costs = {"7.00", "10.82", "9.51", "8.88"};
  for (std::size_t i = 0; i < costs.size(); ++i)
    p.stockpiles[i].cost = mdm::parse_decimal(costs[i]);
  return p;
}

/// askfilo.com, question 3337313538323130, where the answer is marked as verified.
inline mdm::BlendProblem verified_but_impossible() {
  return problem_of({"A", "B"}, R"(
    19 100 100 100 100
    12.5 80 90 90 100
    9.5 70 90 59 100
    4.75 50 70 16 96
    2.36 35 50 3 82
    0.6 18 29 0 51
    0.3 13 23 0 36
    0.15 8 16 0 21
    0.075 7 10 0 9
  )");
}

/// homeworksource.com, 1073790; published answer: 45 % and 55 %.
inline mdm::BlendProblem two_stockpiles() {
  return problem_of({"1", "2"}, R"(
    19 100 100 100 100
    12.5 95 100 100 98
    9.5 0 90 100 77
    2.36 34 50 100 9
    0.075 2 10 12 0
  )");
}

/// Missouri DOT, form 501 (scribd.com, 246412070), with the shares and the combined curve.
inline mdm::BlendProblem missouri() {
  return problem_of({"F", "C", "I"}, R"(
    50 0 100 100 100 100
    37.5 0 100 100 100 100
    25 0 100 100 100 100
    19 0 100 100 95 100
    12.5 0 100 100 47 100
    9.5 0 100 100 23 99
    4.75 0 100 97 8.5 9
    2.36 0 100 81 4.5 4
    1.18 0 100 77 3.9 3.6
    0.6 0 100 42 3.2 3.2
    0.3 0 100 7 2.6 2.6
    0.15 0 100 0.6 1.9 2.4
    0.075 0 100 0.2 1.3 2
  )");
}

/// Thai DOH, P-AC/245/2568, cold bins (demo-project.js of ittiponttc-KMUTNB/Asphalt-Mix-design); published:
/// 45, 30, 25 %.
inline mdm::BlendProblem cold_bins() {
  return problem_of({"dust", "3/8", "3/4"}, R"(
    37.5 0 100 100 100 100
    25 0 100 100 100 100
    19 100 100 100 100 100
    12.5 80 100 100 100 26.5
    9.5 0 100 100 100 2.5
    4.75 44 74 97.1 43.5 0.5
    2.36 28 58 75.3 13.8 0.3
    1.18 0 100 51.8 8.2 0
    0.6 0 100 35.2 5.4 0
    0.3 5 21 24.0 0 0
    0.15 0 100 17.6 0 0
    0.075 2 10 13.4 0 0
  )");
}

/// The same, hot bins; published: 42, 20, 18, 20 %.
inline mdm::BlendProblem hot_bins() {
  return problem_of({"H1", "H2", "H3", "H4"}, R"(
    37.5 0 100 100 100 100 100
    25 0 100 100 100 100 100
    19 100 100 100 100 100 100
    12.5 80 100 100 88.4 25.2 94.0
    9.5 0 100 100 35.3 0.7 40.0
    4.75 44 74 97.0 16.0 0.4 3.0
    2.36 28 58 77.3 1.1 0.2 0
    1.18 0 100 54.3 0.2 0 0
    0.6 0 100 36.3 0.2 0 0
    0.3 5 21 23.4 0 0 0
    0.15 0 100 15.9 0 0 0
    0.075 2 10 12.5 0 0 0
  )");
}

} // namespace mdm_test
