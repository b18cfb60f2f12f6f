#include "match/tolerant_climb.hpp"

#include "match/central_masses.hpp"
#include "match/problem.hpp"
#include "match/quick_masses.hpp"

namespace mdm {
namespace {

/// Tries masses one after the other.
class Climb {
public:
  Climb(const TolerantChain &chain, const std::optional<Integer> &most, const Watch &watch)
      : chain_(chain), most_(most), watch_(watch) {
    limits_.keep_proof = false;
    limits_.max_steps = most_chain_steps;
  }

  std::optional<TolerantMatch> run() {
    const Rational from = chain_.level();
    Rational step = from / Rational(4 * chain_.particles());
    for (int i = 0; i < most_steps && !best_ && !watch_.ends(); ++i, step *= 2)
      if (!is_below_most(Rational(from + step)))
        return std::nullopt;
    return best_;
  }

private:
  static constexpr std::uint64_t most_chain_steps = 1 << 16;
  static constexpr int most_steps = 64;

  /// Tries the differences at a mass. False if they are too many.
  bool is_below_most(const Rational &mass) {
    const TolerantChain higher(chain_.problem(), chain_.shares(), chain_.intervals().are_all(), limits_,
                               watch_, mass);
    if (higher.contradicts() || (most_ && higher.particles() >= *most_))
      return false;
    const std::vector<Integer> q = higher.differences();
    if (higher.complete() && total(q) >= chain_.problem().at_least())
      if (std::optional<std::vector<Rational>> t = masses_of(chain_.problem(), q, watch_))
        best_ = TolerantMatch{q, std::move(*t)};
    return true;
  }

  const TolerantChain &chain_;
  std::optional<Integer> most_;
  const Watch &watch_;
  Limits limits_;
  std::optional<TolerantMatch> best_;
};

/// True if the counts reach all bounds of the chain.
bool reaches_bounds(const TolerantChain &chain, const std::vector<Integer> &q) {
  const ClassIntervals &intervals = chain.intervals();
  for (std::size_t i = 0; i < q.size(); ++i) {
    Integer sum = 0;
    for (std::size_t j = i; j < q.size(); ++j) {
      sum += q[j];
      if (intervals.has(i, j) && sum < chain.count(i, j))
        return false;
    }
  }
  return true;
}

/// The vectors next to the chain's differences, those with as many particles first.
std::vector<std::vector<Integer>> neighbours(const TolerantChain &chain) {
  const std::vector<Integer> q = chain.differences();
  std::vector<std::vector<Integer>> all;
  const auto add = [&](std::size_t more, std::optional<std::size_t> less) {
    std::vector<Integer> other = q;
    ++other[more];
    if (less)
      --other[*less];
    if (reaches_bounds(chain, other))
      all.push_back(std::move(other));
  };
  for (std::size_t j = 1; j < q.size(); ++j) {
    add(j, j - 1);
    add(j - 1, j);
  }
  for (std::size_t j = 0; j < q.size(); ++j)
    add(j, std::nullopt);
  return all;
}

} // namespace

std::optional<TolerantMatch> neighbouring_match(const TolerantChain &chain, const Watch &watch) {
  for (const std::vector<Integer> &q : neighbours(chain)) {
    if (watch.ends())
      break;
    if (total(q) < chain.problem().at_least())
      continue;
    if (QuickMasses quick = quick_masses(chain.problem(), q); quick.t)
      return TolerantMatch{q, std::move(*quick.t)};
  }
  return std::nullopt;
}

std::optional<TolerantMatch> climbed_match(const TolerantChain &chain, const std::optional<Integer> &most,
                                           const Watch &watch) {
  return Climb(chain, most, watch).run();
}

} // namespace mdm
