// Shares y_j with sum 1 whose convex costs are least, in doubles, with bounds on the sums of the first j.
// What comes in are pieces of constant slope; what goes out are shares, and prices that show that none are
// cheaper.
//
// One sweep over the classes. Of the classes so far the pieces that are open, neither taken nor given up,
// are kept sorted by slope, between the least and the greatest sum that they allow. Where that sum must be
// greater the cheapest of them are taken, where it must be smaller the dearest are given up, and the slope
// at which that ends is a bound on the price there. At the end, where the sum is 1, nothing is open;
// walking back through these bounds gives each class its price.

#include "match/share_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mdm {
namespace {

constexpr double unbounded_slope = std::numeric_limits<double>::infinity();
/// Shares are wrong by less.
constexpr double share_noise = 1e-13;

/// Goes over the classes. The sum of their shares, as far as it is open, is between `left` and `right`, and
/// the pieces between are sorted by their slopes: a sum further to the right has the cheapest of them.
class ShareSweep {
public:
  ShareSweep(const ShareCosts &costs, const std::vector<ShareBand> &bands)
      : costs_(costs), bands_(bands), k_(bands.size()), from_(k_, -unbounded_slope),
        up_to_(k_, unbounded_slope) {
    found_.y = costs.least;
    found_.particles.assign(k_, 0);
    open_.reserve(costs.pieces.size());
  }

  CheapShares run() {
    std::size_t next = 0;
    for (std::size_t j = 0; j < k_; ++j) {
      left_ += costs_.least[j];
      right_ += costs_.least[j];
      for (; next < costs_.pieces.size() && costs_.pieces[next].j == j; ++next) {
        open_.push_back(costs_.pieces[next]);
        right_ += costs_.pieces[next].length;
      }
      if (!keep_band(j))
        return std::move(found_);
    }
    found_.exist = true;
    set_prices();
    return std::move(found_);
  }

private:
  bool keep_band(std::size_t j) {
    const ShareBand &band = bands_[j];
    if (right_ < band.lo - share_noise)
      return contradict(after_right_, j, 1);
    if (left_ > band.hi + share_noise)
      return contradict(after_left_, j, -1);
    if (left_ < band.lo)
      take(j, band.lo);
    if (right_ > band.hi && (band.hi < 1 || j + 1 == k_))
      cut(j, band.hi);
    return true;
  }

  bool contradict(std::size_t from, std::size_t to, double sign) {
    found_.prices.assign(k_, 0);
    for (std::size_t j = from; j <= to; ++j)
      found_.prices[j] = sign;
    return false;
  }

  void sort() {
    const auto cheaper = [](const SharePiece &a, const SharePiece &b) { return a.slope < b.slope; };
    const auto middle = open_.begin() + static_cast<std::ptrdiff_t>(sorted_);
    std::sort(middle, open_.end(), cheaper);
    std::inplace_merge(open_.begin() + static_cast<std::ptrdiff_t>(first_), middle, open_.end(), cheaper);
    sorted_ = open_.size();
  }

  /// Takes the cheapest pieces until the sum is `least` for certain.
  void take(std::size_t j, double least) {
    sort();
    double slope = -unbounded_slope;
    while (left_ < least && first_ < open_.size()) {
      SharePiece &piece = open_[first_];
      const double part = std::min(piece.length, least - left_);
      slope = piece.slope;
      found_.y[piece.j] += part;
      found_.particles[piece.j] += part * piece.particles;
      found_.cost += part * piece.slope;
      found_.excess += part * piece.excess;
      left_ += part;
      piece.length -= part;
      if (piece.length > 0)
        break;
      ++first_;
    }
    left_ = least;
    from_[j] = slope;
    after_left_ = j + 1;
  }

  /// Gives up the dearest pieces until the sum is at most `most`.
  void cut(std::size_t j, double most) {
    sort();
    double slope = unbounded_slope;
    while (right_ > most && open_.size() > first_) {
      SharePiece &piece = open_.back();
      const double part = std::min(piece.length, right_ - most);
      slope = piece.slope;
      right_ -= part;
      piece.length -= part;
      if (piece.length > 0)
        break;
      open_.pop_back();
    }
    sorted_ = open_.size();
    right_ = most;
    left_ = std::min(left_, right_);
    up_to_[j] = slope;
    after_right_ = j + 1;
  }

  /// What a further share costs at the end; before, no less than what had to be taken, no more than what was
  /// given up.
  void set_prices() {
    found_.prices.resize(k_);
    double price = std::isfinite(from_.back())    ? from_.back()
                   : std::isfinite(up_to_.back()) ? up_to_.back()
                                                  : 0;
    for (std::size_t j = k_; j-- > 0;) {
      if (j + 1 < k_)
        price = std::min(std::max(price, from_[j]), std::max(from_[j], up_to_[j]));
      found_.prices[j] = price;
    }
  }

  const ShareCosts &costs_;
  const std::vector<ShareBand> &bands_;
  std::size_t k_;
  std::vector<SharePiece> open_;
  std::size_t first_ = 0,
              sorted_ = 0; ///< of the open pieces: those before are taken; those before are sorted
  double left_ = 0, right_ = 0;
  std::size_t after_left_ = 0, after_right_ = 0; ///< first class behind the last band that moved an end
  std::vector<double> from_, up_to_;             ///< slopes at the ends that bands moved
  CheapShares found_;
};

} // namespace

CheapShares cheapest_shares(const ShareCosts &costs, const std::vector<ShareBand> &bands) {
  return ShareSweep(costs, bands).run();
}

} // namespace mdm
