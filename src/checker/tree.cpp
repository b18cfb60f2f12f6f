#include "verify.hpp"

#include <algorithm>

namespace mdm_check {
namespace {

/// What is demanded of a share: lo <= share <= hi.
struct Bounds {
  mpq_class lo = 0, hi = 1;

  void narrow(const mpq_class &least, const mpq_class &most) {
    lo = std::max(lo, least);
    hi = std::min(hi, most);
  }
  void narrow_around(const mpq_class &share, const mpq_class &percent) {
    narrow(share - percent / 100, share + percent / 100);
  }
};

/// Class j in integers: f_j and F_j in mass units; in share units the bounds on t_j / M and on P_j / M, the
/// share g_j and the weight of a mass, 1 / c_j.
struct Class {
  mpz_class f, F, least; ///< q_j >= least
  mpz_class retained_lo, retained_hi, passing_lo, passing_hi, g, weight;
};

/// The problem of section 6. A mass t is the integer t * mass_unit where it is compared with f or F.
struct Problem {
  std::vector<Class> classes; ///< class j at j - 1
  mpz_class mass_unit, share_unit;
  mpz_class half_total; ///< e / 2 in share units
  mpq_class weight;     ///< least sum of t / c of every match
};

/// x^(a/b) = (root_b x)^a is rational iff the root is: a and b have no common factor.
Rationals roots(const Rationals &openings, unsigned long b) {
  Rationals result;
  for (const mpq_class &x : openings) {
    mpz_class numerator, denominator;
    const bool exact = mpz_root(numerator.get_mpz_t(), x.get_num_mpz_t(), b) != 0;
    demand(mpz_root(denominator.get_mpz_t(), x.get_den_mpz_t(), b) != 0 && exact,
           "a rational mass at each opening", result.size() + 1);
    result.emplace_back(numerator, denominator);
  }
  return result;
}

/// What the lines of the tolerance demand of the shares retained and passing, g the gradation's shares.
void narrow(std::vector<Bounds> &retained, std::vector<Bounds> &passing, const Rationals &g,
            const Gradation &gradation, const Certificate &c) {
  const std::size_t k = g.size();
  const bool has_file = !c.retained_file.empty() || !c.passing_file.empty();
  demand(!has_file || !gradation.tolerances.empty(), "a column tolerance_percent");
  demand(c.passing_each.empty() || c.passing_each.size() == k - 1, "passing-each: k - 1 tolerances");
  mpq_class G = 0;
  for (std::size_t j = 0; j < k; ++j) {
    G += g[j];
    const auto narrow = [&](Bounds &bounds, const mpq_class &share, const Numbers &percent,
                            const Numbers &file, std::size_t row) {
      if (!percent.empty())
        bounds.narrow_around(share, percent[0].value);
      if (!file.empty())
        bounds.narrow_around(share, gradation.tolerances[row]);
    };
    narrow(retained[j], g[j], c.retained, c.retained_file, j);
    if (j + 1 == k)
      break;
    narrow(passing[j], G, c.passing, c.passing_file, j + 1);
    if (!c.passing_each.empty())
      passing[j].narrow_around(G, c.passing_each[j].value);
  }
  const Rationals &openings = gradation.openings;
  for (std::size_t i = 0; i < c.band.size(); i += 3) {
    const mpq_class x = c.band[i].value * (c.size_factor.empty() ? mpq_class(1) : c.size_factor[0].value);
    const mpq_class lo = c.band[i + 1].value / 100, hi = c.band[i + 2].value / 100;
    const auto found = std::lower_bound(openings.begin(), openings.end(), x);
    if (x <= openings.front()) {
      demand(lo == 0, "band: nothing passes the finest opening");
      continue;
    }
    demand(found == openings.end() || *found == x, "band: every sieve is an opening");
    const auto i_upper = static_cast<std::size_t>(found - openings.begin());
    passing[std::min(i_upper, k) - 1].narrow(lo, hi);
  }
}

/// Derives the problem; what does not fit together is Refused, what would take too long is Malformed.
Problem derive(const Gradation &gradation, const Certificate &certificate) {
  const std::size_t k = gradation.openings.size() - 1;
  const unsigned long a = certificate.law[0].value.get_num().get_ui();
  mpq_class all = 0;
  for (const mpq_class &mass : gradation.masses)
    all += mass;
  Rationals g, weights;
  const Solids demanded = solids(certificate);
  for (std::size_t j = 0; j < k; ++j) {
    g.push_back(gradation.masses[j] / all);
    weights.push_back(demanded.enough == 0 ? mpq_class(0) : 1 / gradation.factors[j]);
  }
  std::vector<Bounds> retained(k), passing(k);
  narrow(retained, passing, g, gradation, certificate);
  // The total is at most 2 for any shares.
  const mpq_class half_total = certificate.total.empty() ? mpq_class(1) : certificate.total[0].value / 200;

  Problem problem;
  problem.weight = demanded.below;
  mpz_class &unit = problem.share_unit;
  unit = half_total.get_den();
  for (std::size_t j = 0; j < k; ++j)
    for (const mpq_class *share :
         {&g[j], &weights[j], &retained[j].lo, &retained[j].hi, &passing[j].lo, &passing[j].hi})
      include(unit, share->get_den(), certificate);
  const Rationals size = roots(gradation.openings, certificate.law[0].value.get_den().get_ui());
  const mpz_class size_unit = common_denominator(size), factor_unit = common_denominator(gradation.factors);
  problem.mass_unit = power(size_unit, a) * factor_unit;
  problem.half_total = in_units(half_total, unit);
  demand_within(work_of(certificate, k) * (bits(unit) + bits(problem.weight)), limit::work_of_steps,
                certificate); // limit 6
  for (std::size_t j = 0; j < k; ++j) {
    const mpz_class c = in_units(gradation.factors[j], factor_unit);
    const auto mass = [&](std::size_t i) -> mpz_class { return c * power(in_units(size[i], size_unit), a); };
    const auto share = [&](const mpq_class &value) { return in_units(value, unit); };
    problem.classes.push_back({mass(j), mass(j + 1),
                               gradation.masses[j] > 0 ? integer_of(certificate.min_per_class) : mpz_class(0),
                               share(retained[j].lo), share(retained[j].hi), share(passing[j].lo),
                               share(passing[j].hi), share(g[j]), share(weights[j])});
  }
  return problem;
}

/// The particles of the witness are a match, by definition.
void verify_witness(const Problem &problem, const Gradation &gradation, const Certificate &certificate) {
  const std::size_t k = problem.classes.size();
  const unsigned long a = certificate.law[0].value.get_num().get_ui();
  const unsigned long b = certificate.law[0].value.get_den().get_ui();
  mpz_class unit = 1; // the masses times this are integers
  for (const ClassWitness &witness : certificate.classes)
    include(unit, witness.mass.get_den(), certificate);
  demand_within(work_of(certificate, k) * bits(unit), limit::work_of_steps, certificate); // limit 6
  std::vector<mpz_class> q(k), t(k);
  mpz_class N = 0, M = 0;
  for (const ClassWitness &witness : certificate.classes) {
    const std::uint64_t j = witness.index;
    demand(1 <= j && j <= k, "witness: a class of the gradation", j);
    const Class &c = problem.classes[j - 1];
    const mpz_class mass = in_units(witness.mass, unit);
    demand(c.f * witness.quantity * unit < mass * problem.mass_unit, "f q < t", j);
    demand(mass * problem.mass_unit <= c.F * witness.quantity * unit, "t <= F q", j);
    const mpq_class one = witness.mass / (witness.quantity * gradation.factors[j - 1]);
    verify_size(gradation.openings, witness, {power(one.get_num(), b), power(one.get_den(), b)}, a);
    N += q[j - 1] = witness.quantity;
    M += t[j - 1] = mass;
  }
  mpz_class P = 0, excess = 0, weight = 0;
  for (std::size_t j = 1; j <= k; ++j) {
    const Class &c = problem.classes[j - 1];
    const mpz_class mass = t[j - 1] * problem.share_unit;
    P += mass;
    demand(q[j - 1] >= c.least, "q >= R", j);
    demand(c.retained_lo * M <= mass && mass <= c.retained_hi * M, "retained", j);
    demand(c.passing_lo * M <= P && P <= c.passing_hi * M, "passing", j);
    excess += std::max<mpz_class>(0, mass - c.g * M);
    weight += t[j - 1] * c.weight;
  }
  demand(excess <= problem.half_total * M, "total");
  demand(weight >= solids(certificate).enough * problem.share_unit * unit, "the volume of the solids");
  demand(N == integer_of(certificate.particles), "sum of q = N");
  demand(N >= integer_of(certificate.at_least), "N >= M");
}

/// Walks over the tree with the bounds on counts that are in force, and adds up the leaves' conditions.
class Replay {
public:
  Replay(const Problem &problem, const Certificate &certificate)
      : problem_(problem), certificate_(certificate), most_(problem.classes.size(), -1) {
    for (const Class &c : problem.classes)
      least_.push_back(c.least);
  }

