// What all bounds of a tolerance say together of the shares of consecutive classes (Theorem 17). What comes
// in are bounds on single shares, on what passes, and on the total; what goes out is the least and the
// greatest share of any classes i to j, with the conditions that add up to it, or conditions that
// contradict each other.
//
// Sieves are the nodes of a graph: P_b - P_a >= w M is an edge from a to b of the length w, and bounds that
// follow are longest paths. Most edges lie between neighbours; all others touch one of two hubs, the finest
// sieve for what passes, and one that a total has. So a longest path is one along neighbours, with a hub or
// two on it: sums along the neighbours and the paths from and to each hub are made in a few passes over the
// classes, and each question is answered from them.
//
// If paths still grow after as many passes as there are nodes, there is a cycle of positive length: no
// shares meet all bounds, and the cycle's edges are the proof.

#include "match/share_closure.hpp"

#include "number/common_denominator.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// All numbers of a tolerance, so that they are integers in one unit.
std::vector<Rational> all_shares(const TolerantProblem &problem) {
  std::vector<Rational> all;
  const Tolerance &tolerance = problem.tolerance();
  for (const std::vector<ShareBounds> *bounds : {&tolerance.retained, &tolerance.passing})
    for (const ShareBounds &b : *bounds) {
      all.push_back(b.lo);
      all.push_back(b.hi);
    }
  if (tolerance.total) {
    all.emplace_back(*tolerance.total / 2);
    all.insert(all.end(), problem.target().begin(), problem.target().end());
  }
  return all;
}

Integer in_units(const Rational &share, const Integer &unit) {
  return numerator(share) * (unit / denominator(share));
}

} // namespace

ShareClosure::ShareClosure(const TolerantProblem &problem)
    : k_(problem.classes()), unit_(CommonDenominator(all_shares(problem)).denominator), up_(k_), down_(k_),
      sum_up_(k_ + 1), sum_down_(k_ + 1), missing_down_(k_ + 1),
      has_total_(problem.tolerance().total.has_value()) {
  add_edges(problem);
  for (std::size_t j = 0; j < k_; ++j) {
    sum_up_[j + 1] = sum_up_[j] + edges_[*up_[j]].weight;
    sum_down_[j + 1] = sum_down_[j] + (down_[j] ? edges_[*down_[j]].weight : Integer(0));
    missing_down_[j + 1] = missing_down_[j] + (down_[j] ? 0 : 1);
  }
  for (std::size_t h = 0; h < (has_total_ ? 2U : 1U) && !contradicts(); ++h) {
    find_paths(from_[h], h == 0 ? 0 : k_ + 1, false);
    if (!contradicts())
      find_paths(to_[h], h == 0 ? 0 : k_ + 1, true);
  }
}

/// In an order in which few passes lead from a hub to all nodes, and backwards from all nodes to a hub.
void ShareClosure::add_edges(const TolerantProblem &problem) {
  const Tolerance &tolerance = problem.tolerance();
  edges_.push_back({0, k_, unit_, std::nullopt});
  for (std::size_t j = 0; j < tolerance.passing.size(); ++j)
    if (tolerance.passing[j].lo > 0)
      edges_.push_back({0, j + 1, in_units(tolerance.passing[j].lo, unit_), TolerantCondition::passing_lo});
  std::vector<Integer> passing{0}; // of the gradation
  for (std::size_t j = 0; j < k_ && has_total_; ++j)
    passing.push_back(passing.back() + in_units(problem.target()[j], unit_));
  for (std::size_t j = 0; j < passing.size() && has_total_; ++j)
    edges_.push_back({k_ + 1, j, passing[j] - in_units(Rational(*tolerance.total / 2), unit_), std::nullopt});
  add_neighbours(tolerance);
  for (std::size_t j = 0; j < passing.size() && has_total_; ++j)
    edges_.push_back({j, k_ + 1, -passing[j], std::nullopt});
  for (std::size_t j = 0; j < tolerance.passing.size(); ++j)
    if (tolerance.passing[j].hi < 1)
      edges_.push_back({j + 1, 0, -in_units(tolerance.passing[j].hi, unit_), TolerantCondition::passing_hi});
  edges_.push_back({k_, 0, -unit_, std::nullopt});
}

void ShareClosure::add_neighbours(const Tolerance &tolerance) {
  const auto bounds = [&](std::size_t j) {
    return tolerance.retained.empty() ? ShareBounds{} : tolerance.retained[j];
  };
  for (std::size_t j = 0; j < k_; ++j) {
    const Rational lo = bounds(j).lo;
    up_[j] = edges_.size();
    edges_.push_back({j, j + 1, in_units(lo, unit_),
                      lo > 0 ? TolerantCondition::retained_lo : TolerantCondition::above_lower});
  }
  for (std::size_t j = k_; j-- > 0;)
    if (const Rational hi = bounds(j).hi; hi < 1) {
      down_[j] = edges_.size();
      edges_.push_back({j + 1, j, -in_units(hi, unit_), TolerantCondition::retained_hi});
    }
}

