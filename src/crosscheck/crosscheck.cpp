// Answers of other solvers to one gradation, judged. What comes in is the gradation, its least match, and
// an answer with counts and maybe sizes; what goes out is a verdict: a match that is minimal, one that is
// not, or no match, with the reason.
//
// Counts are a match if and only if max q_j f_j / m_j < min q_j F_j / m_j (Theorem 1), decided in
// fractions. Stated sizes x must belong to one scale s: for spheres each class allows an interval of s, x
// within its tolerance, and all of them and the window of the counts must meet. The number of particles is
// compared with the proved minimum, or with its bounds where a limit ended that search. Questions with a
// tolerance, floors or a volume go to CountsJudge.

#include "crosscheck/counts_judge.hpp"
#include "crosscheck/other_answer.hpp"
#include "gradation/description.hpp"
#include "gradation/shown.hpp"
#include "match/least_match.hpp"
#include "number/counted.hpp"

#include <mdm/crosscheck/crosscheck.hpp>
#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

/// The sizes in the unit of g.
std::vector<std::optional<StatedSize>> in_unit_of(const Gradation &g, const OtherAnswer &answer) {
  const Rational factor = answer.unit_mm / in_mm(g.unit());
  std::vector<std::optional<StatedSize>> sizes = answer.sizes;
  for (std::optional<StatedSize> &x : sizes)
    if (x)
      *x = {x->lo * factor, x->hi * factor};
  return sizes;
}

/// The class of each of n quantities, if they are of all classes, and else each class with mass.
std::vector<std::size_t> classes_of(const Gradation &g, std::size_t n) {
  std::vector<std::size_t> classes;
  for (std::size_t j = 0; j < g.classes(); ++j)
    if (n == g.classes() || g.mass(j) != 0)
      classes.push_back(j);
  return classes;
}

/// The first class of the answer that g does not have there, in words; or nothing. `index` is that of the
/// class of each quantity.
std::string other_class(const Gradation &g, const OtherAnswer &answer,
                        const std::vector<std::size_t> &index) {
  const Rational factor = answer.unit_mm / in_mm(g.unit());
  for (std::size_t entry = 0; entry < answer.classes.size(); ++entry) {
    if (!answer.classes[entry])
      continue;
    const auto &[lower, upper] = *answer.classes[entry];
    const std::size_t j = index[entry];
    if (!g.opening(j).is_named_by(lower * factor) || !g.opening(j + 1).is_named_by(upper * factor))
      return fmt::format("class {} of the answer is ({}, {}], and that of the gradation ({}, {}]", entry + 1,
                         shown(lower), shown(upper), shown(g.opening(j)), shown(g.opening(j + 1)));
  }
  return {};
}

std::string there_are_quantities(std::size_t n) {
  return n == 1 ? "there is 1 quantity" : fmt::format("there are {} quantities", n);
}

} // namespace

/// The gradation with its least match, and the judging.
class Crosscheck::State {
public:
  State(Gradation g, Limits limits, const ProgressCall &progress);
  State(Gradation g, const Question &question, const Limits &limits, const ProgressCall &progress);
  State(Gradation g, const Question &question, KnownMinimum known);
  const Gradation &gradation() const { return g_; }
  CrosscheckRow judge(const OtherAnswer &answer, const Rational &size_tolerance) const;

private:
  /// An answer's particles, one entry for each class with mass.
  struct Particles {
    std::vector<Integer> q;
    std::vector<std::optional<StatedSize>> sizes;
  };
  /// A question that is not the plain one, with what is known of its least match.
  struct Asked {
    CountsJudge judge;
    KnownMinimum known;
  };
  CrosscheckRow judge_plain(const OtherAnswer &answer, const Rational &size_tolerance) const;
  CrosscheckRow judge_asked(const OtherAnswer &answer, const Rational &size_tolerance) const;
  std::string spread_over_classes(const OtherAnswer &answer, std::vector<Integer> &q,
                                  std::vector<std::optional<StatedSize>> &sizes) const;
  void compare_with_known(CrosscheckRow &row) const;
  std::string in_words(std::size_t j) const;
  std::string in_words(const Particles &particles, std::size_t i) const;
  std::string take(const OtherAnswer &answer, Particles &particles) const;
  Rational scale_at(const Particles &particles, std::size_t i, const Rational &size) const;
  std::string mismatch(const OtherAnswer &answer, const Rational &size_tolerance) const;
  std::string mismatch_of_sizes(const Particles &particles, const Rational &size_tolerance) const;
  std::optional<Rational> max_error(const OtherAnswer &answer) const;

