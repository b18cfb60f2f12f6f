// The fewest particles in a window of the mass, without whole numbers, in doubles. Each class is the convex
// hull of its points (share, count): of a count q, shares between q f / S and q F / s. A total and a
// demanded weight tie the classes together in one more condition each; with a price on that condition
// (Lagrange) what is left is to share out 1 among convex costs with bounds on partial sums, which
// share_program.cpp does by sorting slopes.
//
// The best price of the excess is where the dual function has its greatest value. It is concave and
// piecewise linear: the tangents at two prices on either side of it meet at the next price, until that
// gains no more. What is found is a proposal: mass_window.cpp says what its prices prove.

#include "match/window_relaxation.hpp"

#include "match/near.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mdm {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

/// The points of one class at which its hull has corners, whatever the prices.
class ClassMenu {
public:
  struct Class {
    double f, F, target;
    ShareBand share;
    bool has_target;
  };
  ClassMenu(const Class &of, const NearWindow &window, std::size_t j) : of_(of) {
    is_point_ = !(window.above < window.up_to);
    upper_ = window.above > 0 ? of.F / window.above : 0;
    lower_ = std::isfinite(window.up_to) ? of.f / window.up_to : 0;
    least_ = window.least[j];
    most_ = window.most[j];
    if (of.share.lo > 0) {
      const double n = upper_ > 0 ? of.share.lo / upper_ : 0;
      least_ = std::max(least_, is_point_ ? std::ceil(n * (1 - 1e-14)) : std::floor(n) + 1);
    }
    if (!(of.share.hi > 0))
      most_ = 0;
    else if (lower_ > 0)
      most_ = std::min(most_, std::ceil(of.share.hi / lower_) - 1);
  }

  /// In order of their shares. Empty if there are none.
  void add_to(std::vector<MenuPoint> &points) const {
    if (least_ > most_)
      return;
    std::array<double, 11> counts{};
    std::size_t n = 0;
    const auto add = [&](double q) {
      if (q >= least_ && q <= most_ && std::isfinite(q))
        counts[n++] = q;
    };
    const auto beside = [&](double share, double of_one) {
      if (of_one > 0) {
        add(std::floor(share / of_one));
        add(std::floor(share / of_one) + 1);
      }
    };
    add(least_);
    add(most_);
    add(1);
    beside(of_.share.hi, upper_);
    beside(of_.share.lo, lower_);
    if (of_.has_target) {
      beside(of_.target, upper_);
      beside(of_.target, lower_);
    }
    std::sort(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(n));
    const std::size_t first = points.size();
    for (std::size_t i = 0; i < n; ++i)
      if (i == 0 || counts[i] != counts[i - 1])
        add_count(points, counts[i]);
    std::sort(points.begin() + static_cast<std::ptrdiff_t>(first), points.end(),
              [](const MenuPoint &a, const MenuPoint &b) { return a.share < b.share; });
  }

private:
  void add_count(std::vector<MenuPoint> &points, double q) const {
    if (q == 0) {
      points.push_back({0, 0});
      return;
    }
    const double low = std::max(of_.share.lo, q * lower_);
    const double high = upper_ > 0 ? std::min(of_.share.hi, q * upper_) : of_.share.hi;
    if (low > high)
      return;
    points.push_back({low, q});
    points.push_back({high, q});
    if (of_.has_target && low < of_.target && of_.target < high)
      points.push_back({of_.target, q});
  }

  const Class &of_;
  double upper_, lower_, least_, most_;
  bool is_point_;
};

} // namespace

NearWindow::NearWindow(const MassWindow &window, const CountBounds &bounds)
    : above(near(window.above)), up_to(window.up_to ? near(*window.up_to) : no_bound) {
  for (const CountBound &bound : bounds) {
    least.push_back(near(bound.least));
    most.push_back(bound.most ? near(*bound.most) : no_bound);
  }
}

