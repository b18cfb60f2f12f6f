#include "windows.hpp"

#include <algorithm>
#include <utility>

namespace mdm::checker::tolerant {
namespace {

/// Bounds on what passes, of the classes 0 to k in share units: those of the tolerance, and what follows from
/// the classes between.
std::vector<std::pair<mpz_class, mpz_class>>
bounds_on_passing(const Problem &problem, const std::vector<std::pair<mpz_class, mpz_class>> &retained) {
  const std::size_t k = problem.classes.size();
  std::vector<std::pair<mpz_class, mpz_class>> bounds(k + 1);
  mpz_class G = 0;
  for (std::size_t j = 1; j < k; ++j) {
    const Class &c = problem.classes[j - 1];
    G += c.share[g];
    bounds[j] = {std::max<mpz_class>(c.share[p], G - problem.half_total),
                 std::min<mpz_class>(c.share[P], G + problem.half_total)};
  }
  bounds[k] = {problem.share_unit, problem.share_unit};
  for (std::size_t j = 1; j <= k; ++j) {
    bounds[j].first = std::max<mpz_class>(bounds[j].first, bounds[j - 1].first + retained[j - 1].first);
    bounds[j].second = std::min<mpz_class>(bounds[j].second, bounds[j - 1].second + retained[j - 1].second);
  }
  for (std::size_t j = k - 1; j > 0; --j) {
    bounds[j].first = std::max<mpz_class>(bounds[j].first, bounds[j + 1].first - retained[j].second);
    bounds[j].second = std::min<mpz_class>(bounds[j].second, bounds[j + 1].second - retained[j].first);
  }
  return bounds;
}

mpz_class floor_of(const mpz_class &numerator, const mpz_class &denominator) {
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  return result;
}

/// A window's ends in mass units, each a fraction; S is infinite where S_num is 0.
struct Ends {
  mpz_class s_num, s_den, S_num, S_den;
  Ends(const Window &window, const mpz_class &mass_unit) {
    const mpq_class s = window.s * mass_unit, S = window.S * mass_unit;
    s_num = s.get_num();
    s_den = s.get_den();
    S_num = S.get_num();
    S_den = S.get_den();
  }
};

/// A class in a window: its counts, the shares y that so many particles can have, and the greatest value of
/// c y + e q - mu (y - g)^+. Shares are multiples of 1 / D, D the share unit times the ends' numerators.
class ClassInWindow {
public:
  ClassInWindow(const Class &c, const mpz_class &l, const mpz_class &h, const Ends &ends,
                const mpz_class &share_unit, const Bounds &counts)
      : s_(ends.s_num > 0 ? ends.s_num : mpz_class(1)), S_(ends.S_num > 0 ? ends.S_num : mpz_class(1)),
        l_(l * s_ * S_), h_(h * s_ * S_), g_(c.share[g] * s_ * S_), least_(counts.least) {
    if (ends.s_num > 0)
      up_to_ = c.F * ends.s_den * share_unit * S_;
    if (ends.S_num > 0)
      above_ = c.f * ends.S_den * share_unit * s_;
    if (l_ > 0)
      least_ = std::max<mpz_class>(least_, up_to_ > 0 ? mpz_class(l_ / up_to_ + 1) : mpz_class(1));
    if (h_ <= 0)
      most_ = 0;
    else if (above_ > 0)
      most_ = (h_ - 1) / above_;
    if (counts.most >= 0)
      most_ = std::min<mpz_class>(most_.value_or(counts.most), counts.most);
  }

  bool is_empty() const { return most_ && least_ > *most_; }
  bool has_most() const { return most_.has_value(); }

  /// The greatest value, and whether a point of the class has it: ends that are those of f and F are open.
  struct Greatest {
    std::optional<mpz_class> value;
    bool is_reached = false;
  };