  void run() {
    for (const TreeNode &node : certificate_.tree) {
      if (node.leaf.empty()) {
        demand(1 <= node.j && node.j <= least_.size(), "split: a class of the gradation", node.j);
        mpz_class &most = most_[node.j - 1];
        path_.push_back({node.j - 1, node.v, most, false});
        most = most < 0 ? mpz_class(node.v - 1) : std::min<mpz_class>(most, node.v - 1);
      } else {
        refute(node.leaf);
        go_on();
      }
    }
  }

private:
  struct Split {
    std::size_t j;
    mpz_class v, before; ///< the bound that the branch has changed
    bool second;
  };

  /// Up to the last split whose second subtree is to come, and into that.
  void go_on() {
    for (; !path_.empty() && path_.back().second; path_.pop_back())
      least_[path_.back().j] = path_.back().before;
    if (path_.empty())
      return;
    Split &split = path_.back();
    mpz_class &least = least_[split.j];
    most_[split.j] = split.before;
    split.before = least;
    least = std::max(least, split.v);
    split.second = true;
  }

  /// A condition: sum of coefficient * variable >= constant. q, t, p and P_j are those of its class, or of
  /// every class where it has none; q is in mass units, M in share units.
  struct Condition {
    mpz_class q = 0, t = 0, P = 0, p = 0, M = 0, weight = 0, constant = 0;
    bool strict = false;
  };

