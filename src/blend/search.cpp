// The search for the best blends in steps (Theorem 22 (c)). What comes in is the problem; what goes out,
// one at a call, are blends in the stated order, and the tree of all splits, which is the proof.
//
// Branch and bound over boxes of counts l <= n <= u. Each open box has the least value that real shares
// allow in it, by an exact linear program. Invariant: every blend that was not given out is in an open box.
// The box that comes first is taken; if its shares are whole steps, nothing can be better, and it is a
// blend. Else it is split at a share that is no whole step, or, where too many stockpiles have a share, at
// one that need not. A blend that was given out is cut out of its box.
//
// Boxes with the value of a known blend are put in order by their first shares, so that of several best
// blends the stated one comes first. It ends because there are finitely many counts, and each split parts
// them.

#include "blend/search.hpp"

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

Rational fraction_of(const Rational &r) {
  return r - Rational(floor(r));
}

} // namespace

BlendSearch::BlendSearch(const BlendProblem &problem, const Watch &watch, std::uint64_t node_limit)
    : problem_(problem), relaxation_(problem, watch), node_limit_(node_limit), tree_(1) {
  try {
    open({whole_box(problem), {}});
  } catch (const Simplex::Interrupted &) {
    is_limited_ = true;
  }
}

Rational BlendSearch::share(std::uint64_t count) const {
  return ratio(count, problem_.steps);
}

/// The counts of shares that are multiples of a step, of few enough stockpiles.
std::optional<BlendSearch::Counts> BlendSearch::blend_at(const std::vector<Rational> &shares) const {
  Counts counts;
  std::size_t used = 0;
  for (const Rational &share : shares) {
    const Rational count = share * problem_.steps;
    if (denominator(count) != 1)
      return std::nullopt;
    counts.push_back(numerator(count).convert_to<std::uint64_t>());
    used += counts.back() > 0;
  }
  if (problem_.at_most && used > *problem_.at_most)
    return std::nullopt;
  return counts;
}

/// Lets the shares of the relaxation be those of the box.
void BlendSearch::bound(const Box &box) {
  for (std::size_t i = 0; i < box.least.size(); ++i)
    relaxation_.bound_share(i, share(box.least[i]), share(box.most[i]));
}

void BlendSearch::open(Box box) {
  if (!restrict_box(problem_, box))
    return;
  bound(box);
  const std::optional<Rational> value = relaxation_.least_value();
  if (!value)
    return;
  Key key = {*value};
  if (problem_.aim == BlendAim::none) { // all have the same value, and the shares are all of the order
    box.shares = relaxation_.first_shares();
    key.insert(key.end(), box.shares.begin(), box.shares.end());
  } else {
    box.shares = relaxation_.some_shares();
  }
  open_.emplace(std::move(key), std::move(box));
}

/// Looks for the first shares of an open box.
void BlendSearch::order(Open::iterator place) {
  bound(place->second);
  Key key = {relaxation_.least_value().value()};
  Box box = place->second;
  box.shares = relaxation_.first_shares();
  key.insert(key.end(), box.shares.begin(), box.shares.end());
  open_.erase(place);
  open_.emplace(std::move(key), std::move(box));
}

/// Splits a box at a count; neither half is opened.
std::pair<BlendSearch::Box, BlendSearch::Box> BlendSearch::halves(const Box &box, std::size_t stockpile,
                                                                  std::uint64_t at) {
  tree_[box.number] = {stockpile, at, tree_.size()};
  Box below = box, above = box;
  below.most[stockpile] = at;
  below.number = tree_.size();
  above.least[stockpile] = at + 1;
  above.number = tree_.size() + 1;
  tree_.resize(tree_.size() + 2);
  return {std::move(below), std::move(above)};
}

/// Splits an open box: where a share lies nearest to the middle of a step, or, if all are whole, where a
/// stockpile has the smallest share and need not have one.
void BlendSearch::split(Open::iterator place) {
  const Box &box = place->second;
  std::optional<std::size_t> stockpile;
  Rational nearest;
  for (std::size_t i = 0; i < box.least.size(); ++i) {
    const Rational distance = abs(fraction_of(box.shares[i] * problem_.steps) - ratio(1, 2));
    if (distance < ratio(1, 2) && (!stockpile || distance < nearest)) {
      stockpile = i;
      nearest = distance;
    }
  }
  std::uint64_t at = 0;
  if (stockpile) {
    at = floor(box.shares[*stockpile] * problem_.steps).convert_to<std::uint64_t>();
  } else {
    for (std::size_t i = 0; i < box.least.size(); ++i)
      if (box.least[i] == 0 && box.shares[i] > 0 && (!stockpile || box.shares[i] < box.shares[*stockpile]))
        stockpile = i;
    assert(stockpile);
  }
  auto [below, above] = halves(box, *stockpile, at);
  open(std::move(below));
  open(std::move(above));
  open_.erase(place); // not before: were the work interrupted, its bound would be lost
}

/// Opens all of the box but one blend.
void BlendSearch::exclude(Box box, const Counts &counts) {
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (box.least[i] < counts[i]) {
      auto [below, above] = halves(box, i, counts[i] - 1);
      open(std::move(below));
      box = std::move(above);
    }
    if (counts[i] < box.most[i]) {
      auto [below, above] = halves(box, i, counts[i]);
      open(std::move(above));
      box = std::move(below);
    }
  }
}

std::optional<BlendSearch::Counts> BlendSearch::next() {
  try {
    if (last_) {
      exclude(std::move(last_->first), last_->second);
      last_.reset();
    }
    while (!open_.empty() && !is_limited_) {
      const auto first = open_.begin();
      const bool is_ordered = first->first.size() > 1;
      std::optional<Counts> counts = blend_at(first->second.shares);
      if (counts && is_ordered) {
        last_.emplace(std::move(first->second), *counts);
        open_.erase(first);
        return counts;
      }
      if (counts)
        known_ = first->first.front();
      if (!is_ordered && known_ == first->first.front()) {
        order(first);
        continue;
      }
      if (splits() >= node_limit_) {
        is_limited_ = true;
        break;
      }
      split(first);
    }
  } catch (const Simplex::Interrupted &) {
    is_limited_ = true;
  }
  return std::nullopt;
}

std::optional<Rational> BlendSearch::least_value() const {
  return open_.empty() ? std::nullopt : std::optional<Rational>(open_.begin()->first.front());
}

std::optional<BlendSearch::Counts> BlendSearch::seen() const {
  for (const auto &[key, box] : open_)
    if (std::optional<Counts> counts = blend_at(box.shares))
      return counts;
  return std::nullopt;
}

} // namespace mdm
