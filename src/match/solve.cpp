// From a question to its answer. What comes in are a gradation and what is asked; what goes out is a Match:
// a sample, or none, what is certain of the smallest, and the proof.
//
// An exact question becomes a problem with floors (problem.cpp; a volume of solids is a start of the
// scales, whose pi is refined until it decides), its match is found (at_least.cpp), and a scale and sizes
// are chosen. A question with a tolerance first takes the exact match, within a small share of the limits,
// as a first answer; then the search begins (tolerant_answer.cpp). At a limit the answer has both bounds,
// and the proof is that of the lower one.

#include "match/at_least.hpp"
#include "match/exact_sample.hpp"
#include "match/sample_notes.hpp"
#include "match/scale.hpp"
#include "match/tolerant_answer.hpp"
#include "match/watch.hpp"
#include "number/pi.hpp"
#include "text/option_name.hpp"

#include <mdm/match/solve.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// A start scale with bounds so close that nothing which is decided about s_0 differs between them.
class Start {
public:
  Start(const Question &question, const Problem &problem, unsigned places) : places_(places) {
    if (!question.solids)
      return;
    solids_ = question.solids;
    power_ = problem.scale_power();
    weight_ = problem.weight();
    refresh();
  }

  /// True if pi's bounds can be made closer; they are.
  bool refine() {
    if (!bounds_ || bounds_->is_point())
      return false;
    if (places_ == most_pi_places)
      throw InputError(
          "the volume is so close to that of a match that 1000 digits of pi do not decide: change it");
    places_ = std::min(2 * places_, most_pi_places);
    refresh();
    return true;
  }

  const std::optional<Interval> &bounds() const { return bounds_; }
  unsigned places() const { return places_; }

  /// True if s_0's place relative to `scale` is known.
  bool decides(const Rational &scale) const {
    return !bounds_ || bounds_->is_point() || scale <= bounds_->lo || scale >= bounds_->hi;
  }

  /// The problem with the floors of s >= s_0, or nothing while they are undecided.
  std::optional<Problem> floors(const Problem &problem) const {
    const Rational lo = bounds_->lo / problem.scale_unit();
    if (bounds_->is_point())
      return problem.from_scale(lo, false);
    Problem low = problem.from_scale(lo, true);
    const Problem high = problem.from_scale(Rational(bounds_->hi / problem.scale_unit()), true);
    const auto same = [](const ProblemClass &x, const ProblemClass &y) { return x.floor == y.floor; };
    if (!std::equal(low.classes().begin(), low.classes().end(), high.classes().begin(), same))
      return std::nullopt;
    return low;
  }

private:
  void refresh() { bounds_ = power(start_scale(*solids_, weight_, places_), power_); }

  std::optional<Solids> solids_;
  Rational weight_;
  unsigned power_ = 1; ///< of the problem's scales
  unsigned places_;
  std::optional<Interval> bounds_;
};

/// The problem with the start's floors, the start made precise enough for them.
Problem problem_from_start(const Problem &problem, Start &start) {
  for (;;) {
    if (std::optional<Problem> higher = start.floors(problem))
      return std::move(*higher);
    start.refine();
  }
}

/// The window of q, the start made precise enough to say whether s_0 is in it.
Window window_of(const Problem &problem, const std::vector<Integer> &q, Start &start) {
  const Rational &unit = problem.scale_unit();
  Window window{problem.lowest_scale(q) * unit, problem.highest_scale(q) * unit, std::nullopt};
  while (!start.decides(window.above) || !start.decides(window.up_to))
    start.refine();
  window.start = start.bounds();
  return window;
}

void note_precision(Match &match) {
  static const Rational double_step = ratio(1, Integer(Integer(1) << 50));
  const MatchScale &scale = *match.sample->scale;
  if (scale.margin >= double_step)
    return;
  const unsigned e = match.question.law.a * match.gradation.root();
  // The best margin, at the geometric middle, is (up_to / above)^(1/2e) - 1 >= y iff up_to / above >= (1 +
  // y)^(2e).
  const Rational &above = scale.window.above;
  const bool hopeless = match.question.law.is_power() && above > 0 &&
                        scale.window.up_to < above * power(Rational(1 + double_step), 2 * e);
  match.notes.push_back(hopeless ? "no scale keeps all sizes 2^-50 (relative) away from the sieves: numbers "
                                   "in double precision cannot hold this match"
                                 : "at this scale a size is within 2^-50 (relative) of a sieve: in double "
                                   "precision it may fall out of its class");
}