  Gradation g_;
  std::vector<std::size_t> with_mass_; ///< classes with mass
  LeastMatch least_;
  std::optional<Asked> asked_; ///< nothing: the plain question
};

Crosscheck::State::State(Gradation g, Limits limits, const ProgressCall &progress) : g_(std::move(g)) {
  limits.keep_proof = false;
  least_ = least_match(Problem(g_, MassLaw{}, 1), limits, Watch(limits.deadline, progress));
  for (std::size_t j = 0; j < g_.classes(); ++j)
    if (g_.mass(j) != 0)
      with_mass_.push_back(j);
}

Crosscheck::State::State(Gradation g, const Question &question, KnownMinimum known)
    : g_(asked_gradation(std::move(g), question)) {
  asked_.emplace(Asked{CountsJudge(g_, question), std::move(known)});
}

Crosscheck::State::State(Gradation g, const Question &question, const Limits &limits,
                         const ProgressCall &progress)
    : g_(asked_gradation(std::move(g), question)) {
  Question rest = question; // what changes the gradation is made
  rest.pan_size.reset();
  rest.cut_below.reset();
  rest.size_factor = 1;
  SolveOptions options;
  options.limits = limits;
  options.limits.keep_proof = false;
  options.progress = progress;
  CountsJudge judge(g_, question);
  const Match least = solve(g_, rest, options);
  asked_.emplace(Asked{
      std::move(judge),
      {least.lower_bound, least.sample ? least.particles() : std::nullopt, least.status == Status::none}});
}

/// `class 2 (0.3, 0.6]`.
std::string Crosscheck::State::in_words(std::size_t j) const {
  return fmt::format("class {} ({}, {}]", j + 1, shown(g_.lower(j)), shown(g_.upper(j)));
}

/// `class 2 (0.3, 0.6] with 5 particles`.
std::string Crosscheck::State::in_words(const Particles &particles, std::size_t i) const {
  return in_words(with_mass_[i]) + " with " + counted(particles.q[i]);
}

/// Takes the entries of the classes with mass. Returns what is wrong with their number or with a zero, or
/// nothing.
std::string Crosscheck::State::take(const OtherAnswer &answer, Particles &particles) const {
  const std::size_t n = answer.quantities.size();
  const std::vector<std::size_t> index = classes_of(g_, n);
  if (n != index.size()) {
    const std::string of_all = fmt::format("one for each of the {} classes", g_.classes());
    return fmt::format("{}: {}", there_are_quantities(n),
                       with_mass_.size() == g_.classes()
                           ? of_all + " is right"
                           : fmt::format("{} with mass, or {}, is right", with_mass_.size(), of_all));
  }
  if (!answer.sizes.empty() && answer.sizes.size() != n)
    return fmt::format("there are {} sizes for {} quantities: write - for the size of a 0",
                       answer.sizes.size(), n);
  const std::vector<std::optional<StatedSize>> sizes = in_unit_of(g_, answer);
  if (std::string wrong = other_class(g_, answer, index); !wrong.empty())
    return wrong;
  for (std::size_t entry = 0; entry < n; ++entry) {
    const std::size_t j = index[entry];
    const Integer &q = answer.quantities[entry];
    if (g_.mass(j) == 0) {
      if (q != 0)
        return in_words(j) + " has no mass but " + counted(q);
      continue;
    }
    if (q == 0)
      return in_words(j) + " has mass but no particles";
    particles.q.push_back(q);
    particles.sizes.push_back(sizes.empty() ? std::nullopt : sizes[entry]);
  }
  return {};
}

/// The scale at which the particles of a class have the size: q c x^3 / m.
Rational Crosscheck::State::scale_at(const Particles &particles, std::size_t i, const Rational &size) const {
  const std::size_t j = with_mass_[i];
  return Rational(particles.q[i]) * g_.factor(j) * power(size, 3) / g_.mass(j);
}