WindowPrices WindowPoint::exact_prices() const {
  constexpr double most_digits = 16;
  double greatest = std::max({prices.particles, prices.at_least, prices.excess, prices.weight, 1.0});
  for (const double share : prices.shares)
    greatest = std::max(greatest, std::fabs(share));
  const double scale = std::pow(10.0, std::max(0.0, most_digits - std::ceil(std::log10(greatest))));
  const auto whole = [scale](double price) { return Integer(std::round(price * scale)); };
  WindowPrices exact{
      {}, whole(prices.excess), whole(prices.weight), whole(prices.particles), whole(prices.at_least)};
  for (const double share : prices.shares)
    exact.shares.push_back(whole(share));
  return exact;
}

/// The points of all classes in a window.
struct WindowRelaxation::Menus {
  std::vector<MenuPoint> points;
  std::vector<std::size_t> end; ///< of each class's points
  double demanded = 0;          ///< sum of y_j / c_j
};

/// The cheapest point at prices.
struct WindowRelaxation::Priced {
  double excess_price = 0, weight_price = 0;
  double value = no_bound; ///< infinite where there is no solution
  double too_much_excess = 0, missing_weight = 0;
  CheapShares shares; ///< with the particles of the classes
};

WindowRelaxation::WindowRelaxation(const TolerantProblem &problem, const MassWindows &windows)
    : problem_(problem), k_(problem.classes()),
      half_total_(problem.tolerance().total ? near(*problem.tolerance().total) / 2 : no_bound),
      weight_(problem.weight() ? near(*problem.weight()) : 0) {
  const std::vector<ShareBounds> &passing = problem.tolerance().passing;
  for (std::size_t j = 0; j < k_; ++j) {
    f_.push_back(near(problem.f(j)));
    F_.push_back(near(problem.F(j)));
    target_.push_back(near(problem.target()[j]));
    per_mass_.push_back(near(problem.per_mass(j)));
    shares_.push_back({near(windows.shares()[j].lo), near(windows.shares()[j].hi)});
    bands_.push_back(passing.empty() ? ShareBand{} : ShareBand{near(passing[j].lo), near(passing[j].hi)});
  }
  bands_.back() = {1, 1};
}

/// False if a class has no points.
bool WindowRelaxation::make_menus(Menus &menus, const NearWindow &window) const {
  menus.demanded = std::isfinite(window.up_to) ? weight_ / window.up_to : 0;
  for (std::size_t j = 0; j < k_; ++j) {
    const ClassMenu::Class of{f_[j], F_[j], target_[j], shares_[j], std::isfinite(half_total_)};
    ClassMenu(of, window, j).add_to(menus.points);
    if (menus.points.size() == (menus.end.empty() ? 0 : menus.end.back()))
      return false;
    menus.end.push_back(menus.points.size());
  }
  return true;
}

