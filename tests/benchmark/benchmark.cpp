/// \file
/// Speed, as ratios measured in one run. The suite is that of the paper's study, 2,750 gradations.

#include "answer/answer.hpp"
#include "match/least_match.hpp"
#include "match/problem_of.hpp"
#include "match/tolerant_match.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/proof/certificate.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace mdm;

const std::vector<std::string> &suite_lines() {
  static const std::vector<std::string> lines = [] {
    std::vector<std::string> all;
    std::ifstream file(MDM_SUITE);
    for (std::string line; std::getline(file, line);)
      all.push_back(line);
    return all;
  }();
  return lines;
}

std::vector<Problem> suite_problems() {
  std::vector<Problem> problems;
  for (const std::string &line : suite_lines())
    problems.emplace_back(read_json_gradation(line, "suite", ""), MassLaw{}, 1);
  return problems;
}

/// The sweep in plain double: what a program without certain answers would do. It leaves counts and a chain
/// too.
struct Twin {
  struct Class {
    double lower, per_upper, upper_per_lower;
  };
  std::vector<Class> classes;

  explicit Twin(const SweepProblem<Int128> &p) {
    for (const SweepClass<Int128> &c : p.classes)
      classes.push_back({c.lower, c.per_upper, c.F.to_double() / c.f.to_double()});
  }

  std::pair<std::vector<double>, Steps> solve() const {
    std::pair<std::vector<double>, Steps> result;
    double level = 0;
    std::uint32_t highest = 0;
    std::vector<std::uint32_t> movable;
    for (std::uint32_t j = 0; j < classes.size(); ++j) {
      if (classes[j].lower > level) {
        level = classes[j].lower;
        highest = j;
      }
      if (classes[j].upper_per_lower < 2)
        movable.push_back(j);
    }
    result.second.push_back(highest);
    for (bool moved = true; moved;) {
      moved = false;
      std::size_t kept = 0;
      for (std::size_t i = 0; i < movable.size(); ++i) {
        const Class &c = classes[movable[i]];
        const double n = std::floor(level * c.per_upper) + 1;
        if (n * c.lower > level) {
          level = n * c.lower;
          result.second.push_back(movable[i]);
          moved = true;
        }
        if (n * c.upper_per_lower < n + 1)
          movable[kept++] = movable[i];
      }
      movable.resize(kept);
    }
    for (const Class &c : classes)
      result.first.push_back(std::floor(level * c.per_upper) + 1);
    return result;
  }
};

/// The whole suite from prepared integers, exactly and with the chain.
void exact_sweep(benchmark::State &state) {
  std::vector<SweepProblem<Int128>> prepared;
  for (const Problem &p : suite_problems())
    prepared.emplace_back(p);
  for (auto _ : state)
    for (const SweepProblem<Int128> &p : prepared)
      benchmark::DoNotOptimize(sweep(p));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(prepared.size()));
}
BENCHMARK(exact_sweep)->Unit(benchmark::kMillisecond);

void double_twin(benchmark::State &state) {
  std::vector<Twin> prepared;
  for (const Problem &p : suite_problems())
    prepared.emplace_back(SweepProblem<Int128>(p));
  for (auto _ : state)
    for (const Twin &p : prepared)
      benchmark::DoNotOptimize(p.solve());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(prepared.size()));
}
BENCHMARK(double_twin)->Unit(benchmark::kMillisecond);

/// From gradations to prepared integers.
void preparation(benchmark::State &state) {
  std::vector<Gradation> gradations;
  for (const std::string &line : suite_lines())
    gradations.push_back(read_json_gradation(line, "suite", ""));
  for (auto _ : state)
    for (const Gradation &g : gradations)
      benchmark::DoNotOptimize(SweepProblem<Int128>(Problem(g, MassLaw{}, 1)));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(gradations.size()));
}
BENCHMARK(preparation)->Unit(benchmark::kMillisecond);

/// What `mdm batch` does with a line: parse, solve, sizes with 20 digits, answer.
void batch_line(benchmark::State &state) {
  SolveOptions options;
  options.digits = 20;
  for (auto _ : state)
    for (const std::string &line : suite_lines())
      benchmark::DoNotOptimize(answer_json(solve(read_json_gradation(line, "suite", "1"), {}, options)));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(suite_lines().size()));
}
BENCHMARK(batch_line)->Unit(benchmark::kMillisecond);

/// n classes from `finest` to `coarsest`, geometric, with ten-digit openings and masses of no pattern.
Gradation geometric(std::size_t n, double coarsest) {
  Gradation::Data data;
  for (std::size_t j = 0; j <= n; ++j) {
    const double x = std::pow(coarsest, static_cast<double>(j) / static_cast<double>(n));
    data.sizes.push_back(ratio(Integer(static_cast<std::int64_t>(std::llround(x * 1e10))), power_of_ten(10)));
    data.masses.emplace_back(j == n ? 0 : 1 + static_cast<int>(j * 7919 % 1009));
  }
  return Gradation(std::move(data));
}

/// 8 classes whose bounds are 1e-6 apart: hundreds of thousands of steps.
void narrow_classes(benchmark::State &state) {
  Gradation::Data data;
  for (int j = 0; j <= 8; ++j) {
    data.sizes.push_back(1 + ratio(j, 1000000));
    data.masses.emplace_back(j == 8 ? 0 : 11 + j * j % 7);
  }
  const Problem problem(Gradation(std::move(data)), {}, 1);
  std::size_t steps = 0;
  for (auto _ : state)
    steps = least_match(problem).chain.size();
  state.counters["steps"] = static_cast<double>(steps);
}
BENCHMARK(narrow_classes)->Unit(benchmark::kMillisecond);