  /// c is in units of D c y, e in those of q, mu in those of D (y - g)^+. The greatest value is concave in q
  /// and linear between the counts that are looked at. \pre not empty, and e <= 0 where there is no most
  Greatest greatest(const mpz_class &c, const mpz_class &e, const mpz_class &mu) const {
    Greatest best;
    const auto look = [&](const mpz_class &q) {
      if (q >= least_ && (!most_ || q <= *most_))
        include(best, q, c, e, mu);
    };
    const auto look_around = [&](const mpz_class &share, const mpz_class &of_one) {
      if (of_one <= 0)
        return;
      const mpz_class q = floor_of(share, of_one);
      look(q);
      look(q + 1);
    };
    look(least_);
    if (most_)
      look(*most_);
    look(1);
    look_around(h_, up_to_);
    look_around(l_, above_);
    if (mu > 0) {
      look_around(g_, up_to_);
      look_around(g_, above_);
    }
    return best;
  }

private:
  /// The greatest value with q particles.
  void include(Greatest &best, const mpz_class &q, const mpz_class &c, const mpz_class &e,
               const mpz_class &mu) const {
    const mpz_class of_q = e * q;
    const auto see = [&](const mpz_class &y, bool is_reached) {
      mpz_class value = of_q + c * y;
      if (y > g_)
        value -= mu * (y - g_);
      if (!best.value || value > *best.value)
        best = {std::move(value), is_reached};
      else if (value == *best.value)
        best.is_reached = best.is_reached || is_reached;
    };
    if (q == 0)
      return see(0, true);
    const mpz_class of_f = q * above_, of_F = q * up_to_;
    const mpz_class low = std::max(l_, of_f), high = up_to_ > 0 ? std::min(h_, of_F) : h_;
    // Without an upper end of the window y > 0 is all that f demands, and l > 0 more than that.
    see(low, of_f < l_);
    see(high, up_to_ == 0 || of_F > h_);
    if (low < g_ && g_ < high)
      see(g_, true);
    // Where both ends and all between have the same value, what is between reaches it.
    if (low < high && is_flat(c, mu, low, high))
      see(low, true);
  }
  bool is_flat(const mpz_class &c, const mpz_class &mu, const mpz_class &low, const mpz_class &high) const {
    return (c == 0 && (mu == 0 || high <= g_)) || (c == mu && low >= g_);
  }