/// The cheapest shares where particles cost 1 (`most`: -1, `any`: nothing), and an excess or a weight its
/// price.
WindowRelaxation::Priced WindowRelaxation::priced(const Menus &menus, Aim aim, double excess_price,
                                                  double weight_price) const {
  const double of_count = aim == Aim::fewest ? 1 : aim == Aim::most ? -1 : 0;
  struct Corner {
    double share, count, excess, cost;
  };
  Priced found;
  found.excess_price = excess_price;
  found.weight_price = weight_price;
  ShareCosts costs;
  std::vector<double> particles;
  double base = 0, excess = 0;
  std::vector<Corner> hull;
  for (std::size_t j = 0; j < k_; ++j) {
    hull.clear();
    for (std::size_t i = j == 0 ? 0 : menus.end[j - 1]; i < menus.end[j]; ++i) {
      const MenuPoint &point = menus.points[i];
      const double above = std::isfinite(half_total_) ? std::max(0.0, point.share - target_[j]) : 0;
      const Corner next{point.share, point.count, above,
                        of_count * point.count + excess_price * above -
                            weight_price * per_mass_[j] * point.share};
      if (!hull.empty() && hull.back().share >= next.share) {
        if (hull.back().cost <= next.cost)
          continue;
        hull.pop_back();
      }
      while (hull.size() >= 2) {
        const Corner &a = hull[hull.size() - 2], &b = hull.back();
        if ((b.cost - a.cost) * (next.share - a.share) < (next.cost - a.cost) * (b.share - a.share))
          break;
        hull.pop_back();
      }
      hull.push_back(next);
    }
    costs.least.push_back(hull.front().share);
    particles.push_back(hull.front().count);
    base += hull.front().cost;
    excess += hull.front().excess;
    for (std::size_t i = 1; i < hull.size(); ++i) {
      const Corner &a = hull[i - 1], &b = hull[i];
      const double length = b.share - a.share;
      costs.pieces.push_back({(b.cost - a.cost) / length, length, (b.count - a.count) / length,
                              (b.excess - a.excess) / length, j});
    }
  }
  found.shares = cheapest_shares(costs, bands_);
  if (!found.shares.exist)
    return found;
  double weight = 0;
  for (std::size_t j = 0; j < k_; ++j) {
    found.shares.particles[j] += particles[j];
    weight += per_mass_[j] * found.shares.y[j];
  }
  found.too_much_excess = std::isfinite(half_total_) ? excess + found.shares.excess - half_total_ : 0;
  found.missing_weight = menus.demanded - weight;
  found.value = base + found.shares.cost + weight_price * menus.demanded -
                (std::isfinite(half_total_) ? excess_price * half_total_ : 0);
  return found;
}

namespace {

/// The greatest value of a concave function of a price >= 0. `at(price)` is what there is at a price, `rise`
/// how its value rises there. Where the value is greatest, two of them meet, whose mixture is `mix`ed.
template <class Found, class At, class Rise, class Price, class Mix>
Found best_price(const At &at, const Rise &rise, const Price &price, const Mix &mix, double start,
                 double enough) {
  constexpr int most_tries = 60;
  constexpr double precise = 1e-10;
  Found low = at(0.0);
  if (!(rise(low) > 0) || !(low.value < enough))
    return low;
  Found high = at(start);
  for (int i = 0; i < most_tries && rise(high) > 0 && high.value < enough; ++i) {
    const double next = 4 * price(high);
    low = std::move(high);
    high = at(next);
  }
  if (rise(high) > 0 || !(high.value < no_bound))
    return high;
  Found best = low.value > high.value ? low : high;
  for (int i = 0; i < most_tries; ++i) {
    const double width = price(high) - price(low);
    const double step = (high.value - low.value - rise(high) * width) / (rise(low) - rise(high));
    const double top = low.value + rise(low) * step;
    if (!(step > 0 && step < width) || top - best.value <= precise * std::max(1.0, std::fabs(top)))
      break;
    Found middle = at(price(low) + step);
    if (middle.value > best.value)
      best = middle;
    (rise(middle) > 0 ? low : high) = std::move(middle);
  }
  mix(best, low, high, rise(low) / (rise(low) - rise(high)));
  return best;
}

} // namespace

WindowRelaxation::Priced WindowRelaxation::best_excess_price(const Menus &menus, double weight_price,
                                                             double start, double enough) const {
  const auto mix = [this](Priced &best, const Priced &low, const Priced &high, double part) {
    CheapShares mixed = best.shares;
    for (std::size_t j = 0; j < k_; ++j) {
      mixed.y[j] = low.shares.y[j] + part * (high.shares.y[j] - low.shares.y[j]);
      mixed.particles[j] =
          low.shares.particles[j] + part * (high.shares.particles[j] - low.shares.particles[j]);
    }
    best.missing_weight = low.missing_weight + part * (high.missing_weight - low.missing_weight);
    best.shares = std::move(mixed);
  };
  return best_price<Priced>([&](double price) { return priced(menus, Aim::fewest, price, weight_price); },
                            [](const Priced &of) { return of.too_much_excess; },
                            [](const Priced &of) { return of.excess_price; }, mix, start, enough);
}