void number_of_classes(benchmark::State &state) {
  const Problem problem(geometric(static_cast<std::size_t>(state.range(0)), 1e5), {}, 1);
  std::size_t steps = 0;
  for (auto _ : state)
    steps = least_match(problem).chain.size();
  state.counters["steps"] = static_cast<double>(steps);
}
BENCHMARK(number_of_classes)->RangeMultiplier(10)->Range(10, 100000)->Unit(benchmark::kMillisecond);

/// What is at most the part `part` of the values.
double quantile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

/// Quartiles and the end of what was measured, one value a gradation.
void report(benchmark::State &state, const std::string &what, const std::vector<double> &values) {
  for (const auto &[name, part] :
       {std::pair{"25%", 0.25}, {"50%", 0.5}, {"75%", 0.75}, {"99%", 0.99}, {"max", 1.0}})
    state.counters[what + "_" + name] = quantile(values, part);
}

/// The smallest matches of the suite within a tolerance, with the text of each proof.
void within_tolerance(benchmark::State &state, const char *tolerance) {
  Question question;
  question.tolerances = {parse_tolerance(tolerance)};
  std::vector<double> ms, nodes, fewer, kilobytes;
  double closed = 0;
  for (auto _ : state)
    for (const std::string &line : suite_lines()) {
      const Gradation g = read_json_gradation(line, "suite", "");
      const std::clock_t start = std::clock();
      const Match m = solve(g, question, {});
      ms.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
      if (m.status != Status::optimal)
        state.SkipWithError("a gradation is not solved to optimality");
      nodes.push_back(static_cast<double>(std::get<Tree>(m.evidence().value()).size()));
      fewer.push_back(ratio(*solve(g, {}, {}).particles(), *m.particles()).convert_to<double>());
      kilobytes.push_back(static_cast<double>(certificate(m).size()) / 1000);
      closed += tolerant_match(tolerant_problem_of(m)).nodes == 0 ? 1 : 0;
    }
  report(state, "ms", ms);
  report(state, "tree_nodes", nodes);
  report(state, "times_fewer", fewer);
  report(state, "proof_kB", kilobytes);
  state.counters["closed_without_search"] = closed;
}
BENCHMARK_CAPTURE(within_tolerance, retained, "retained:1%")->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK_CAPTURE(within_tolerance, passing, "passing:0.5%")->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK_CAPTURE(within_tolerance, laboratory, "laboratory")->Unit(benchmark::kSecond)->Iterations(1);

/// A lognormal curve of laser diffraction as an instrument prints it: geometric classes from 1 to 1000 um of
/// four digits, median 60 um, logarithmic deviation 1, hundredths of a percent.
Gradation laser(std::size_t classes) {
  Gradation::Data data;
  std::vector<double> sizes;
  for (std::size_t j = 0; j <= classes; ++j) {
    const double x = std::pow(10, 3 * static_cast<double>(j) / static_cast<double>(classes));
    const double digit = std::pow(10, std::floor(std::log10(x) + 1e-9) - 3);
    sizes.push_back(std::round(x / digit) * digit);
    data.sizes.push_back(ratio(Integer(std::llround(sizes.back() * 1000)), 1000));
  }
  const auto passing = [&](std::size_t j) {
    return j == 0 ? 0 : j == classes ? 1 : std::erfc(-std::log(sizes[j] / 60) / std::sqrt(2)) / 2;
  };
  for (std::size_t j = 0; j < classes; ++j)
    data.masses.push_back(ratio(Integer(std::llround(1e4 * (passing(j + 1) - passing(j)))), 100));
  data.masses.emplace_back(0);
  return Gradation(std::move(data));
}

/// Its smallest match within a tolerance, or bounds 1e-6 apart, in 10 s; and the exact sweep.
void laser_classes(benchmark::State &state, const char *tolerance) {
  const Gradation g = laser(static_cast<std::size_t>(state.range(0)));
  Question question;
  question.tolerances = {parse_tolerance(tolerance)};
  SolveOptions options;
  options.limits.gap = ratio(1, 1000000);
  for (auto _ : state) {
    options.limits.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    const Match m = solve(g, question, options);
    state.counters["particles"] = m.particles()->convert_to<double>();
    state.counters["bound"] = m.lower_bound.convert_to<double>();
  }
  const Problem problem(g, MassLaw{}, 1);
  const std::clock_t start = std::clock();
  benchmark::DoNotOptimize(least_match(problem));
  state.counters["exact_sweep_ms"] = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}
const std::vector<std::int64_t> numbers_of_classes = {10, 20, 30, 50, 100};
BENCHMARK_CAPTURE(laser_classes, passing_1, "passing:1%")
    ->ArgsProduct({numbers_of_classes})
    ->Unit(benchmark::kSecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(laser_classes, passing_half, "passing:0.5%")
    ->ArgsProduct({numbers_of_classes})
    ->Unit(benchmark::kSecond)
    ->Iterations(1);
BENCHMARK_CAPTURE(laser_classes, retained_fifth, "retained:0.2%")
    ->ArgsProduct({numbers_of_classes})
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

} // namespace

BENCHMARK_MAIN();
