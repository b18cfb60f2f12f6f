#include "blend.hpp"

#include "verify.hpp"

#include <algorithm>
#include <numeric>

namespace mdm::checker {
namespace {

using Counts = std::vector<std::uint64_t>;
using Aim = BlendCertificate::Aim;

/// Refuses the certificate where something does not hold.
void require(bool holds, const char *why_refused) {
  if (!holds)
    throw Refused(why_refused);
}

/// A number of steps: at most 10^9 (blend_certificate.cpp), which GMP's long holds everywhere.
mpz_class integer(std::uint64_t steps) {
  return mpz_class(static_cast<unsigned long>(steps));
}

mpq_class in_mm(const Gradation &g) {
  return g.unit() == "um" ? mpq_class(1, 1000) : g.unit() == "m" ? mpq_class(1000) : mpq_class(1);
}

/// Openings in mm, and the percent of the mass that passes each.
struct Curve {
  Rationals sizes, passing;
};

Curve curve_of(const Gradation &g) {
  require(g.root == 1, "a stockpile's openings are irrational");
  require(g.limits.empty(), "a stockpile's file has limits and no gradation");
  const mpq_class total = std::accumulate(g.masses.begin(), g.masses.end(), mpq_class(0));
  Curve curve;
  mpq_class passed = 0;
  for (std::size_t i = 0; i < g.openings.size(); ++i) {
    curve.sizes.push_back(g.openings[i] * in_mm(g));
    curve.passing.push_back(100 * passed / total);
    passed += g.masses[i];
  }
  return curve;
}

/// What passes a size: whether it is known, whether it is interpolated, and the percent.
struct Passing {
  bool known = true, interpolated = false;
  mpq_class percent;
};

Passing passing_at(const Curve &c, const mpq_class &size) {
  const auto i =
      static_cast<std::size_t>(std::lower_bound(c.sizes.begin(), c.sizes.end(), size) - c.sizes.begin());
  if (i == c.sizes.size())
    return {true, false, 100};
  if (c.sizes[i] == size)
    return {true, false, c.passing[i]};
  if (i == 0)
    return {true, false, 0};
  if (c.passing[i - 1] == c.passing[i])
    return {true, false, c.passing[i]};
  if (c.sizes[i - 1] == 0)
    return {false, false, 0};
  const mpq_class position = (size - c.sizes[i - 1]) / (c.sizes[i] - c.sizes[i - 1]);
  return {true, true, c.passing[i - 1] + position * (c.passing[i] - c.passing[i - 1])};
}

/// A modulus of n sieves with the mean percent p passing them is n (1 - p / 100): it falls where p grows.
JudgedSieve judged_modulus(const ModulusLimits &limits, const std::vector<Curve> &curves) {
  const Rationals &sieves = modulus_sieves(limits.standard);
  const mpq_class n(static_cast<unsigned long>(sieves.size()));
  JudgedSieve mean{0,  100 * (1 - limits.most / n), 100 * (1 - limits.least / n), {},
                   {}, JudgedSieve::modulus};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    mpq_class sum = 0;
    bool is_interpolated = false;
    for (const mpq_class &size : sieves) {
      const Passing at = passing_at(curves[i], size);
      require(at.known, "a stockpile does not tell what passes a sieve of the fineness modulus");
      sum += at.percent;
      is_interpolated = is_interpolated || at.interpolated;
    }
    mean.passing.push_back(sum / n);
    if (is_interpolated)
      mean.interpolated.push_back(i);
  }
  return mean;
}

/// 100 (100 - a) / (100 - b) >= c, with a and b that pass 9.5 mm and 2.36 mm, is a - c / 100 b <= 100 - c.
JudgedSieve judged_factor(const mpq_class &c, const mpq_class &least, const mpq_class &most,
                          const std::vector<Curve> &curves) {
  JudgedSieve difference{0, least, most, {}, {}, JudgedSieve::factor};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Passing coarse = passing_at(curves[i], mpq_class(19, 2)),
                  fine = passing_at(curves[i], mpq_class(59, 25));
    require(coarse.known && fine.known,
            "a stockpile does not tell what passes a sieve of the coarseness factor");
    difference.passing.push_back(coarse.percent - c / 100 * fine.percent);
    if (coarse.interpolated || fine.interpolated)
      difference.interpolated.push_back(i);
  }
  return difference;
}

/// Bounds of the steps of each stockpile.
struct Box {
  Counts least, most;
};

class Verifier {
public:
  Verifier(const std::vector<JudgedSieve> &sieves, std::size_t stockpiles,
           const BlendCertificate &certificate)
      : sieves_(sieves), k_(stockpiles), c_(certificate) {}

