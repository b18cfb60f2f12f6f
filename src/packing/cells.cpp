// The cells of the contact graph. What comes in are discs and their contacts; what goes out is each least
// polygon of discs that touch one after the other, with its corners counterclockwise.
//
// The edges at each disc are sorted counterclockwise, exactly, by the signs of cross products. Along an
// edge the next one of the cell on its left is the edge at its end that comes just before the way back.
// Each directed edge is in one cell, and is passed once: the walk ends when all are. A cell that is passed
// clockwise is the outside of a part of the graph, or what is open to the floor, a wall or above, and is
// none.

#include "packing/contacts.hpp"
#include "packing/wide.hpp"

#include <algorithm>

namespace mdm {
namespace {

using packing::Wide;

/// A contact seen from one of its discs.
struct Edge {
  std::int32_t to;
  std::int64_t dx, dy;
  std::size_t contact;

  bool is_upper() const { return dy > 0 || (dy == 0 && dx > 0); }
  /// Counterclockwise, from the direction of x on.
  bool operator<(const Edge &other) const {
    if (is_upper() != other.is_upper())
      return is_upper();
    return Wide{dx} * other.dy > Wide{dy} * other.dx;
  }
};

/// The contact graph; each disc's edges are counterclockwise.
class Graph {
public:
  Graph(std::size_t discs, const std::vector<DiscContact> &pairs)
      : begin_(discs + 1), edges_(2 * pairs.size()) {
    for (const DiscContact &c : pairs) {
      ++begin_[static_cast<std::size_t>(c.a) + 1];
      ++begin_[static_cast<std::size_t>(c.b) + 1];
    }
    for (std::size_t i = 1; i < begin_.size(); ++i)
      begin_[i] += begin_[i - 1];
    std::vector<std::size_t> next = begin_;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const DiscContact &c = pairs[i];
      edges_[next[static_cast<std::size_t>(c.a)]++] = {c.b, c.dx, c.dy, i};
      edges_[next[static_cast<std::size_t>(c.b)]++] = {c.a, -c.dx, -c.dy, i};
    }
    for (std::size_t i = 0; i < discs; ++i)
      std::sort(edges_.begin() + static_cast<std::ptrdiff_t>(begin_[i]),
                edges_.begin() + static_cast<std::ptrdiff_t>(begin_[i + 1]));
  }

  std::size_t size() const { return edges_.size(); }
  const Edge &edge(std::size_t e) const { return edges_[e]; }

  /// The next edge around the cell on the left.
  std::size_t following(std::size_t e) const {
    const auto at = static_cast<std::size_t>(edges_[e].to);
    for (std::size_t i = begin_[at]; i < begin_[at + 1]; ++i)
      if (edges_[i].contact == edges_[e].contact && edges_[i].dx == -edges_[e].dx &&
          edges_[i].dy == -edges_[e].dy)
        return i == begin_[at] ? begin_[at + 1] - 1 : i - 1;
    return e;
  }

private:
  std::vector<std::size_t> begin_; ///< of each disc's edges
  std::vector<Edge> edges_;
};

} // namespace

void each_cell(const Packing &p, const PackingContacts &contacts,
               const std::function<void(const std::vector<CellCorner> &)> &take) {
  const Graph graph(p.discs.size(), contacts.pairs);
  std::vector<std::uint8_t> seen(graph.size());
  std::vector<CellCorner> corners;
  for (std::size_t first = 0; first < graph.size(); ++first) {
    if (seen[first] != 0)
      continue;
    corners.clear();
    Wide area = 0;
    std::int64_t x = 0, y = 0;
    for (std::size_t e = first; seen[e] == 0; e = graph.following(e)) {
      seen[e] = 1;
      const Edge &edge = graph.edge(e);
      area += Wide{x} * edge.dy - Wide{y} * edge.dx;
      x += edge.dx;
      y += edge.dy;
      corners.push_back({edge.to, x, y});
    }
    // The outer boundary goes around clockwise, or around the period.
    if (area <= 0 || x != 0 || y != 0)
      continue;
    const PackedDisc &last = p.discs[static_cast<std::size_t>(corners.back().disc)];
    for (CellCorner &c : corners) {
      c.x += last.x;
      c.y += last.y;
    }
    take(corners);
  }
}

} // namespace mdm
