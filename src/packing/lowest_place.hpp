#pragma once
/// \file
/// The lowest place on all of the surface.

#include "packing/surface_walk.hpp"

#include <utility>
#include <vector>

namespace mdm::packing {

/// The gap that a disc keeps from what carries it, in units.
constexpr double usual_gap = 4;

/// By a walk along all of the surface.
Rest lowest_on_whole_surface(const Front &front, FloorRule floor, double q);

/// The same place, found without looking at most of the surface.
///
/// A separator is a disc of the front on whose top every disc of the set can lie, with nothing above. The
/// vertical rays from separators cut the surface into blocks. For each block and each class of radii a bound
/// is kept: no disc of the class can have its bottom lower in the block. The bottom of the lowest place never
/// goes down when the disc grows (a smaller disc fits into a larger one, at its bottom) nor when discs are
/// added; so a bound that was found for the least radius of a class remains one. It is brought up to date
/// only where it is the least of all.
class LowestPlace {
public:
  LowestPlace(const Front &front, FloorRule floor, double least_radius, double greatest_radius);

  /// \param r the disc's radius; its gap is usual_gap
  Rest find(double r);
  /// Takes note of a disc that was added to the front.
  void added(Id disc);

private:
  /// A part of the surface, and its neighbours.
  struct Block {
    Id begin; ///< a separator, or the left wall
    std::size_t previous, next;
  };
  /// Bounds of one class of radii, one for each block.
  struct Class {
    double radius; ///< the least
    std::vector<double> bound;
    std::vector<std::uint8_t> stale;
  };

  Class &class_of(double r);
  Rest look(std::size_t block, double q) const;
  bool is_hidden(Id separator, double dx, Id by) const;
  bool is_separator(Id disc) const;
  std::size_t block_over(double x) const;
  void split(std::size_t block, Id separator);
  void remove_hidden(Id by);
  void join_previous(std::size_t block);
  void make_stale(std::size_t block);

  const Front &front_;
  FloorRule floor_;
  double least_q_, greatest_q_;
  std::vector<Block> blocks_;
  std::vector<double> begin_x_; ///< of each block
  std::vector<Class> classes_;
  std::size_t found_ = 0; ///< the block of the place that was found last
  std::vector<std::pair<std::size_t, double>> looked_at_;
};

} // namespace mdm::packing