  mpq_class verify() {
    check_question();
    const Box all = whole_box();
    mpq_class value = 0;
    if (c_.blend)
      value = verify_blend_itself(all);
    if (!c_.tree.empty())
      verify_tree(all, value);
    return value;
  }

private:
  static bool is_sieve(const JudgedSieve &s) { return s.kind == JudgedSieve::sieve; }
  void check_question() const {
    require(!c_.blend || c_.blend->size() == k_,
            "the blend does not have as many stockpiles as there are files");
    for (const ShareLimits &limits : c_.shares)
      require(limits.stockpile <= k_, "a share is limited of a stockpile that is not there");
    if (c_.aim == Aim::cost)
      require(c_.of_aim.size() == k_, "there are not as many costs as stockpiles");
    if (c_.has_targets())
      require(c_.of_aim.size() ==
                  static_cast<std::size_t>(std::count_if(sieves_.begin(), sieves_.end(), is_sieve)),
              "there are not as many targets as sieves");
  }

  Box whole_box() const {
    Box box{Counts(k_, 0), Counts(k_, c_.steps)};
    for (const ShareLimits &limits : c_.shares) {
      const mpq_class least = limits.least * integer(c_.steps), most = limits.most * integer(c_.steps);
      mpz_class up, down;
      mpz_cdiv_q(up.get_mpz_t(), least.get_num_mpz_t(), least.get_den_mpz_t());
      mpz_fdiv_q(down.get_mpz_t(), most.get_num_mpz_t(), most.get_den_mpz_t());
      box.least[limits.stockpile - 1] = up.get_ui();
      box.most[limits.stockpile - 1] = down.get_ui();
    }
    return box;
  }

  /// The witness is in the box, uses few enough stockpiles and keeps the limits; the value of its aim.
  mpq_class verify_blend_itself(const Box &all) const {
    const Counts &n = *c_.blend;
    require(std::accumulate(n.begin(), n.end(), std::uint64_t{0}) == c_.steps,
            "the steps do not sum to the whole");
    for (std::size_t i = 0; i < k_; ++i)
      require(all.least[i] <= n[i] && n[i] <= all.most[i], "a share of the blend is beyond its limits");
    const auto used =
        static_cast<std::uint64_t>(std::count_if(n.begin(), n.end(), [](auto c) { return c > 0; }));
    require(!c_.at_most || used <= *c_.at_most, "the blend has too many stockpiles");
    mpq_class value = 0;
    for (std::size_t s = 0; s < sieves_.size(); ++s) {
      mpq_class passing = 0;
      for (std::size_t i = 0; i < k_; ++i)
        passing += integer(n[i]) * sieves_[s].passing[i];
      passing /= integer(c_.steps);
      require(sieves_[s].least <= passing && passing <= sieves_[s].most, "the blend does not keep a limit");
      if (c_.has_targets() && is_sieve(sieves_[s])) {
        const mpq_class deviation = abs(passing - c_.of_aim[s]);
        value = c_.aim == Aim::max_deviation ? std::max(value, deviation)
                : c_.aim == Aim::deviation   ? mpq_class(value + deviation)
                                             : mpq_class(value + deviation * deviation);
      }
    }
    if (c_.aim == Aim::cost) {
      for (std::size_t i = 0; i < k_; ++i)
        value += integer(n[i]) * c_.of_aim[i];
      value /= integer(c_.steps);
    }
    return value;
  }

  /// Walks the tree (Theorem 22): no blend of a leaf's box has a lower value, or there is none.
  void verify_tree(const Box &all, const mpq_class &value) const {
    std::vector<Box> open = {all};
    for (const BlendNode &node : c_.tree) {
      Box box = std::move(open.back());
      open.pop_back();
      if (node.kind == BlendNode::split) {
        require(node.stockpile <= k_, "a split is of a stockpile that is not there");
        Box below = box;
        below.most[node.stockpile - 1] = std::min(below.most[node.stockpile - 1], node.at);
        box.least[node.stockpile - 1] = std::max(box.least[node.stockpile - 1], node.at + 1);
        open.push_back(std::move(box));
        open.push_back(std::move(below));
      } else {
        verify_leaf(node, std::move(box), value);
      }
    }
  }

  /// Leaves a box as it is, or takes out of it what has too many stockpiles. False if it is empty.
  bool restrict(Box &box) const {
    const auto used = static_cast<std::uint64_t>(
        std::count_if(box.least.begin(), box.least.end(), [](std::uint64_t n) { return n > 0; }));
    if (c_.at_most && used > *c_.at_most)
      return false;
    std::uint64_t fewest = 0, most = 0;
    for (std::size_t i = 0; i < k_; ++i) {
      if (c_.at_most && used == *c_.at_most && box.least[i] == 0)
        box.most[i] = 0;
      if (box.least[i] > box.most[i])
        return false;
      fewest = std::min(fewest + box.least[i], c_.steps + 1);
      most = std::min(most + box.most[i], c_.steps);
    }
    return fewest <= c_.steps && most == c_.steps;
  }

