#pragma once
/// \file
/// The discs that bound a deposit from above.

#include <cmath>
#include <cstdint>
#include <vector>

namespace mdm::packing {

/// A disc by its number, a wall or the floor.
using Id = std::int32_t;

/// A piece of the floor as a support.
constexpr Id the_floor = -1;

/// The outer boundary of a deposit: from the left wall to the right one, or around one period, a chain of
/// discs each of which touches the next or has a bare piece of the floor behind it. Lengths are whole numbers
/// of units, kept in doubles.
class Front {
public:
  /// \param radii of all discs in the order in which they come
  Front(std::vector<double> radii, double width, bool periodic);

  double x(Id disc) const { return x_[index(disc)]; }
  double y(Id disc) const { return y_[index(disc)]; }
  double r(Id disc) const { return r_[index(disc)]; }
  double width() const { return width_; }
  bool periodic() const { return periodic_; }
  Id left_wall() const { return discs_; }
  Id right_wall() const { return discs_ + 1; }
  bool is_wall(Id id) const { return id >= discs_; }

  /// No disc lies yet.
  bool is_empty() const { return length_ == 0; }
  /// Discs of the chain.
  std::size_t length() const { return length_; }
  /// The next of the chain: a disc or the right wall.
  Id next(Id id) const { return next_[index(id)]; }
  /// A member of the chain: the left wall, or any disc where there is none.
  Id first() const { return first_; }
  /// The disc of the chain whose top is the highest; the first of several. \pre !is_empty()
  Id highest() const;
  /// The height of the lowest centre in the chain. \pre !is_empty()
  double lowest_centre() const;

  /// The member of the chain behind which the floor is bare at x. \pre there is one
  Id before_bare_floor(double x) const;

  /// Lays a disc on two supports, the_floor among them, and takes out of the chain what it closes off.
  void insert(Id disc, double x, double y, Id left, Id right);

  /// x moved into the first period.
  double wrapped(double x) const {
    if (periodic_) {
      while (x < 0)
        x += width_;
      while (x >= width_)
        x -= width_;
    }
    return x;
  }

  /// Calls take(disc, dx) for every disc of the chain whose centre is at x + dx, |dx| < its radius + reach;
  /// for each of its images where it is repeated.
  template <class Take>
  void each_near(double x, double reach, const Take &take) const;

private:
  /// Discs of the chain by x, of radii within a factor of 2.
  struct Row {
    double greatest; ///< no radius is greater
    double bucket;   ///< width of a bucket
    std::vector<std::vector<Id>> buckets;
  };

  static std::size_t index(Id id) { return static_cast<std::size_t>(id); }
  void make_rows();
  std::vector<Id> &bucket_of(Id disc);
  void remove_between(Id after, Id before);
  void link(Id left, Id right, bool bare_floor);
  double distance_right(Id from, Id to) const;

  Id discs_;
  double width_;
  bool periodic_;
  Id first_;
  std::size_t length_ = 0;
  std::vector<double> x_, y_, r_;
  std::vector<Id> next_;
  std::vector<std::uint8_t> bare_; ///< the floor is bare behind it
  double smallest_;
  std::vector<Row> rows_;
};

template <class Take>
void Front::each_near(double x, double reach, const Take &take) const {
  for (const Row &row : rows_) {
    const auto n = static_cast<std::int64_t>(row.buckets.size());
    auto low = static_cast<std::int64_t>(std::floor((x - reach - row.greatest) / row.bucket));
    auto high = static_cast<std::int64_t>(std::floor((x + reach + row.greatest) / row.bucket));
    if (!periodic_) {
      low = low < 0 ? 0 : low;
      high = high >= n ? n - 1 : high;
    }
    std::int64_t period = low >= 0 ? low / n : -((n - 1 - low) / n);
    std::int64_t at = low - period * n;
    for (std::int64_t b = low; b <= high; ++b) {
      const double shift = static_cast<double>(period) * width_ - x;
      for (const Id disc : row.buckets[static_cast<std::size_t>(at)]) {
        const double dx = x_[index(disc)] + shift;
        if (std::fabs(dx) < r_[index(disc)] + reach)
          take(disc, dx);
      }
      if (++at == n) {
        at = 0;
        ++period;
      }
    }
  }
}

} // namespace mdm::packing
