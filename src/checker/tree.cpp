#include "law.hpp"
#include "windows.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace mdm::checker {

mpz_class tolerant::least_of_all(const Certificate &certificate) {
  return std::max<mpz_class>(1, integer_of(certificate.at_least));
}

mpz_class tolerant::minus_most_of_all(const Certificate &certificate) {
  demand(!certificate.bound.empty(), "leaf: N with a number of particles");
  return 1 - integer_of(certificate.bound);
}

namespace {

using namespace tolerant;

/// The law of openings to the power d, a/(b d), in lowest terms.
struct Law {
  unsigned long a, b;
  Law(const Gradation &gradation, const Certificate &c) : a(c.a), b(c.b * gradation.root) {
    const unsigned long common = std::gcd(a, b);
    a /= common;
    b /= common;
  }
};

/// x^(a/b) = (root_b x)^a is rational iff the root is: a and b have no common factor.
Rationals roots(const Rationals &openings, unsigned long b) {
  Rationals result;
  for (const mpq_class &x : openings) {
    const std::optional<mpq_class> root = rational_root(x, b);
    demand(root.has_value(), "a rational mass at each opening", result.size() + 1);
    result.push_back(*root);
  }
  return result;
}

/// The limits of a band, from the certificate or the gradation's file, with the size as the openings are.
std::vector<Limit> limits_of(const Gradation &gradation, const Certificate &c) {
  std::vector<Limit> limits = gradation.limits;
  for (std::size_t i = 0; i < c.band.size(); i += 3)
    limits.push_back({c.band[i].value, c.band[i + 1].value, c.band[i + 2].value});
  const mpq_class factor = c.size_factor.empty() ? mpq_class(1) : c.size_factor[0].value;
  for (Limit &limit : limits)
    limit.opening = to_power(limit.opening * factor, gradation.root, c);
  return limits;
}

/// The shares of each class, the bounds narrowed by what the lines of the tolerance demand.
std::vector<std::array<mpq_class, shares>> derive_shares(const Gradation &gradation, const Certificate &c) {
  const Rationals &x = gradation.openings;
  const std::size_t k = x.size() - 1;
  const bool has_file = !c.retained_file.empty() || !c.passing_file.empty();
  demand(!has_file || !gradation.tolerances.empty(), "a column tolerance_percent");
  demand(gradation.materials.empty() || (c.passing.empty() && c.passing_each.empty() && c.band.empty()),
         "materials: tolerances on what is retained and on the total alone");
  demand(c.passing_each.empty() || c.passing_each.size() == k - 1, "passing-each: k - 1 tolerances");
  std::vector<std::array<mpq_class, shares>> of(k, {0, 1, 0, 1, 0, 0});
  const auto narrow = [&](std::size_t j, Share lo, const mpq_class &least, const mpq_class &most) {
    of[j][lo] = std::max(of[j][lo], least);
    of[j][lo + 1] = std::min(of[j][lo + 1], most);
  };
  const Solids demanded = solids(c);
  mpq_class all = 0, G = 0;
  for (const mpq_class &mass : gradation.masses)
    all += mass;
  for (std::size_t j = 0; j < k; ++j) {
    of[j][g] = gradation.masses[j] / all;
    G += of[j][g];
    const auto narrow_around = [&](Share lo, const mpq_class &share, const mpq_class &percent) {
      narrow(j, lo, share - percent / 100, share + percent / 100);
    };
    if (demanded.enough > 0)
      of[j][weight] = 1 / gradation.factors[j];
    if (!c.retained.empty())
      narrow_around(r, of[j][g], c.retained[0].value);
    if (!c.retained_file.empty())
      narrow_around(r, of[j][g], gradation.tolerances[j]);
    if (!c.passing.empty() && j + 1 < k)
      narrow_around(p, G, c.passing[0].value);
    if (!c.passing_file.empty() && j + 1 < k)
      narrow_around(p, G, gradation.tolerances[j + 1]);
    if (!c.passing_each.empty() && j + 1 < k)
      narrow_around(p, G, c.passing_each[j].value);
  }
  for (std::size_t j = 0; j < k; ++j)
    if (!gradation.begins_class(j))
      narrow(j, r, 0, 0);
  for (const auto &[size, least, most] : limits_of(gradation, c)) {
    const auto passes = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), size) - x.begin());
    demand(size > x[0] || least == 0, "band: nothing passes the finest opening");
    demand(size <= x[0] || passes > k || x[passes] == size, "band: every sieve is an opening");
    if (size > x[0])
      narrow(std::min(passes, k) - 1, p, least / 100, most / 100);
  }
  return of;
}