  mpz_class s_, S_;
  mpz_class above_ = 0, up_to_ = 0; ///< one particle's share is above f / S and up to F / s; 0: any
  mpz_class l_, h_, g_;
  mpz_class least_;
  std::optional<mpz_class> most_;
};

} // namespace

/// The sum of a leaf's conditions: sum (c_j y_j + e_j q_j) - mu sum (y_j - g_j)^+ >= right, with c and mu in
/// share units.
struct Windows::Sum {
  std::vector<mpz_class> c, e; ///< of class j at j - 1
  mpz_class mu = 0;
  mpq_class right = 0;
};

Windows::Windows(const Problem &problem, const Certificate &certificate)
    : problem_(problem), certificate_(certificate) {
  std::vector<std::pair<mpz_class, mpz_class>> retained;
  for (const Class &c : problem.classes)
    retained.emplace_back(std::max<mpz_class>(c.share[r], c.share[g] - problem.half_total),
                          std::min<mpz_class>(c.share[R], c.share[g] + problem.half_total));
  const auto passing = bounds_on_passing(problem, retained);
  for (std::size_t j = 0; j < retained.size(); ++j)
    of_share_.push_back({std::max<mpz_class>(retained[j].first, passing[j + 1].first - passing[j].second),
                         std::min<mpz_class>(retained[j].second, passing[j + 1].second - passing[j].first)});
}

Windows::Sum Windows::add_up(const std::vector<Multiple> &leaf, const Window &window,
                             const CountsInForce &counts) const {
  const std::size_t k = problem_.classes.size();
  const mpz_class &unit = problem_.share_unit;
  // What conditions have at P_j and at q_1 + ... + q_j, until the end.
  Sum sum{std::vector<mpz_class>(k), std::vector<mpz_class>(k)};
  mpz_class weight = 0, shares_right = 0, counts_right = 0;
  for (const Multiple &multiple : leaf) {
    const mpz_class &m = multiple.m;
    const std::uint64_t i = multiple.classes.i, j = multiple.classes.j;
    demand(j <= k, "window: a class of the gradation", j);
    const Class &c = problem_.classes[j == 0 ? 0 : j - 1];
    const auto of_passing = [&](std::size_t last, const mpz_class &times, const mpz_class &right) {
      sum.c[last - 1] += times * unit;
      shares_right += times * right;
    };
    const auto of_counts = [&](const mpz_class &times, const mpz_class &right) {
      sum.e[(j == 0 ? k : j) - 1] += times;
      if (i > 1)
        sum.e[i - 2] -= times;
      counts_right += m * right;
    };
    switch (multiple.condition) {
    case 't': // y_1 + ... + y_k >= 1
      of_passing(k, m, unit);
      break;
    case 'T': // -(y_1 + ... + y_k) >= -1
      of_passing(k, -m, unit);
      break;
    case 'p': // y_1 + ... + y_j >= lo_j
      of_passing(j, m, c.share[p]);
      break;
    case 'P': // -(y_1 + ... + y_j) >= -hi_j
      of_passing(j, -m, c.share[P]);
      break;
    case 'E': // -sum (y_j - g_j)^+ >= -e / 2
      sum.mu += m * unit;
      shares_right -= m * problem_.half_total;
      break;
    case 'w': // sum y_j / c_j >= w / S
      weight += m;
      break;
    case 'n': // sum q >= max(1, M')
      of_counts(m, least_of_all(certificate_));
      break;
    case 'N': // -sum q >= -(B - 1)
      of_counts(-m, minus_most_of_all(certificate_));
      break;
    case 's': // N_ij >= the bound in force
      of_counts(m, counts.of(multiple.classes).least);
      break;
    default: { // S: -N_ij >= minus the bound in force
      const mpz_class most = counts.of(multiple.classes).most;
      demand(most >= 0, "window: S where the sum is bounded", j);
      of_counts(-m, -most);
    }
    }
  }
  for (std::size_t j = k - 1; j > 0; --j) {
    sum.c[j - 1] += sum.c[j];
    sum.e[j - 1] += sum.e[j];
  }
  for (std::size_t j = 0; j < k; ++j)
    sum.c[j] += weight * problem_.classes[j].share[Share::weight];
  sum.right = mpq_class(shares_right, unit);
  sum.right.canonicalize();
  sum.right += counts_right;
  if (window.S > 0)
    sum.right += weight * problem_.w / window.S;
  return sum;
}

void Windows::refute(const std::vector<Multiple> &leaf, const Window &window,
                     const CountsInForce &counts) const {
  const Sum sum = add_up(leaf, window, counts);
  const Ends ends(window, problem_.mass_unit);
  std::vector<ClassInWindow> classes;
  for (std::size_t j = 0; j < of_share_.size(); ++j)
    classes.emplace_back(problem_.classes[j], of_share_[j].l, of_share_[j].h, ends, problem_.share_unit,
                         counts.classes[j]);
  if (std::any_of(classes.begin(), classes.end(), [](const ClassInWindow &c) { return c.is_empty(); }))
    return;
  const mpz_class D = problem_.share_unit * (ends.s_num > 0 ? ends.s_num : mpz_class(1)) *
                      (ends.S_num > 0 ? ends.S_num : mpz_class(1));
  const mpz_class value_unit = D * problem_.share_unit;
  mpz_class greatest = 0;
  bool is_reached = true;
  for (std::size_t j = 0; j < classes.size(); ++j) {
    demand(sum.e[j] <= 0 || classes[j].has_most(), "window: a greatest count where particles add", j + 1);
    const auto of_class = classes[j].greatest(sum.c[j], sum.e[j] * value_unit, sum.mu);
    greatest += *of_class.value;
    is_reached = is_reached && of_class.is_reached;
  }
  const mpq_class right = sum.right * value_unit;
  demand(greatest < right || (greatest == right && !is_reached),
         "window: the greatest sum of all classes is a contradiction");
}

} // namespace mdm::checker::tolerant
