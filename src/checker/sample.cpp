// What a certificate says of a sample, derived from the sample's rows (section 12, Theorem 23). Rows go into
// classes one after the other, with bounds of their masses; at the end shares, errors and conditions follow,
// each as an enclosure, and every line of the certificate must hold for all that is enclosed.

#include "sample.hpp"

#include <algorithm>
#include <numeric>

namespace mdm::checker {
namespace {

mpz_class floor_of(const mpq_class &value) {
  mpz_class floor;
  mpz_fdiv_q(floor.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return floor;
}

/// What the rows say of shares, errors and conditions.
struct Derived {
  std::vector<Enclosed> shares, passing; ///< of each class, and of what passes its upper opening
  std::vector<Enclosed> share_errors, passing_errors;
  Enclosed total{0, 0};
  std::array<const char *, 4> conditions{};
};

const char *word(bool yes, bool no) {
  return no ? "no" : yes ? "yes" : "open";
}

Enclosed error(const Enclosed &value, const mpq_class &target) {
  const mpq_class over = value.hi - target, under = target - value.lo;
  return {std::max({mpq_class(0), mpq_class(-over), mpq_class(-under)}), std::max(over, under)};
}

/// The masses of the classes, in a unit of their own.
std::vector<Enclosed> masses(const Gradation &gradation, const Certificate &question,
                             const SampleTally &tally) {
  std::vector<Enclosed> all;
  const mpz_class &unit = tally.mass().unit_of_places();
  std::uint64_t longest = 0;
  for (const SampleTally::Class &of : tally.classes()) {
    const auto mass = [&](const FractionSum &exact, const mpz_class &places) {
      mpq_class rest(places, unit);
      rest.canonicalize();
      const mpq_class t = gradation.factors[all.size()] * (exact.value() + rest);
      longest = std::max(longest, bits(t));
      return t;
    };
    mpq_class least = mass(of.least, of.least_places), most = mass(of.most, of.most_places);
    all.push_back({std::move(least), std::move(most)});
  }
  demand_within(all.size() * longest, 28, question); // limit 3
  return all;
}

void derive_shares(const std::vector<Enclosed> &masses, Derived &derived) {
  Enclosed all{0, 0};
  for (const auto &[lo, hi] : masses) {
    all.lo += lo;
    all.hi += hi;
  }
  const mpq_class one = 1;
  mpq_class least = 0, most = 0;
  for (const auto &[lo, hi] : masses) {
    Enclosed share{0, 0};
    if (all.hi > 0)
      share = {lo / all.hi, all.lo > 0 ? std::min(one, mpq_class(hi / all.lo)) : one};
    least += share.lo;
    most += share.hi;
    derived.shares.push_back(std::move(share));
    derived.passing.push_back({least, std::min(one, most)});
  }
  if (all.lo > 0)
    derived.passing.back() = {1, 1};
}

void derive_errors(const Gradation &gradation, Derived &derived) {
  mpq_class all = 0, G = 0;
  for (const mpq_class &mass : gradation.masses)
    all += mass;
  const std::size_t k = derived.shares.size();
  bool differs = false, equals = true; // for sure
  for (std::size_t j = 0; j < k; ++j) {
    const mpq_class g = gradation.masses[j] / all;
    G += g;
    const auto &[lo, hi] = derived.shares[j];
    differs = differs || g < lo || hi < g;
    equals = equals && lo == g && hi == g;
    const Enclosed of_share = error(derived.shares[j], g);
    derived.total.lo += of_share.lo;
    derived.total.hi += of_share.hi;
    derived.share_errors.push_back(of_share);
    if (j + 1 < k)
      derived.passing_errors.push_back(error(derived.passing[j], G));
  }
  derived.conditions[3] = word(equals, differs);
}

/// Cond 1 to 3, and what they leave of Cond 4.
void derive_conditions(const SampleTally &tally, Derived &derived) {
  const bool is_outside = tally.below() > 0 || tally.above() > 0;
  const bool describes = !is_outside && !tally.may_be_outside();
  const bool is_placed = describes && tally.unplaced() == 0;
  const auto &classes = tally.classes();
  const bool differ = std::any_of(classes.begin(), classes.end(), [](const SampleTally::Class &of) {
    return of.count > 0 && of.most_lo > of.least_hi;
  });
  const bool same = std::all_of(classes.begin(), classes.end(), [](const SampleTally::Class &of) {
    return of.count <= 1 || of.least_lo == of.most_hi;
  });
  derived.conditions[0] = "yes";
  derived.conditions[1] = word(describes, is_outside);
  derived.conditions[2] = word(is_placed && same, is_outside || differ);
  const std::string_view shares = derived.conditions[3];
  derived.conditions[3] = word(is_placed && shares == "yes", is_outside || shares == "no");
}

bool encloses(const Percents &percents, const Enclosed &share) {
  return percents.lo.value <= 100 * share.lo && 100 * share.hi <= percents.hi.value;
}

/// The largest error of classes is in the percents, and so is that of the class that is named.
void verify_largest(const LargestError &claim, const std::vector<Enclosed> &errors, const char *name) {
  demand(1 <= claim.index && claim.index <= errors.size(), name);
  for (std::size_t j = 0; j < errors.size(); ++j)
    demand(100 * errors[j].hi <= claim.percents.hi.value, name, j + 1);
  demand(claim.percents.lo.value <= 100 * errors[claim.index - 1].lo, name, claim.index);
}

/// What is asked of a value, and what it is, for a verdict that it is not what is asked.
void verify_miss(const SampleVerdict &verdict, const Enclosed &found, const Enclosed &asked) {
  constexpr const char *name = "verdict";
  const mpq_class &v = verdict.asked.value;
  demand(encloses(verdict.found, found), name, verdict.index);
  if (verdict.is_least)
    demand(verdict.found.hi.value < v && v <= 100 * asked.lo, name, verdict.index);
  else
    demand(100 * asked.hi <= v && v < verdict.found.lo.value, name, verdict.index);
}

void verify_verdict(const SampleCertificate &c, const SampleTally &tally, const Derived &derived,
                    const std::vector<BoundsOnShares> &bounds) {
  const SampleVerdict &verdict = c.verdict;
  const std::size_t k = bounds.size();
  const Numbers &total = c.question.total;
  switch (verdict.kind) {
  case SampleVerdict::match:
    demand(tally.below() == 0 && tally.above() == 0 && tally.unplaced() == 0,
           "verdict match: all particles in classes");
    for (std::size_t j = 0; j < k; ++j) {
      demand(bounds[j].least_retained <= derived.shares[j].lo &&
                 derived.shares[j].hi <= bounds[j].most_retained,
             "verdict match: the share of the class", j + 1);
      demand(bounds[j].least_passing <= derived.passing[j].lo &&
                 derived.passing[j].hi <= bounds[j].most_passing,
             "verdict match: what passes the class", j + 1);
    }
    demand(total.empty() || 100 * derived.total.hi <= total[0].value, "verdict match: the total");
    return;
  case SampleVerdict::outside:
    demand(tally.below() > 0 || tally.above() > 0, "verdict outside: particles outside");
    return;
  case SampleVerdict::of_class: {
    demand(1 <= verdict.index && verdict.index <= k, "verdict: a class");
    const BoundsOnShares &of = bounds[verdict.index - 1];
    return verify_miss(verdict, derived.shares[verdict.index - 1], {of.least_retained, of.most_retained});
  }
  case SampleVerdict::passing: {
    demand(1 <= verdict.index && verdict.index < k, "verdict: a class below the last");
    const BoundsOnShares &of = bounds[verdict.index - 1];
    return verify_miss(verdict, derived.passing[verdict.index - 1], {of.least_passing, of.most_passing});
  }
  default:
    demand(!total.empty(), "verdict: a total is asked for");
    verify_miss(verdict, derived.total, {0, total[0].value / 100});
  }
}

void verify_counts(const SampleCertificate &c, const SampleTally &tally) {
  demand(c.particles[0].value == tally.particles(), "particles");
  demand(integer_of(c.below) == tally.below(), "below");
  demand(integer_of(c.above) == tally.above(), "above");
  demand(integer_of(c.unplaced) == tally.unplaced(), "unplaced");
  demand(c.classes.size() == tally.classes().size(), "class: a line for each");
  for (std::size_t j = 0; j < c.classes.size(); ++j) {
    demand(c.classes[j].index == j + 1, "class: in their order", j + 1);
    demand(c.classes[j].quantity == tally.classes()[j].count, "class: its number of particles", j + 1);
  }
}

} // namespace

SampleMass::SampleMass(const Certificate &question, unsigned long N, unsigned long places) {
  const unsigned long bN = question.b * N, common = std::gcd(question.a, bN);
  exponent_ = question.a / common;
  e_ = bN / common;
  places_ = e_ > 1 ? places : 0;
  ten_to_places_ = checker::power(10, places_);
}

SampleMass::Mass SampleMass::of(const mpq_class &z, const mpq_class &unit) const {
  if (e_ == 1)
    return {true, raised(z, exponent_), 0};
  const mpq_class T = raised(z / unit, exponent_);
  if (const std::optional<mpq_class> root = rational_root(T, e_))
    return {true, *root, 0};
  mpz_class places = floor_of(T * checker::power(ten_to_places_, e_));
  mpz_root(places.get_mpz_t(), places.get_mpz_t(), e_);
  return {false, 0, places};
}

void FractionSum::add(const mpq_class &value, const mpz_class &times) {
  const mpz_class &denominator = value.get_den();
  if (denominator == denominator_) {
    numerator_ += value.get_num() * times;
    return;
  }
  if (!mpz_divisible_p(denominator_.get_mpz_t(), denominator.get_mpz_t())) {
    const mpz_class common = lcm(denominator_, denominator);
    numerator_ *= common / denominator_;
    denominator_ = common;
  }
  numerator_ += value.get_num() * times * mpz_class(denominator_ / denominator);
}

mpq_class FractionSum::value() const {
  mpq_class value(numerator_, denominator_);
  value.canonicalize();
  return value;
}

SampleTally::SampleTally(const Gradation &gradation, const SampleCertificate &certificate, unsigned long N)
    : root_(gradation.root), question_(certificate.question),
      mass_(question_, N, integer_of(certificate.places).get_ui()), classes_(gradation.openings.size() - 1) {
  for (const mpq_class &Y : gradation.openings)
    opening_bits_ = std::max(opening_bits_, N * bits(Y));
  demand_within(opening_bits_, 20, question_);
  demand_within(opening_bits_ * gradation.openings.size(), 28, question_);
  for (const mpq_class &Y : gradation.openings)
    openings_.push_back(raised(Y, N));
}

/// Limit 1, before a power of the row is computed.
void SampleTally::limit_row(const SampleRow &row) {
  longest_ = std::max({longest_, bits(row.lo), bits(row.hi)});
  demand_within(mass_.bits_of(longest_), 20, question_);
  demand_within(longest_ * root_, 20, question_);
}

/// Limit 2.
void SampleTally::limit_rows() const {
  const std::uint64_t common = mpz_sizeinbase(common_.get_mpz_t(), 2);
  demand_within(rows_ * (mass_.bits_of(longest_) + longest_ * root_ + opening_bits_ + common), 36, question_);
}

std::size_t SampleTally::openings_below(const mpq_class &z, bool or_at) const {
  const mpq_class power = root_ == 1 ? z : raised(z, root_);
  const auto end = std::partition_point(openings_.begin(), openings_.end(), [&](const mpq_class &Y) {
    const int sign = cmp(Y, power);
    return sign < 0 || (or_at && sign == 0);
  });
  return static_cast<std::size_t>(end - openings_.begin());
}

SampleMass::Mass SampleTally::weighed(const mpq_class &z) {
  SampleMass::Mass mass = mass_.of(z, unit_);
  if (mass.is_exact && !mpz_divisible_p(common_.get_mpz_t(), mass.exact.get_den_mpz_t())) {
    common_ = lcm(common_, mass.exact.get_den());
    demand_within(mpz_sizeinbase(common_.get_mpz_t(), 2), 20, question_);
  }
  return mass;
}

void SampleTally::see(Class &in, const SampleRow &row) {
  if (in.count == 0) {
    in.least_lo = in.most_lo = row.lo;
    in.least_hi = in.most_hi = row.hi;
  } else {
    if (row.lo < in.least_lo)
      in.least_lo = row.lo;
    if (row.lo > in.most_lo)
      in.most_lo = row.lo;
    if (row.hi < in.least_hi)
      in.least_hi = row.hi;
    if (row.hi > in.most_hi)
      in.most_hi = row.hi;
  }
  in.count += row.quantity;
}

void SampleTally::add(const SampleRow &row) {
  if (rows_ == 0)
    unit_ = row.hi;
  limit_row(row);
  ++rows_;
  const bool is_point = row.lo == row.hi;
  const std::size_t last = openings_below(row.hi, false);
  const std::size_t first = is_point ? last : openings_below(row.lo, row.is_open || row.lo == 0);
  const bool is_placed = first == last, is_inside = last > 0 && first < openings_.size();
  const SampleMass::Mass most = weighed(row.hi);
  const SampleMass::Mass least = is_point ? most : weighed(row.lo);
  rows_ += last - first + (is_placed ? 0 : 1);
  limit_rows();
  if (!is_placed) {
    unplaced_ += row.quantity;
    may_be_outside_ = may_be_outside_ || first == 0 || last == openings_.size();
  } else if (!is_inside) {
    (first == 0 ? below_ : above_) += row.quantity;
  } else {
    Class &in = classes_[first - 1];
    see(in, row);
    if (least.is_exact)
      in.least.add(least.exact, row.quantity);
    else
      in.least_places += least.places * row.quantity;
  }
  for (std::size_t i = std::max<std::size_t>(first, 1); is_inside && i <= last && i < openings_.size(); ++i)
    if (most.is_exact)
      classes_[i - 1].most.add(most.exact, row.quantity);
    else
      classes_[i - 1].most_places += (most.places + 1) * row.quantity;
}

mpz_class SampleTally::particles() const {
  mpz_class all = below_ + above_ + unplaced_;
  for (const Class &of : classes_)
    all += of.count;
  return all;
}

void verify_sample(const Gradation &gradation, const SampleCertificate &certificate,
                   const SampleTally &tally) {
  Derived derived;
  derive_shares(masses(gradation, certificate.question, tally), derived);
  derive_errors(gradation, derived);
  derive_conditions(tally, derived);

  demand(certificate.places.empty() == (tally.mass().root() == 1), "places: there exactly if e > 1");
  Certificate asked = certificate.question;
  if (!certificate.is_tolerant)
    asked.retained.push_back({0, "0"});
  const std::vector<BoundsOnShares> bounds = bounds_on_shares(gradation, asked);
  verify_counts(certificate, tally);
  for (std::size_t j = 0; j < derived.shares.size(); ++j) {
    const ClassClaim &claim = certificate.classes[j];
    demand(encloses(claim.share, derived.shares[j]), "class: its share", j + 1);
  }
  verify_largest(certificate.retained, derived.share_errors, "retained-error");
  demand(certificate.passing.has_value() == !derived.passing_errors.empty(), "passing-error");
  if (certificate.passing)
    verify_largest(*certificate.passing, derived.passing_errors, "passing-error");
  demand(encloses(certificate.total, derived.total), "total-error");
  for (std::size_t i = 0; i < 4; ++i)
    demand(certificate.conditions[i] == derived.conditions[i], "conditions");
  verify_verdict(certificate, tally, derived, bounds);
}

} // namespace mdm::checker
