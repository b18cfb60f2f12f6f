#pragma once
/// \file
/// The certificate of another solver's answer.

#include "crosscheck/other_answer.hpp"

#include <mdm/match/question.hpp>

#include <optional>
#include <string>

namespace mdm {

/// A certificate, and the canonical sample that it is of.
struct AnswerProof {
  std::string sample, certificate;
};

/// The certificate that the particles of an answer match, or do not. They have some sizes in their classes,
/// within the size tolerance of those that are stated; a class of which none is stated has any of its sizes.
/// Where all such samples are a match, or none is, the sample is one of ranges. Else, for exact matches by a
/// law x^a, it has the sizes at one scale, which match exactly. Nothing where there is neither, or there are
/// no particles.
/// \param g  with the question's changes
/// \throws InputError if a limit of the format is passed
std::optional<AnswerProof> answer_proof(const Gradation &g, const Question &question,
                                        const OtherAnswer &answer, const Rational &size_tolerance);

} // namespace mdm
