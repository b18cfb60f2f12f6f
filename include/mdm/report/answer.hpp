#pragma once
/// \file
/// A match as text, JSON and CSV.

#include <mdm/match/solve.hpp>
#include <mdm/match/spectrum.hpp>

namespace mdm {

/// One line of JSON, schema `mdm-answer-1`, without a newline at its end. Every exact number is a string.
std::string answer_json(const Match &m, const Spectrum *spectrum = nullptr);

/// lower_<unit>,upper_<unit>,mass,quantity,size_lo_<unit>,size_hi_<unit>: a row a class, empty ones included.
std::string answer_csv(const Match &m);

/// The verdict in one line: N, or the bounds that are certain, and the question.
std::string headline(const Match &m);

/// For people.
std::string answer_text(const Match &m, const Spectrum *spectrum = nullptr);

} // namespace mdm