void note_digits(Match &match) {
  const Integer one_digit_more = power_of_ten(match.digits);
  for (std::size_t j = 0; j < match.sample->sizes.size(); ++j) {
    const std::optional<Enclosure> &x = match.sample->sizes[j];
    if (x && x->lo != x->hi && x->lo >= one_digit_more && x->places > 0)
      match.notes.push_back("class " + std::to_string(j + 1) + ": the size is printed with " +
                            std::to_string(to_string(x->lo).size()) + " digits, to lie inside its class");
  }
}

/// At the upper end of the window some size is an opening, which no enclosure reaches where it is irrational.
void check_no_irrational_size(const Gradation &g, const Problem &problem, const std::vector<Integer> &q,
                              const Rational &scale) {
  if (g.root() == 1)
    return;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const ProblemClass &c = problem.classes()[i];
    const Rational up_to = ratio(power(q[i], problem.scale_power()) * c.F, c.mass);
    if (up_to * problem.scale_unit() == scale && !g.opening(c.index + 1).fraction())
      throw InputError("at the upper end of the scales the particles of class " +
                       std::to_string(c.index + 1) +
                       " have the size of the opening above, which is irrational: choose another " +
                       option("scale") + ", or have other openings: " + std::string(g.fractions_remedy()));
  }
}

/// The sample with the quantities q, at the scale that the options choose.
MatchSample placed(const Gradation &g, const Problem &problem, std::vector<Integer> q, Start &start,
                   const SolveOptions &options) {
  Window window = window_of(problem, q, start);
  const Rational scale = choose_scale(window, options.scale, options.digits);
  if (scale == window.up_to)
    check_no_irrational_size(g, problem, q, scale);
  return exact_sample(g, problem, std::move(q), std::move(window), scale, options.digits);
}

/// What the sweep shows: that the match is the smallest, or the bound that it came to.
void set_proof(Match &match, Steps steps, const Rational &above, const Problem &problem) {
  if (!match.complete && match.lower_bound == *match.particles())
    return; // as a bound it is none, and as the end of the sweep it is not shown
  const Integer &asked = match.question.at_least;
  const bool is_asked = asked > 1 && match.lower_bound == asked;
  match.proof.evidence = is_asked ? Chain{} : chain_of(std::move(steps), above, problem);
  if (!match.complete)
    match.proof.bound = match.lower_bound;
}

/// The status, where the search came to its end or not, and whether the sample has more particles than
/// may be.
void set_status(Match &match, const std::optional<Integer> &at_most) {
  if (at_most && match.lower_bound > *at_most)
    match.status = Status::none;
  else if (!match.sample)
    match.status = match.complete ? Status::none : Status::unknown;
  else if (at_most && *match.particles() > *at_most)
    match.status = Status::unknown;
  else
    match.status = match.complete ? Status::optimal : Status::feasible;
}

/// The match without a tolerance; the limits may end it early.
Match solve_exactly(Match match, const SolveOptions &options, const Limits &limits, const Watch &watch) {
  const Question &question = match.question;
  Problem problem(match.gradation, question.law, question.min_per_class);
  Start start(question, problem, std::min(options.digits + 30, most_pi_places));
  if (question.solids)
    problem = problem_from_start(problem, start);

  const Rational from = start.bounds() ? Rational(start.bounds()->lo / problem.scale_unit()) : Rational(0);
  AtLeastMatch found = at_least_match(problem, question.at_least, from, limits, watch);
  match.lower_bound = std::max(total(found.least.q), question.at_least);
  // As few as were asked for is the least, whatever a sweep would still show (Theorem 7).
  const bool as_few_as_asked = question.at_least > 1 && total(found.q) == question.at_least;
  match.complete = found.least.complete || as_few_as_asked;
  if (!limits.max_steps && !match.complete && found.least.steps >= most_steps)
    match.notes.push_back("the search for the smallest match ended after " + std::to_string(most_steps) +
                          " steps, as its classes are so narrow: " + option("max-steps") + " allows more");
  match.sample = placed(match.gradation, problem, std::move(found.q), start, options);
  set_status(match, options.at_most);
  note_digits(match);
  note_precision(match);
  if (limits.keep_proof)
    set_proof(match, std::move(found.least.chain), found.above, problem);
  if (start.bounds() && !start.bounds()->is_point())
    match.proof.pi = enclose_pi(start.places());
  return match;
}

