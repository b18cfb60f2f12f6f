#pragma once
/// \file
/// A run of a published algorithm as text, JSON and CSV, beside the least match.

#include "match/published.hpp"
#include "match/smallest_match.hpp"

#include <string>

namespace mdm {

/// The algorithms of the paper.
enum class PublishedAlgorithm { rounded, fixed_size, spanned_integer };

/// The contents of a run's report.
struct PublishedReport {
  PublishedAlgorithm algorithm = PublishedAlgorithm::rounded;
  std::string settings; ///< in words
  Gradation gradation;
  MassLaw law;
  Published run;
  SmallestMatch least;  ///< N of the least match
  unsigned digits = 15; ///< significant digits of sizes
  std::vector<std::string> notes;
};

/// True if the run reached what its algorithm is for: a sample (rounded), the tolerance (fixed size), an
/// exact match (spanned integer).
bool succeeded(const PublishedReport &report);

/// One line of JSON, schema `mdm-published-1`, without a newline at its end. Every exact number is a string.
std::string published_json(const PublishedReport &report);

/// A row an iteration: multiple,sizes_tried,particles,total_error,maximum_error,worst_class. Errors are
/// parts of 1, cut to 15 significant digits; classes count from 1, and worst_class is empty where no class
/// has an error.
std::string published_csv(const PublishedReport &report);

/// For people.
std::string published_text(const PublishedReport &report);

} // namespace mdm