void ShareClosure::find_paths(Paths &paths, std::size_t hub, bool to_hub) {
  paths.length.resize(k_ + 2);
  paths.edge.resize(k_ + 2);
  paths.length[hub] = 0;
  constexpr int enough = 4; // passes, where there is no cycle
  for (int pass = 0;; ++pass) {
    bool changed = false;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const std::size_t e = to_hub ? edges_.size() - 1 - i : i;
      changed = relax(paths, edges_[e], e, to_hub) || changed;
    }
    if (!changed || (pass >= enough && find_cycle(paths, to_hub)))
      return;
  }
}

/// True if the edge makes a path longer.
bool ShareClosure::relax(Paths &paths, const Edge &edge, std::size_t number, bool to_hub) const {
  const std::size_t near = to_hub ? edge.to : edge.from, far = to_hub ? edge.from : edge.to;
  if (!paths.length[near])
    return false;
  Integer longer = *paths.length[near] + edge.weight;
  if (paths.length[far] && longer <= *paths.length[far])
    return false;
  paths.length[far] = std::move(longer);
  paths.edge[far] = number;
  return true;
}

/// True if following the paths' edges leads into a cycle: its weight is positive, as each of them made a path
/// longer.
bool ShareClosure::find_cycle(const Paths &paths, bool to_hub) {
  const auto next = [&](std::size_t node) -> std::optional<std::size_t> {
    if (!paths.edge[node])
      return std::nullopt;
    const Edge &edge = edges_[*paths.edge[node]];
    return to_hub ? edge.to : edge.from;
  };
  std::vector<std::size_t> seen(k_ + 2, 0); // the walk that came by
  for (std::size_t start = 0; start < k_ + 2; ++start) {
    std::optional<std::size_t> node = start;
    for (; node && seen[*node] == 0; node = next(*node))
      seen[*node] = start + 1;
    if (!node || seen[*node] != start + 1)
      continue;
    const std::size_t first = *node;
    do {
      cycle_.push_back(*paths.edge[*node]);
      node = next(*node);
    } while (*node != first);
    if (!to_hub)
      std::reverse(cycle_.begin(), cycle_.end());
    return true;
  }
  return false;
}

std::optional<Integer> ShareClosure::along_neighbours(std::size_t a, std::size_t b) const {
  if (a <= b)
    return sum_up_[b] - sum_up_[a];
  if (missing_down_[a] != missing_down_[b])
    return std::nullopt;
  return sum_down_[a] - sum_down_[b];
}

ShareClosure::Way ShareClosure::best_path(std::size_t a, std::size_t b) const {
  Way best = Way::finest;
  if (has_total_ && length(Way::total, a, b) > length(best, a, b))
    best = Way::total;
  const std::optional<Integer> along = along_neighbours(a, b);
  return along && *along >= length(best, a, b) ? Way::neighbours : best;
}

Integer ShareClosure::length(Way way, std::size_t a, std::size_t b) const {
  if (way == Way::neighbours)
    return *along_neighbours(a, b);
  const std::size_t h = way == Way::finest ? 0 : 1;
  return *to_[h].length[a] + *from_[h].length[b];
}

ShareClosure::Path ShareClosure::path(std::size_t a, std::size_t b) const {
  Path path;
  const Way way = best_path(a, b);
  if (way == Way::neighbours) {
    for (std::size_t node = a; node < b; ++node)
      path.push_back(*up_[node]);
    for (std::size_t node = a; node > b; --node)
      path.push_back(*down_[node - 1]);
    return path;
  }
  const std::size_t h = way == Way::finest ? 0 : 1;
  for (std::size_t node = a; node != hub(way); node = edges_[path.back()].to)
    path.push_back(*to_[h].edge[node]);
  Path behind;
  for (std::size_t node = b; node != hub(way); node = edges_[behind.back()].from)
    behind.push_back(*from_[h].edge[node]);
  path.insert(path.end(), behind.rbegin(), behind.rend());
  return path;
}

std::vector<ShareCondition> ShareClosure::conditions_of_lo(std::size_t i, std::size_t j) const {
  return conditions(path(i, j + 1));
}

std::vector<ShareCondition> ShareClosure::conditions_of_hi(std::size_t i, std::size_t j) const {
  return conditions(path(j + 1, i));
}

/// The conditions of a path or a cycle. An edge to the hub of a total is one with the edge behind it: the
/// excesses of the classes between the two sieves, or of all others, are at most half of the total.
std::vector<ShareCondition> ShareClosure::conditions(const Path &path) const {
  std::vector<ShareCondition> all;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Edge &edge = edges_[path[i]];
    if (edge.condition)
      all.push_back({*edge.condition, std::max(edge.from, edge.to) - 1});
    if (edge.to != k_ + 1)
      continue;
    const std::size_t to = edges_[path[(i + 1) % path.size()]].to;
    const auto [least, most] = std::minmax(edge.from, to);
    all.push_back({TolerantCondition::excess_total, 0});
    for (std::size_t j = 0; j < k_; ++j)
      all.push_back({(least <= j && j < most) == (to < edge.from) ? TolerantCondition::excess
                                                                  : TolerantCondition::excess_sign,
                     j});
  }
  return all;
}

Rational ShareClosure::weight_of_contradiction() const {
  Integer weight = 0;
  for (const std::size_t e : cycle_)
    weight += edges_[e].weight;
  return ratio(weight, unit_);
}

} // namespace mdm