std::string Crosscheck::State::mismatch_of_sizes(const Particles &particles,
                                                 const Rational &size_tolerance) const {
  /// An end of the scales that a class allows.
  struct End {
    Rational scale;
    bool closed = true;
    std::size_t of = 0;
  };
  std::optional<End> from, to;
  const auto raise = [&from](End end) {
    if (!from || end.scale > from->scale || (end.scale == from->scale && from->closed && !end.closed))
      from = std::move(end);
  };
  const auto lower = [&to](End end) {
    if (!to || end.scale < to->scale)
      to = std::move(end);
  };
  for (std::size_t i = 0; i < with_mass_.size(); ++i) {
    const Rational &bottom = g_.lower(with_mass_[i]);
    const Rational &top = g_.upper(with_mass_[i]);
    raise({scale_at(particles, i, bottom), false, i});
    lower({scale_at(particles, i, top), true, i});
    if (!particles.sizes[i])
      continue;
    const StatedSize &stated = *particles.sizes[i];
    const StatedSize wide{stated.lo * (1 - size_tolerance), stated.hi * (1 + size_tolerance)};
    if (wide.hi <= bottom || wide.lo > top)
      return fmt::format("the size {} is outside its {}", shown(wide.hi <= bottom ? stated.hi : stated.lo),
                         in_words(with_mass_[i]));
    raise({scale_at(particles, i, wide.lo), true, i});
    lower({scale_at(particles, i, wide.hi), true, i});
  }
  if (from->scale < to->scale || (from->scale == to->scale && from->closed))
    return {};
  return fmt::format("the sizes do not fit the quantities: {} has its mass at scales {} {}, {} only up to {}",
                     in_words(particles, from->of), from->closed ? "from" : "above", shown(from->scale),
                     in_words(particles, to->of), shown(to->scale));
}

std::string Crosscheck::State::mismatch(const OtherAnswer &answer, const Rational &size_tolerance) const {
  Particles particles;
  if (std::string wrong = take(answer, particles); !wrong.empty())
    return wrong;
  std::vector<Rational> above, up_to;
  for (std::size_t i = 0; i < with_mass_.size(); ++i) {
    above.push_back(scale_at(particles, i, g_.lower(with_mass_[i])));
    up_to.push_back(scale_at(particles, i, g_.upper(with_mass_[i])));
  }
  const auto highest = std::max_element(above.begin(), above.end());
  const auto least = std::min_element(up_to.begin(), up_to.end());
  if (*highest >= *least)
    return fmt::format("{} can hold its mass at scales up to {}, {} only above {}",
                       in_words(particles, static_cast<std::size_t>(least - up_to.begin())), shown(*least),
                       in_words(particles, static_cast<std::size_t>(highest - above.begin())),
                       shown(*highest));
  return mismatch_of_sizes(particles, size_tolerance);
}

std::optional<Rational> Crosscheck::State::max_error(const OtherAnswer &answer) const {
  if (answer.sizes.size() != answer.quantities.size())
    return std::nullopt;
  const std::vector<std::optional<StatedSize>> sizes = in_unit_of(g_, answer);
  Description sample(g_);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (answer.quantities[i] == 0)
      continue;
    if (!sizes[i] || sizes[i]->hi <= 0)
      return std::nullopt;
    sample.add(sizes[i]->hi, answer.quantities[i]);
  }
  return sample.error().maximum.hi; // spheres: exact
}

CrosscheckRow Crosscheck::State::judge(const OtherAnswer &answer, const Rational &size_tolerance) const {
  assert(size_tolerance >= 0 && size_tolerance < 1);
  CrosscheckRow row = asked_ ? judge_asked(answer, size_tolerance) : judge_plain(answer, size_tolerance);
  if (answer.contradiction.empty())
    return row;
  if (row.verdict == AnswerVerdict::minimal) { // of quantities that the answer itself denies
    row.verdict = AnswerVerdict::not_a_match;
    row.ratio.reset();
  }
  row.reason += (row.reason.empty() ? "" : "; ") + answer.contradiction;
  return row;
}

CrosscheckRow Crosscheck::State::judge_plain(const OtherAnswer &answer,
                                             const Rational &size_tolerance) const {
  CrosscheckRow row;
  row.id = g_.id();
  const Integer known = total(least_.q);
  if (least_.complete)
    row.minimum = known;
  if (answer.failure) {
    row.verdict = *answer.failure;
    row.reason = answer.reason;
    return row;
  }
  row.particles = total(answer.quantities);
  row.max_error = max_error(answer);
  row.reason = mismatch(answer, size_tolerance);
  if (!row.reason.empty()) {
    row.verdict = AnswerVerdict::not_a_match;
  } else if (*row.particles == known) {
    row.verdict = AnswerVerdict::minimal;
    row.minimum = known;
    row.ratio = 1;
  } else if (row.minimum) {
    row.verdict = AnswerVerdict::larger;
    row.ratio = ratio(*row.particles, known);
  } else {
    row.verdict = AnswerVerdict::undecided;
    row.reason = "stopped at a limit: the smallest number is " + to_string(known) + " or more";
  }
  return row;
}

