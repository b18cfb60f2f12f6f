#pragma once
/// \file
/// How a run ended.

#include "crosscheck/crosscheck_report.hpp"
#include "report/verification.hpp"
#include "soil/describe.hpp"

#include <mdm/blend/blend.hpp>
#include <mdm/judge/specification.hpp>
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
/// What hangs on the rounding of a report is no pass.
Outcome outcome_of(Compliance verdict);
/// That of the judgement of a solver. \param must_be_minimal  a match that is larger than needed is not
/// enough
Outcome outcome_of(const CrosscheckSummary &summary, bool must_be_minimal);
Outcome outcome_of(const Tradeoff &tradeoff);
Outcome outcome_of(const BlendAnswer &blends);
Outcome outcome_of(const SoilDescription &description);

} // namespace mdm