  void verify_leaf(const BlendNode &node, Box box, const mpq_class &value) const {
    if (!restrict(box))
      return;
    const bool is_leaf = node.kind == BlendNode::leaf;
    Rationals e(k_); // of the shares in what is below the aim
    if (is_leaf && c_.aim == Aim::cost)
      e = c_.of_aim;
    mpq_class constant = 0, most_of_one = 0, of_all = 0;
    std::vector<mpq_class> of_target(c_.has_targets() ? sieves_.size() : 0);
    for (const SieveMultiple &m : node.multiples) {
      require(m.sieve <= sieves_.size(), "a multiplier is of a sieve that is not there");
      const JudgedSieve &sieve = sieves_[m.sieve - 1];
      const bool is_target = m.condition == 'a' || m.condition == 'b';
      require(!is_target || is_sieve(sieve), "a fineness modulus or a coarseness factor has no target");
      const bool falls = m.condition == 'l' || m.condition == 'a'; // the more passes, the less is left of it
      const mpq_class sign = falls ? mpq_class(m.m) : mpq_class(-m.m);
      constant += sign * (is_target ? c_.of_aim[m.sieve - 1] : falls ? sieve.least : sieve.most);
      for (std::size_t i = 0; i < k_; ++i)
        e[i] -= sign * sieve.passing[i];
      if (is_target && c_.aim == Aim::squares) {
        require(of_target[m.sieve - 1] == 0, "multipliers of a leaf are of both sides of a target");
        of_target[m.sieve - 1] = m.m;
        constant -= m.m * m.m / 4;
      } else if (is_target) {
        of_all += m.m;
        most_of_one = std::max(most_of_one, of_target[m.sieve - 1] += m.m);
      }
    }
    require((c_.aim == Aim::max_deviation ? of_all : most_of_one) <= 1,
            "multipliers of a leaf are more than the aim has of deviations");
    const mpq_class least = constant + least_sum(e, box);
    require(is_leaf ? least >= value : least > 0, is_leaf ? "a leaf may hold a blend of lower value"
                                                          : "a leaf that is to be empty may hold a blend");
  }

  /// The least of sum e_i n_i / steps in the box, where the n_i sum to the whole: cheapest first.
  mpq_class least_sum(const Rationals &e, const Box &box) const {
    std::vector<std::size_t> order(k_);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&e](std::size_t a, std::size_t b) { return e[a] < e[b]; });
    mpq_class sum = 0;
    std::uint64_t left = c_.steps - std::accumulate(box.least.begin(), box.least.end(), std::uint64_t{0});
    for (const std::size_t i : order) {
      const std::uint64_t more = std::min(left, box.most[i] - box.least[i]);
      sum += e[i] * integer(box.least[i] + more);
      left -= more;
    }
    return sum / integer(c_.steps);
  }

  const std::vector<JudgedSieve> &sieves_;
  std::size_t k_;
  const BlendCertificate &c_;
};

} // namespace

std::vector<JudgedSieve> judged_sieves(const Gradation &specification,
                                       const std::vector<Gradation> &stockpiles,
                                       const BlendCertificate &certificate) {
  require(!specification.limits.empty(), "the specification's file has no limits");
  std::vector<Curve> curves;
  for (const Gradation &g : stockpiles)
    curves.push_back(curve_of(g));
  std::vector<JudgedSieve> sieves;
  for (const Limit &limit : specification.limits) {
    JudgedSieve sieve{limit.opening * in_mm(specification), limit.least, limit.most, {}, {}};
    if (sieve.size == 0)
      continue;
    const bool limits_something = sieve.least > 0 || sieve.most < 100;
    bool known = true;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const Passing at = passing_at(curves[i], sieve.size);
      require(at.known || !limits_something,
              "a stockpile does not tell what passes a sieve that has a limit");
      known = known && at.known;
      sieve.passing.push_back(at.percent);
      if (at.interpolated)
        sieve.interpolated.push_back(i);
    }
    if (known)
      sieves.push_back(std::move(sieve));
  }
  require(!sieves.empty(), "the specification limits nothing");
  for (const ModulusLimits &limits : certificate.moduli)
    sieves.push_back(judged_modulus(limits, curves));
  if (certificate.coarseness) {
    const mpq_class &least = certificate.coarseness->least, &most = certificate.coarseness->most;
    if (least > 0)
      sieves.push_back(judged_factor(least, -100, 100 - least, curves));
    if (most < 100)
      sieves.push_back(judged_factor(most, 100 - most, 100, curves));
  }
  return sieves;
}

mpq_class verify_blend(const std::vector<JudgedSieve> &sieves, std::size_t stockpiles,
                       const BlendCertificate &certificate, std::string_view place) {
  // A leaf sums so many fractions, each as long as the longest number and what passes together.
  std::uint64_t longest = certificate.longest_bits;
  for (const JudgedSieve &sieve : sieves)
    for (const mpq_class &passing : sieve.passing)
      longest = std::max(longest, bits(passing));
  const auto work = [](std::uint64_t a, std::uint64_t b) {
    return b == 0 || a <= (std::uint64_t{1} << 34U) / b ? a * b : ~std::uint64_t{0};
  };
  const std::uint64_t all = work(work(certificate.terms + sieves.size(), stockpiles + 1),
                                 work(certificate.longest_leaf + 1, longest));
  demand_form(all <= (std::uint64_t{1} << 34U), place,
              "this would take too long to check: search for a smaller tree");
  return Verifier(sieves, stockpiles, certificate).verify();
}

} // namespace mdm::checker
