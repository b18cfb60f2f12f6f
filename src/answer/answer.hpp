#pragma once
/// \file
/// A match as text, JSON and CSV.

#include "match/spectrum.hpp"
#include "match/spread.hpp"
#include "text/sink.hpp"

#include <mdm/match/solve.hpp>

namespace mdm {

/// One line of JSON, schema `mdm-answer-1`, without a newline at its end. Every exact number is a string.
/// Where openings are irrational, `lower` and `upper` have 15 digits, and `lower_power` and `upper_power` are
/// their exact powers; `size_power` is the exponent. `proof` names the file of the certificate, if there is
/// one.
std::string answer_json(const Match &m, const Spectrum *spectrum = nullptr, const std::string &proof = "");

/// lower_<unit>,upper_<unit>,mass,quantity,size_lo_<unit>,size_hi_<unit>: a row a class, empty ones included.
/// Of several materials there is a last column, material.
std::string answer_csv(const Match &m);

/// The same with the sizes of a spread's particles, "sizes":[["lo","hi"],...] in each class with particles,
/// and its "seed". Memory does not grow with their number.
void spread_json(const Match &m, const Spectrum *spectrum, const Spread &spread, const Sink &sink);

/// lower_<unit>,upper_<unit>,size_lo_<unit>,size_hi_<unit>: a row a particle.
void spread_csv(const Match &m, const Spread &spread, const Sink &sink);

/// The verdict in one line: N, or the bounds that are certain, and the question.
std::string headline(const Match &m);

/// What the budget suffices for, in one line.
std::string budget_text(const MatchBudget &budget);

/// For people; of a spread the smallest and the largest size of each class; with_scale: also the window of
/// the scale and the one that was chosen.
std::string answer_text(const Match &m, const Spectrum *spectrum = nullptr, const Spread *spread = nullptr,
                        bool with_scale = false);

} // namespace mdm