/// Derives the problem; what does not fit together is Refused, what would take too long is Malformed.
Problem derive(const Gradation &gradation, const Certificate &certificate) {
  const std::vector<std::array<mpq_class, shares>> of = derive_shares(gradation, certificate);
  // The total is at most 2 for any shares.
  const mpq_class half_total = certificate.total.empty() ? mpq_class(1) : certificate.total[0].value / 200;
  mpz_class unit = half_total.get_den();
  for (const auto &class_j : of)
    for (const mpq_class &share : class_j)
      include(unit, share.get_den(), certificate);
  const Law law(gradation, certificate);
  const Rationals size = roots(measured_openings(gradation, certificate), law.b);
  const mpz_class size_unit = common_denominator(size), factor_unit = common_denominator(gradation.factors);
  const mpq_class w = solids(certificate).below;
  demand_within(work_of(gradation, certificate, of.size()) * (bits(unit) + bits(w)), 34,
                certificate); // limit 6

  Problem problem{{}, power(size_unit, law.a) * factor_unit, unit, in_units(half_total, unit), w};
  for (std::size_t j = 0; j < of.size(); ++j) {
    const mpz_class c = in_units(gradation.factors[j], factor_unit);
    Class class_j{c * power(in_units(size[j], size_unit), law.a),
                  c * power(in_units(size[j + 1], size_unit), law.a),
                  gradation.masses[j] > 0 ? integer_of(certificate.min_per_class) : mpz_class(0),
                  {}};
    if (!gradation.begins_class(j)) { // of these bounds nothing depends: it has no share (section 14)
      class_j.f = 0;
      class_j.F = 1;
    }
    for (std::size_t i = 0; i < shares; ++i)
      class_j.share[i] = in_units(of[j][i], unit);
    problem.classes.push_back(std::move(class_j));
  }
  return problem;
}

/// The particles of the witness are a match, by definition.
void verify_witness(const Problem &problem, const Gradation &gradation, const Certificate &certificate) {
  const std::size_t k = problem.classes.size();
  mpz_class unit = 1; // the masses times this are integers
  for (const ClassWitness &witness : certificate.classes)
    include(unit, witness.mass.get_den(), certificate);
  demand_within(work_of(gradation, certificate, k) * bits(unit), 34, certificate); // limit 6
  std::vector<mpz_class> q(k), t(k);
  mpz_class N = 0, M = 0;
  for (const auto &witness : certificate.classes) {
    const std::uint64_t j = witness.index;
    demand(1 <= j && j <= k, "witness: a class of the gradation", j);
    // That the size is in (x_j, x_{j+1}] says that f q < t <= F q.
    const mpq_class one = witness.mass / (witness.quantity * gradation.factors[j - 1]);
    verify_size(gradation, certificate, witness, raised(one, certificate.b), certificate.a);
    N += q[j - 1] = witness.quantity;
    M += t[j - 1] = in_units(witness.mass, unit);
  }
  mpz_class passing = 0, excess = 0, solids_volume = 0;
  for (std::size_t j = 1; j <= k; ++j) {
    const Class &c = problem.classes[j - 1];
    const mpz_class retained = t[j - 1] * problem.share_unit;
    passing += retained;
    demand(q[j - 1] >= c.least, "q >= R", j);
    demand(c.share[r] * M <= retained && retained <= c.share[R] * M, "retained", j);
    demand(c.share[p] * M <= passing && passing <= c.share[P] * M, "passing", j);
    excess += std::max<mpz_class>(0, retained - c.share[g] * M);
    solids_volume += t[j - 1] * c.share[weight];
  }
  demand(excess <= problem.half_total * M, "total");
  demand(solids_volume >= solids(certificate).enough * problem.share_unit * unit, "the volume of the solids");
  demand(N == integer_of(certificate.particles), "sum of q = N");
  demand(N >= integer_of(certificate.at_least), "N >= M");
}

/// Walks over the tree with the bounds on counts and on the mass that are in force, and adds up the leaves'
/// conditions.
class Replay {
public:
  Replay(const Problem &problem, const Certificate &certificate)
      : problem_(problem), certificate_(certificate), windows_(problem, certificate),
        alike_from_(problem.classes.size()) {
    for (std::size_t i = 0; i < problem.classes.size(); ++i) {
      const Class &c = problem.classes[i];
      counts_.classes.push_back({c.least, -1});
      const bool alike = i > 0 && c.share[weight] == problem.classes[i - 1].share[weight];
      alike_from_[i] = alike ? alike_from_[i - 1] : i + 1;
    }
  }

