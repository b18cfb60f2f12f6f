#include <mdm/error.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/number/pi.hpp>

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
    weight_ = problem.weight();
    refresh();
  }

  /// True if pi's bounds can be made closer; they are.
  bool refine() {
    if (!bounds_ || bounds_->exact())
      return false;
    if (places_ == most_pi_places)
      throw InputError(
          "the volume is so close to that of a match that 1000 digits of pi do not decide: change it");
    places_ = std::min(2 * places_, most_pi_places);
    refresh();
    return true;
  }

  const std::optional<StartScale> &bounds() const { return bounds_; }
  unsigned places() const { return places_; }

  /// True if s_0's place relative to `scale` is known.
  bool decides(const Rational &scale) const {
    return !bounds_ || bounds_->exact() || scale <= bounds_->lo || scale >= bounds_->hi;
  }

  /// The problem with the floors of s >= s_0, or nothing while they are undecided.
  std::optional<Problem> floors(const Problem &problem) const {
    const Rational lo = bounds_->lo / problem.scale_unit();
    if (bounds_->exact())
      return problem.from_scale(lo, false);
    Problem low = problem.from_scale(lo, true);
    const Problem high = problem.from_scale(Rational(bounds_->hi / problem.scale_unit()), true);
    const auto same = [](const ProblemClass &x, const ProblemClass &y) { return x.floor == y.floor; };
    if (!std::equal(low.classes().begin(), low.classes().end(), high.classes().begin(), same))
      return std::nullopt;
    return low;
  }

private:
  void refresh() { bounds_ = start_scale(*solids_, weight_, places_); }

  std::optional<Solids> solids_;
  Rational weight_;
  unsigned places_;
  std::optional<StartScale> bounds_;
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

void note_precision(Match &match, const Rational &above) {
  static const Rational double_step = ratio(1, Integer(Integer(1) << 50));
  if (match.margin >= double_step)
    return;
  const MassLaw &law = match.question.law;
  // The best margin, at the geometric middle, is (up_to / above)^(1/2a) - 1 >= y iff up_to / above >= (1 +
  // y)^(2a).
  const bool hopeless = above > 0 && match.window.up_to < above * power(Rational(1 + double_step), 2 * law.a);
  match.notes.push_back(hopeless ? "no scale keeps all sizes 2^-50 (relative) away from the sieves: numbers "
                                   "in double precision cannot hold this match"
                                 : "at this scale a size is within 2^-50 (relative) of a sieve: in double "
                                   "precision it may fall out of its class");
}

void note_digits(Match &match, unsigned digits) {
  const Integer one_digit_more = power_of_ten(digits);
  for (std::size_t j = 0; j < match.sizes.size(); ++j) {
    const Enclosure &x = match.sizes[j];
    if (x.lo != x.hi && x.lo >= one_digit_more && x.places > 0)
      match.notes.push_back("class " + std::to_string(match.problem.classes()[j].index + 1) +
                            ": the size is printed with " + std::to_string(to_string(x.lo).size()) +
                            " digits, to lie inside its class");
  }
}

/// Window, scale and sizes of match.q.
void place(Match &match, Start &start, const SolveOptions &options) {
  match.window = window_of(match.problem, match.q, start);
  match.scale = choose_scale(match.window, options.scale, options.digits);
  match.margin = size_margin(match.question.law, match.window.above, match.window.up_to, match.scale);
  match.sizes =
      enclose_sizes(match.gradation, match.problem, match.q, match.scale, match.margin, options.digits);
  note_digits(match, options.digits);
  note_precision(match, match.window.above);
}

