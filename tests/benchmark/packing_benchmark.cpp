/// \file
/// Packings: the search by blocks against the walk along all of the surface, and the count of a gasket.

#include "packing/apollonian.hpp"
#include "packing/deposit.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <vector>

namespace {

using namespace mdm;

/// n diameters from 1 to 4 (a span of 0.6), uniform by volume.
DiscSizes discs(std::uint64_t n) {
  constexpr std::uint64_t parts = 1000000, ratio = 4;
  DiscSizes d;
  std::uint64_t state = 1;
  for (std::uint64_t i = 0; i < n; ++i) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    const std::uint64_t u = (state >> 33) % parts;
    d.sizes.push_back({parts * parts * ratio / (parts * ratio - u * (ratio - 1)), 6});
  }
  return d;
}

void deposited(benchmark::State &state, DepositSearch search) {
  const DiscSizes sizes = discs(static_cast<std::uint64_t>(state.range(0)));
  DepositOptions options;
  options.search = search;
  for (auto _ : state)
    benchmark::DoNotOptimize(deposit(sizes, options).front);
  state.counters["discs_per_second"] =
      benchmark::Counter(static_cast<double>(state.range(0)), benchmark::Counter::kIsIterationInvariantRate);
}

void blocks(benchmark::State &state) {
  deposited(state, DepositSearch::blocks);
}
BENCHMARK(blocks)
    ->Unit(benchmark::kSecond)
    ->Iterations(1)
    ->Arg(25000)
    ->Arg(50000)
    ->Arg(100000)
    ->Arg(200000)
    ->Arg(400000)
    ->Arg(1000000);

void full_walk(benchmark::State &state) {
  deposited(state, DepositSearch::full_walk);
}
BENCHMARK(full_walk)->Unit(benchmark::kSecond)->Iterations(1)->Arg(25000)->Arg(50000)->Arg(100000);

/// What ApollonianGasket::census finds of a gasket.
struct Census {
  std::uint64_t circles = 0;
  double inverse_squares = 0;
  std::array<std::uint64_t, 64> octaves{};

  void add(double k, double most) {
    ++circles;
    inverse_squares += 1 / (k * k);
    ++octaves.at(static_cast<std::size_t>(std::ilogb(most / k)));
  }
};

/// The gasket of three equal circles in plain doubles, without proof.
Census in_doubles(double most) {
  struct Open {
    std::array<double, 4> k;
    int last;
  };
  std::vector<Open> open{{{3 - 2 * 1.7320508075688772, 1, 1, 1}, -1}};
  Census census;
  for (int i = 0; i < 3; ++i)
    census.add(1, most);
  while (!open.empty()) {
    const Open at = open.back();
    open.pop_back();
    const double sum = at.k[0] + at.k[1] + at.k[2] + at.k[3];
    for (int i = 0; i < 4; ++i) {
      const double k = 2 * sum - 3 * at.k.at(static_cast<std::size_t>(i));
      if (i == at.last || k > most)
        continue;
      census.add(k, most);
      open.push_back({at.k, i});
      open.back().k.at(static_cast<std::size_t>(i)) = k;
    }
  }
  return census;
}

void gasket_in_doubles(benchmark::State &state) {
  for (auto _ : state)
    state.counters["circles"] = static_cast<double>(in_doubles(static_cast<double>(state.range(0))).circles);
}
BENCHMARK(gasket_in_doubles)->Unit(benchmark::kSecond)->Arg(100000);

void gasket(benchmark::State &state) {
  for (auto _ : state)
    state.counters["circles"] =
        static_cast<double>(ApollonianGasket::equal().census(Rational(state.range(0))).circles);
}
BENCHMARK(gasket)->Unit(benchmark::kSecond)->Arg(100000);

} // namespace
