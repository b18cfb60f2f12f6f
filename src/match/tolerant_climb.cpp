#include "match/tolerant_climb.hpp"

#include "match/central_masses.hpp"
#include "match/problem.hpp"

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

} // namespace

std::optional<TolerantMatch> climbed_match(const TolerantChain &chain, const std::optional<Integer> &most,
                                           const Watch &watch) {
  return Climb(chain, most, watch).run();
}

} // namespace mdm
