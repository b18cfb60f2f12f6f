#pragma once
/// \file
/// How a run ended.

#include "report/verification.hpp"
#include "soil/describe.hpp"

#include <mdm/match/limits.hpp>
#include <mdm/match/match.hpp>
#include <mdm/match/tradeoff.hpp>

namespace mdm {

/// The end of a run that had no bad input.
enum class Outcome {
  done,     ///< done, accepted, matched
  negative, ///< a negative verdict, with its report
  limited   ///< a limit was reached; what is certain was reported
};

/// `done`, `negative` or `limited`.
const char *name(Outcome outcome);

/// `limited` where a limit came first, whether there is a match or not.
Outcome outcome_of(Status status);
/// That of a match: a gap that was asked for may be enough, and a budget must be decided.
Outcome outcome_of(const Match &match, const Limits &limits);
Outcome outcome_of(Verdict verdict);
Outcome outcome_of(const Tradeoff &tradeoff);
Outcome outcome_of(const SoilDescription &description);

} // namespace mdm