  /// The condition of class j, or for j = 0 of all.
  Condition condition(char letter, std::uint32_t j) const {
    const Class &c = problem_.classes[j == 0 ? 0 : j - 1];
    const mpz_class &least = least_[j == 0 ? 0 : j - 1], &most = most_[j == 0 ? 0 : j - 1];
    const mpz_class &unit = problem_.mass_unit;
    switch (letter) {
    case 'f': // t_j - f_j q_j >= 0, strict where q_j >= 1
      return {-c.f, 1, 0, 0, 0, 0, 0, least >= 1};
    case 'F': // F_j q_j - t_j >= 0
      return {c.F, -1};
    case 'q': // q_j >= the bound in force
      return {unit, 0, 0, 0, 0, 0, least};
    case 'Q': // -q_j >= minus the bound in force
      demand(most >= 0, "leaf: Q where q is bounded", j);
      return {-unit, 0, 0, 0, 0, 0, -most};
    case 'r': // t_j - lo_j M >= 0
      return {0, 1, 0, 0, -c.retained_lo};
    case 'R': // hi_j M - t_j >= 0
      return {0, -1, 0, 0, c.retained_hi};
    case 'p': // P_j - lo_j M >= 0
      return {0, 0, 1, 0, -c.passing_lo};
    case 'P': // hi_j M - P_j >= 0
      return {0, 0, -1, 0, c.passing_hi};
    case 'e': // p_j - t_j + g_j M >= 0
      return {0, -1, 0, 1, c.g};
    case 'x': // p_j >= 0
      return {0, 0, 0, 1};
    case 'E': // (e / 2) M - sum p >= 0
      return {0, 0, 0, -1, problem_.half_total};
    case 'm': // M > 0
      return {0, 1, 0, 0, 0, 0, 0, true};
    case 'w': // sum t / c >= w; the constant is added at the end
      return {0, 0, 0, 0, 0, 1};
    case 'n': // sum q >= max(1, M)
      return {unit, 0, 0, 0, 0, 0, std::max<mpz_class>(1, integer_of(certificate_.at_least))};
    default: // N: -sum q >= -(N - 1)
      demand(!certificate_.particles.empty(), "leaf: N with a number of particles");
      return {-unit, 0, 0, 0, 0, 0, 1 - integer_of(certificate_.particles)};
    }
  }

  /// The sum of the conditions is 0 >= positive, or 0 > 0 (Theorem 14).
  void refute(const std::vector<Multiple> &leaf) const {
    const std::size_t k = least_.size();
    std::vector<mpz_class> q(k + 1), t(k + 1), P(k + 1), p(k + 1); // of all classes in place 0
    mpz_class M = 0, weight = 0, constant = 0;
    bool strict = false;
    for (const auto &[m, letter, j] : leaf) {
      demand(j <= k, "leaf: a class of the gradation", j);
      const Condition c = condition(letter, j);
      q[j] += m * c.q;
      t[j] += m * c.t;
      P[j] += m * c.P;
      p[j] += m * c.p;
      M += m * c.M;
      weight += m * c.weight;
      constant += m * c.constant;
      strict = strict || c.strict;
    }
    mpz_class held = t[0]; // t_j is part of P_j, ..., P_k
    for (std::size_t j = k; j > 0; --j) {
      held += P[j];
      const mpz_class of_t =
          (t[j] + held) * problem_.share_unit + M + weight * problem_.classes[j - 1].weight;
      demand(q[j] + q[0] == 0 && of_t == 0 && p[j] + p[0] == 0, "leaf: the variables add up to 0", j);
    }
    const mpq_class right = constant + weight * problem_.weight;
    demand(right > 0 || (right == 0 && strict), "leaf: the constants are a contradiction");
  }

  const Problem &problem_;
  const Certificate &certificate_;
  std::vector<mpz_class> least_, most_; ///< -1: none
  std::vector<Split> path_;
};

} // namespace

void verify_tolerant(Gradation gradation, const Certificate &certificate) {
  apply_question(gradation, certificate);
  const Problem problem = derive(gradation, certificate);
  verify_pi(certificate);
  if (!certificate.particles.empty())
    verify_witness(problem, gradation, certificate);
  Replay(problem, certificate).run();
}

} // namespace mdm_check
