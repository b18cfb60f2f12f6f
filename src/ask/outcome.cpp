#include "ask/outcome.hpp"

#include <algorithm>

namespace mdm {

const char *name(Outcome outcome) {
  return outcome == Outcome::done ? "done" : outcome == Outcome::negative ? "negative" : "limited";
}

Outcome outcome_of(Status status) {
  switch (status) {
  case Status::optimal:
    return Outcome::done;
  case Status::none:
    return Outcome::negative;
  default:
    return Outcome::limited;
  }
}

Outcome outcome_of(const Match &match, const Limits &limits) {
  if (match.budget && !match.budget->is_decided)
    return Outcome::limited;
  const bool is_close =
      match.status == Status::feasible && limits.is_close(*match.particles(), match.lower_bound);
  return is_close ? Outcome::done : outcome_of(match.status);
}

Outcome outcome_of(Verdict verdict) {
  switch (verdict) {
  case Verdict::match:
    return Outcome::done;
  case Verdict::undecided:
    return Outcome::limited;
  default:
    return Outcome::negative;
  }
}

Outcome outcome_of(Compliance verdict) {
  switch (verdict) {
  case Compliance::holds:
    return Outcome::done;
  case Compliance::undecided:
    return Outcome::limited;
  default:
    return Outcome::negative;
  }
}

Outcome outcome_of(const CrosscheckSummary &summary, bool must_be_minimal) {
  if (summary.count(AnswerVerdict::undecided) > 0)
    return Outcome::limited;
  const bool is_good = std::all_of(answer_verdicts.begin(), answer_verdicts.end(), [&](AnswerVerdict v) {
    return v == AnswerVerdict::minimal || (v == AnswerVerdict::larger && !must_be_minimal) ||
           summary.count(v) == 0;
  });
  return is_good ? Outcome::done : Outcome::negative;
}

Outcome outcome_of(const Tradeoff &tradeoff) {
  const auto are_certain = [](const std::vector<TradeoffRow> &rows) {
    return std::all_of(rows.begin(), rows.end(), [](const TradeoffRow &row) { return row.is_certain(); });
  };
  const bool all_are_certain = are_certain(tradeoff.by_tolerance) && are_certain(tradeoff.by_sieve) &&
                               are_certain(tradeoff.by_size_factor) &&
                               std::all_of(tradeoff.missed.begin(), tradeoff.missed.end(),
                                           [](const Tradeoff::MissedBudget &b) { return b.is_certain; });
  if (!all_are_certain)
    return Outcome::limited;
  const auto have_none = [](const std::vector<TradeoffRow> &rows) {
    return std::all_of(rows.begin(), rows.end(), [](const TradeoffRow &row) { return row.has_none; });
  };
  return have_none(tradeoff.by_tolerance) && have_none(tradeoff.by_sieve) ? Outcome::negative : Outcome::done;
}

Outcome outcome_of(const SoilDescription &description) {
  return description.limited() ? Outcome::limited : Outcome::done;
}

Outcome outcome_of(const BlendAnswer &blends) {
  switch (blends.status) {
  case BlendAnswer::Status::optimal:
    return Outcome::done;
  case BlendAnswer::Status::none:
    return Outcome::negative;
  default:
    return Outcome::limited;
  }
}

} // namespace mdm