/// The match without a tolerance; the limits may end it early.
Match solve_exactly(Match match, const SolveOptions &options, const Limits &limits) {
  const Question &question = match.question;
  Start start(question, match.problem, std::min(options.digits + 30, most_pi_places));
  if (question.solids)
    match.problem = problem_from_start(match.problem, start);

  const Rational from =
      start.bounds() ? Rational(start.bounds()->lo / match.problem.scale_unit()) : Rational(0);
  AtLeastMatch found = at_least_match(match.problem, question.at_least, from, limits);
  match.lower_bound = std::max(total(found.least.q), question.at_least);
  // As few as were asked for is the least, whatever a sweep would still show (Theorem 7).
  match.complete = found.least.complete || (question.at_least > 1 && total(found.q) == question.at_least);
  match.status = match.complete ? Status::optimal : Status::feasible;
  match.q = std::move(found.q);
  match.chain = std::move(found.least.chain);
  match.above = found.above * match.problem.scale_unit();
  if (options.at_most && match.lower_bound > *options.at_most)
    match.status = Status::none;
  else if (options.at_most && match.particles() > *options.at_most)
    match.status = Status::unknown;
  place(match, start, options);
  if (start.bounds() && !start.bounds()->exact())
    match.pi = enclose_pi(start.places());
  return match;
}

/// Quantities of all classes, those without mass included.
std::vector<Integer> quantities(const Match &match) {
  std::vector<Integer> q(match.gradation.classes());
  for (std::size_t j = 0; j < match.q.size(); ++j)
    q[match.problem.classes()[j].index] = match.q[j];
  return q;
}

/// A scale of masses s, near the match's where s^b is chosen and s irrational.
Rational mass_scale(const Match &match) {
  const unsigned b = match.question.law.b;
  if (b == 1)
    return match.scale;
  const unsigned places = match.digits + 30;
  const Integer s = floor_root(floor(Rational(match.scale * power_of_ten(b * places))), b);
  return ratio(s, power_of_ten(places));
}

/// What ends the way to an answer early: also that there are too many particles for certain.
Limits limits_of(const SolveOptions &options) {
  Limits limits = options.limits;
  limits.at_most = options.at_most;
  return limits;
}

/// A question with a tolerance; the exact match is a first answer.
Match solve_within_tolerance(Match match, const SolveOptions &options) {
  const Match exact = solve_exactly(match, options, options.limits);
  match.tolerant = tolerant_answer(match.gradation, match.question, quantities(exact), mass_scale(exact),
                                   limits_of(options), options.digits);
  if (match.tolerant->found.too_large)
    match.notes.push_back("a search over so many classes needs too much memory: the match is the exact one, "
                          "and a smaller one within the tolerance was not looked for");
  const TolerantResult &found = match.tolerant->found;
  match.complete = found.complete;
  match.lower_bound = found.lower_bound;
  match.pi = match.tolerant->pi;
  match.scale = 1;
  if (!found.best)
    match.status = found.complete ? Status::none : Status::unknown;
  else if (options.at_most && match.lower_bound > *options.at_most)
    match.status = Status::none;
  else if (options.at_most && match.particles() > *options.at_most)
    match.status = Status::unknown;
  else
    match.status = found.complete ? Status::optimal : Status::feasible;
  return match;
}

} // namespace

Enclosure Match::solids_volume() const {
  thread_local Enclosure cached = enclose_pi(40);
  if (digits + 10 > cached.places)
    cached = enclose_pi(digits + 10);
  const Rational &weight = tolerant ? tolerant->weight : problem.weight();
  const Integer n = numerator(scale) * numerator(weight);
  const Integer d = denominator(scale) * denominator(weight) * 6 * power_of_ten(cached.places);
  return enclose_interval(n * cached.lo, n * cached.hi, d, digits);
}

Match solve(Gradation g, const Question &question, const SolveOptions &options) {
  if (question.solids && !question.law.is_sphere())
    throw InputError("a specimen or volume of solids needs spheres: leave out --law " +
                     question.law.exponent());
  Gradation asked = asked_gradation(std::move(g), question);
  Problem problem(asked, question.law, question.min_per_class);
  Match match(question, std::move(asked), std::move(problem));
  match.digits = options.digits;
  match.notes = match.gradation.notes();
  return question.is_tolerant() ? solve_within_tolerance(std::move(match), options)
                                : solve_exactly(std::move(match), options, limits_of(options));
}

} // namespace mdm