WindowPoint WindowRelaxation::minimise(const NearWindow &window, double enough, double excess_price) const {
  WindowPoint point;
  point.particles = no_bound;
  point.prices.shares.assign(k_, 0);
  Menus menus;
  if (!make_menus(menus, window)) {
    point.prices.particles = 0;
    return point;
  }
  const auto refute = [&](const Priced &by, double at_least = 0) {
    point.prices = {0, at_least, by.excess_price, by.weight_price, by.shares.prices};
    return point;
  };
  Priced best = priced(menus, Aim::fewest, 0, 0);
  if (!best.shares.exist)
    return refute(best);
  if (best.too_much_excess > 0)
    if (const Priced least = priced(menus, Aim::any, 1, 0); least.value > 0)
      return refute(least);
  if (best.missing_weight > 0)
    if (const Priced heaviest = priced(menus, Aim::any, 0, 1); heaviest.value > 0)
      return refute(heaviest);
  const double first_price =
      excess_price > 0 ? excess_price / 1.5 : std::max(best.value, 1.0) / std::max(half_total_, 1e-9);
  const auto at_weight = [&](double price) {
    return best_excess_price(menus, price, std::isfinite(half_total_) ? first_price : 1, enough);
  };
  if (best.too_much_excess > 0 || best.missing_weight > 0) {
    const auto mix = [](Priced &, const Priced &, const Priced &, double) {};
    best = best_price<Priced>(
        at_weight, [](const Priced &of) { return of.missing_weight; },
        [](const Priced &of) { return of.weight_price; }, mix,
        std::max(best.value, 1.0) / std::max(menus.demanded, 1e-300), enough);
  }
  const double at_least = near(problem_.at_least());
  if (best.value < at_least && at_least > 1 && std::isfinite(window.up_to) && f_.front() > 0)
    if (const Priced most = priced(menus, Aim::most, 0, 0); - most.value < at_least)
      return refute(most, 1);
  point.particles = std::max(best.value, at_least);
  if (best.value >= at_least)
    point.prices = {1, 0, best.excess_price, best.weight_price, best.shares.prices};
  else
    point.prices.at_least = 1;
  point.counts = std::move(best.shares.particles);
  point.shares = std::move(best.shares.y);
  return point;
}

std::vector<double> WindowRelaxation::shares_of(const std::vector<double> &counts, double mass) const {
  constexpr double margin = 1e-12;
  ShareCosts costs;
  double excess = 0;
  for (std::size_t j = 0; j < k_; ++j) {
    double low = 0, high = 0;
    if (counts[j] > 0) {
      low = std::max(shares_[j].lo, counts[j] * f_[j] / mass);
      high = std::min(shares_[j].hi, counts[j] * F_[j] / mass);
      if (low > high)
        return {};
      const double inward = margin * (high - low);
      low += inward;
      high -= inward;
    } else if (shares_[j].lo > 0) {
      return {};
    }
    costs.least.push_back(low);
    const double target = std::isfinite(half_total_) ? std::clamp(target_[j], low, high) : high;
    if (std::isfinite(half_total_))
      excess += std::max(0.0, low - target_[j]);
    if (target > low)
      costs.pieces.push_back({0, target - low, 0, 0, j});
    if (high > target)
      costs.pieces.push_back({1, high - target, 0, 1, j});
  }
  std::vector<ShareBand> bands = bands_;
  for (std::size_t j = 0; j + 1 < k_; ++j) {
    const double inward = margin * (bands[j].hi - bands[j].lo);
    bands[j].lo += bands[j].lo > 0 ? inward : 0;
    bands[j].hi -= bands[j].hi < 1 ? inward : 0;
  }
  CheapShares found = cheapest_shares(costs, bands);
  if (!found.exist || excess + found.cost > half_total_)
    return {};
  return std::move(found.y);
}

} // namespace mdm