  void run() {
    for (const TreeNode &node : certificate_.tree) {
      if (node.is_split()) {
        enter(node);
        continue;
      }
      if (node.kind == TreeNode::window)
        windows_.refute(node.multiples, window_, counts_);
      else
        refute(node.multiples);
      // Up to the last split whose second subtree is to come, and into that.
      for (; !path_.empty() && path_.back().second; path_.pop_back())
        leave(path_.back());
      if (!path_.empty())
        enter_second(path_.back());
    }
  }

private:
  struct Branch {
    const TreeNode &split;
    Bounds *bounds; ///< of a split of counts
    bool second = false;
    Bounds counts_before{};
    Window window_before{};
  };

  void enter(const TreeNode &split) {
    if (split.kind == TreeNode::split_of_mass) {
      path_.push_back({split, nullptr, false, {}, window_});
      if (window_.S == 0 || window_.S > split.v)
        window_.S = split.v;
      return;
    }
    const auto &[i, j] = split.classes;
    demand(1 <= i && j <= counts_.classes.size(), "split: a class of the gradation", j);
    Bounds &bounds = i == j ? counts_.classes[j - 1] : counts_.ranges[split.classes];
    path_.push_back({split, &bounds, false, bounds, {}});
    if (bounds.most < 0 || bounds.most >= split.v)
      bounds.most = split.v.get_num() - 1;
  }
  void enter_second(Branch &branch) {
    leave(branch);
    branch.second = true;
    if (branch.bounds)
      branch.bounds->least = std::max<mpz_class>(branch.bounds->least, branch.split.v.get_num());
    else
      window_.s = std::max(window_.s, branch.split.v);
  }
  void leave(Branch &branch) {
    if (branch.bounds)
      *branch.bounds = branch.counts_before;
    else
      window_ = branch.window_before;
  }

  /// A condition: sum of coefficient * variable >= constant. q, t, p, P_j and the sums N_j and D_j of q and
  /// of t - f q up to class j are those of its class, or of every class where it has none; q is in mass
  /// units, M in share units.
  struct Condition {
    mpz_class q = 0, t = 0, P = 0, p = 0, M = 0, weight = 0, constant = 0;
    bool strict = false;
    mpz_class N = 0, D = 0;
  };

  /// The condition of classes i to j, i < j: what it has at N_j and D_j, and with the other sign at N_{i-1}
  /// and D_{i-1}.
  Condition condition_of_sum(char letter, const ClassRange &classes) const {
    const Bounds bounds = counts_.of(classes);
    switch (letter) {
    case 'd': // sum of t - f q >= 0, strict where there are particles
      return {.strict = bounds.least >= 1, .D = 1};
    case 's': // sum of q >= the bound in force
      return {.constant = bounds.least, .N = problem_.mass_unit};
    default: // S: minus the sum of q >= minus the bound in force
      demand(bounds.most >= 0, "leaf: S where the sum is bounded", classes.j);
      return {.constant = -bounds.most, .N = -problem_.mass_unit};
    }
  }

  /// The condition of class j, or for j = 0 of all.
  Condition condition(char letter, std::uint64_t j) const {
    const Class &c = problem_.classes[j == 0 ? 0 : j - 1];
    const Bounds &bounds = counts_.classes[j == 0 ? 0 : j - 1];
    const mpz_class &unit = problem_.mass_unit;
    switch (letter) {
    case 'f': // t_j - f_j q_j >= 0, strict where q_j >= 1
      return {.q = -c.f, .t = 1, .strict = bounds.least >= 1};
    case 'F': // F_j q_j - t_j >= 0
      return {.q = c.F, .t = -1};
    case 'q': // q_j >= the bound in force
      return {.q = unit, .constant = bounds.least};
    case 'Q': // -q_j >= minus the bound in force
      demand(bounds.most >= 0, "leaf: Q where q is bounded", j);
      return {.q = -unit, .constant = -bounds.most};
    case 'r': // t_j - lo_j M >= 0
      return {.t = 1, .M = -c.share[r]};
    case 'R': // hi_j M - t_j >= 0
      return {.t = -1, .M = c.share[R]};
    case 'p': // P_j - lo_j M >= 0
      return {.P = 1, .M = -c.share[p]};
    case 'P': // hi_j M - P_j >= 0
      return {.P = -1, .M = c.share[P]};
    case 'e': // p_j - t_j + g_j M >= 0
      return {.t = -1, .p = 1, .M = c.share[g]};
    case 'x': // p_j >= 0
      return {.p = 1};
    case 'E': // (e / 2) M - sum p >= 0
      return {.p = -1, .M = problem_.half_total};
    case 'm': // M > 0
      return {.t = 1, .strict = true};
    case 'w': // sum t / c >= w; the constant is added at the end
      return {.weight = 1};
    case 'n': // sum q >= max(1, M)
      return {.q = unit, .constant = least_of_all(certificate_)};
    default: // N: -sum q >= -(N - 1), of bounds -(B - 1)
      return {.q = -unit, .constant = minus_most_of_all(certificate_)};
    }
  }

