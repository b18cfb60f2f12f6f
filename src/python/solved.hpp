#pragma once
/// \file
/// A match as Python holds it.

#include "ask/outcome.hpp"
#include "match/spread.hpp"
#include "python/question.hpp"

#include <mdm/match/solve.hpp>

#include <memory>
#include <string>

namespace mdm::python {

/// A match with its answer in JSON, and what a command would exit with. It is shared with what comes of it,
/// such as its spread.
class Solved {
public:
  Solved(Match match, const Limits &limits);

  const Match &match() const { return match_; }
  /// mdm-answer-1.
  const std::string &json() const { return json_; }
  Outcome outcome() const { return outcome_; }
  /// True if what a proof is written from was to be kept.
  bool keeps_proof() const { return keeps_proof_; }

private:
  Match match_;
  std::string json_;
  Outcome outcome_;
  bool keeps_proof_;
};

} // namespace mdm::python