CrosscheckRow Crosscheck::State::judge_asked(const OtherAnswer &answer,
                                             const Rational &size_tolerance) const {
  const KnownMinimum &known = asked_->known;
  CrosscheckRow row;
  row.id = g_.id();
  if (known.particles == known.lower_bound)
    row.minimum = known.particles;
  if (answer.failure) {
    const bool is_none = answer.failure == AnswerVerdict::infeasible && known.has_none;
    row.verdict = is_none ? AnswerVerdict::minimal : *answer.failure;
    row.reason = is_none ? "there is no match, as the answer says" : answer.reason;
    return row;
  }
  row.particles = total(answer.quantities);
  row.max_error = max_error(answer);
  std::vector<Integer> q;
  std::vector<std::optional<StatedSize>> sizes;
  row.reason = spread_over_classes(answer, q, sizes);
  CountsJudge::Finding finding;
  if (row.reason.empty())
    finding = asked_->judge.find(q, sizes, size_tolerance);
  if (!finding.mismatch.empty())
    row.reason = finding.mismatch;
  if (finding.is_undecided)
    row.verdict = AnswerVerdict::undecided;
  else if (!row.reason.empty())
    row.verdict = AnswerVerdict::not_a_match;
  else
    compare_with_known(row);
  return row;
}

/// One entry a class of what the answer has for each class, or for each with mass.
std::string Crosscheck::State::spread_over_classes(const OtherAnswer &answer, std::vector<Integer> &q,
                                                   std::vector<std::optional<StatedSize>> &sizes) const {
  const std::size_t n = answer.quantities.size();
  const std::vector<std::size_t> index = classes_of(g_, n);
  if (n != index.size())
    return fmt::format("{}: one for each of the {} classes is right", there_are_quantities(n), g_.classes());
  if (!answer.sizes.empty() && answer.sizes.size() != n)
    return fmt::format("there are {} sizes for {} quantities: write - for the size of a 0",
                       answer.sizes.size(), n);
  if (std::string wrong = other_class(g_, answer, index); !wrong.empty())
    return wrong;
  q.assign(g_.classes(), 0);
  sizes.assign(g_.classes(), std::nullopt);
  const std::vector<std::optional<StatedSize>> stated = in_unit_of(g_, answer);
  for (std::size_t entry = 0; entry < n; ++entry) {
    const std::size_t j = index[entry];
    q[j] = answer.quantities[entry];
    if (!stated.empty())
      sizes[j] = stated[entry];
  }
  return {};
}

/// The verdict on a match.
void Crosscheck::State::compare_with_known(CrosscheckRow &row) const {
  const KnownMinimum &known = asked_->known;
  if (*row.particles == known.lower_bound) {
    row.verdict = AnswerVerdict::minimal;
    row.minimum = known.lower_bound;
    row.ratio = 1;
  } else if (row.minimum) {
    row.verdict = AnswerVerdict::larger;
    row.ratio = ratio(*row.particles, *row.minimum);
  } else {
    row.verdict = known.particles && *row.particles > *known.particles ? AnswerVerdict::larger
                                                                       : AnswerVerdict::undecided;
    row.reason = "stopped at a limit: the smallest number is " + to_string(known.lower_bound) + " or more";
  }
}

Crosscheck::Crosscheck(Gradation g, const Limits &limits, const ProgressCall &progress)
    : state_(std::make_shared<const State>(std::move(g), limits, progress)) {}

Crosscheck::Crosscheck(Gradation g, const Question &question, const Limits &limits,
                       const ProgressCall &progress)
    : state_(std::make_shared<const State>(std::move(g), question, limits, progress)) {}

Crosscheck Crosscheck::with_minimum(Gradation g, const Question &question, KnownMinimum known) {
  return Crosscheck(std::make_shared<const State>(std::move(g), question, std::move(known)));
}

const Gradation &Crosscheck::gradation() const {
  return state_->gradation();
}

CrosscheckRow Crosscheck::judge(const OtherAnswer &answer, const Rational &size_tolerance) const {
  return state_->judge(answer, size_tolerance);
}

CrosscheckRow Crosscheck::judge(std::string_view answer, const Rational &size_tolerance) const {
  return state_->judge(json_answer(answer), size_tolerance);
}

} // namespace mdm