  /// A sum of conditions: of each class, and of all in place 0.
  using Sums = std::map<std::uint64_t, Condition, std::greater<>>;

  static void add(Sums &sums, std::uint64_t j, const mpz_class &m, const Condition &c) {
    Condition &sum = sums[j];
    sum.q += m * c.q;
    sum.t += m * c.t;
    sum.P += m * c.P;
    sum.p += m * c.p;
    sum.N += m * c.N;
    sum.D += m * c.D;
  }
  Sums add_up(const std::vector<Multiple> &leaf) const {
    Sums sums;
    Condition &all = sums[0];
    for (const auto &[m, letter, classes] : leaf) {
      const auto &[i, j] = classes;
      demand(j <= problem_.classes.size(), "leaf: a class of the gradation", j);
      const Condition c = i < j ? condition_of_sum(letter, classes) : condition(letter, j);
      add(sums, j, m, c);
      if (i < j && i > 1)
        add(sums, i - 1, -m, c);
      all.M += m * c.M;
      all.weight += m * c.weight;
      all.constant += m * c.constant;
      all.strict = all.strict || c.strict;
    }
    return sums;
  }

  /// The sum of the conditions is 0 >= positive, or 0 > 0 (Theorem 14). The work follows the leaf's length:
  /// the classes that it does not name are looked at together, but for those of a sum d.
  void refute(const std::vector<Multiple> &leaf) const {
    const Sums sums = add_up(leaf);
    const Condition &all = sums.at(0);
    // What all conditions but those of the class itself and of w have at t_j, in share units: t_j is part of
    // M and of P_j, ..., P_k; likewise at q_j, which is part of N_j, ..., N_k; and D_j, ..., D_k.
    mpz_class held = all.t * problem_.share_unit + all.M, held_N = 0, held_D = 0;
    const auto cancels = [&](const Condition &sum, std::uint64_t j) {
      const Class &c = problem_.classes[j - 1];
      const mpz_class of_q = sum.q + all.q + held_N - held_D * c.f;
      const mpz_class of_t = (sum.t + held_D) * problem_.share_unit + held + all.weight * c.share[weight];
      return of_q == 0 && of_t == 0 && sum.p + all.p == 0;
    };
    // Classes from i to j that are not named.
    const auto cancel = [&](std::uint64_t i, std::uint64_t j) {
      const bool alike = held_D == 0 && (all.weight == 0 || alike_from_[j - 1] <= i);
      for (std::uint64_t b = alike ? i : j; b >= i; --b)
        if (!cancels({}, b))
          return false;
      return true;
    };
    std::uint64_t last = problem_.classes.size(); // of the classes that are left
    for (const auto &[j, sum] : sums) {
      demand(last == j || cancel(j + 1, last), "leaf: the variables add up to 0", last);
      if (j == 0)
        break;
      held += sum.P * problem_.share_unit;
      held_N += sum.N;
      held_D += sum.D;
      demand(cancels(sum, j), "leaf: the variables add up to 0", j);
      last = j - 1;
    }
    const mpq_class right = all.constant + all.weight * problem_.w;
    demand(right > 0 || (right == 0 && all.strict), "leaf: the constants are a contradiction");
  }

  const Problem &problem_;
  const Certificate &certificate_;
  const Windows windows_;
  std::vector<std::uint64_t> alike_from_; ///< at j - 1: from this class to j the weights are the same
  CountsInForce counts_;
  Window window_;
  std::vector<Branch> path_;
};

} // namespace

std::vector<BoundsOnShares> bounds_on_shares(const Gradation &gradation, const Certificate &certificate) {
  std::vector<BoundsOnShares> bounds;
  for (const std::array<mpq_class, shares> &of : derive_shares(gradation, certificate))
    bounds.push_back({of[r], of[R], of[p], of[P]});
  return bounds;
}

void verify_tolerant(Gradation gradation, const Certificate &certificate) {
  apply_question(gradation, certificate);
  const Problem problem = derive(gradation, certificate);
  verify_pi(certificate);
  if (!certificate.particles.empty())
    verify_witness(problem, gradation, certificate);
  Replay(problem, certificate).run();
}

} // namespace mdm::checker