/// A scale of masses s, near the match's where s^p is chosen and s irrational.
Rational mass_scale(const Match &match) {
  const unsigned p = match.scale_power();
  const Rational &scale = match.sample->scale->chosen;
  if (p == 1)
    return scale;
  const unsigned places = match.digits + 30;
  const Integer s = floor_root(floor(Rational(scale * power_of_ten(p * places))), p);
  return ratio(s, power_of_ten(places));
}

/// A reason to end the way to an answer early, certainty of too many particles included.
Limits limits_of(const SolveOptions &options) {
  Limits limits = options.limits;
  limits.at_most = options.at_most;
  return limits;
}

/// A small share of the limits, for what is only a first answer.
Limits share_of(Limits limits) {
  constexpr std::uint64_t first_steps = std::uint64_t{1} << 20; // some 10 ms
  limits.max_steps = std::min(limits.steps(), first_steps);
  limits.keep_proof = false;
  if (const auto now = std::chrono::steady_clock::now(); limits.deadline && *limits.deadline > now)
    limits.deadline = now + (*limits.deadline - now) / 8;
  return limits;
}

TolerantAnswer answer_beside(const Match &match, const Match &exact, const SolveOptions &options,
                             const Watch &watch) {
  return tolerant_answer(match.gradation, match.question, exact.sample->quantities, mass_scale(exact),
                         limits_of(options), options.digits, watch);
}

/// The best that was found within a tolerance.
MatchSample sample_of(TolerantAnswer &answer, unsigned scale_power) {
  return {std::move(answer.found.best->q), std::move(answer.sizes), std::move(answer.shares),
          power(answer.mass, scale_power), std::nullopt};
}

/// A question with a tolerance; the exact match is a first answer, and the only one where no search is made.
Match solve_within_tolerance(Match match, const SolveOptions &options, const Watch &watch) {
  // Knowledge of exact matches is none of all matches.
  const Watch of_exact = watch.telling([&match](Progress &known) {
    known.lower_bound = match.question.at_least;
    known.particles.reset();
  });
  const Limits share = share_of(options.limits);
  const Match exact = solve_exactly(match, options, share, of_exact.until(share.deadline));
  TolerantAnswer answer = answer_beside(match, exact, options, watch);
  if (answer.found.too_large && !exact.complete)
    answer = answer_beside(match, solve_exactly(match, options, options.limits, of_exact), options, watch);
  if (answer.found.too_large)
    match.notes.push_back("a search over so many classes needs too much memory: the match is the exact one, "
                          "and a smaller one within the tolerance was not looked for");
  match.complete = answer.found.complete;
  match.lower_bound = answer.found.lower_bound;
  match.proof.pi = answer.pi;
  if (!answer.found.tree.empty() && (match.complete || answer.found.best || answer.found.proved > 1)) {
    match.proof.evidence = std::move(answer.found.tree);
    if (!match.complete)
      match.proof.bound = answer.found.proved;
  }
  if (answer.found.best) {
    match.sample = sample_of(answer, match.scale_power());
    note_digits(match);
  }
  match.tolerance = std::move(answer.tolerance);
  set_status(match, options.at_most);
  return match;
}

/// A specimen in which a particle of the largest class has no room was hardly meant.
void note_narrow_specimen(Match &match) {
  const std::optional<Rational> width =
      match.question.solids ? narrowest(*match.question.solids) : std::nullopt;
  const Gradation &g = match.gradation;
  const std::size_t j = g.coarsest();
  if (width && compare(RootSize{*width, 1}, g.opening(j)) < 0)
    match.notes.push_back("the specimen is " + to_decimal(*width) + " " + std::string(name(g.unit())) +
                          " at its narrowest, and the particles of class " + std::to_string(j + 1) +
                          " are larger");
}

} // namespace

Match solve(Gradation g, const Question &question, const SolveOptions &options) {
  if (question.solids && !question.law.is_sphere())
    throw InputError("a specimen or volume of solids needs spheres: leave out " + option("law"));
  Match match(question, asked_gradation(std::move(g), question));
  match.digits = options.digits;
  match.notes = match.gradation.notes();
  note_narrow_specimen(match);
  const Watch watch(options.limits.deadline, options.progress);
  Match answer = question.is_tolerant() ? solve_within_tolerance(std::move(match), options, watch)
                                        : solve_exactly(std::move(match), options, limits_of(options), watch);
  if (answer.has_answer())
    for (std::string &note : sample_notes(answer))
      answer.notes.push_back(std::move(note));
  return answer;
}

} // namespace mdm
