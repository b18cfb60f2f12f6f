#pragma once
/// \file
/// The options of solving as texts, and what they ask.

#include "cli/asked_question.hpp"

#include <mdm/match/budget.hpp>
#include <mdm/match/solve.hpp>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace mdm::cli {

/// The options that say how a gradation is to be taken. Values are kept as the user wrote them: numbers are
/// read exactly, never through double. All members throw an InputError that names the option, as `--law`,
/// where its value does not serve.
struct GradationTexts {
  using Text = std::optional<std::string>;
  Text law, size_factor, cut_below, pan_size;

  AskedQuestion question() const;
};

/// The envelope that --band has.
using ReadBand = std::function<Envelope(const std::string &band)>;

/// All options of solving, likewise.
struct SolveTexts : GradationTexts {
  std::vector<std::string> tolerances;
  Text band;
  Text min_per_class, at_least, at_most;
  Text specimen, void_ratio, solids_volume;
  Text digits, scale;
  Text max_steps, node_limit, time_limit, gap;

  /// An option with its place here.
  struct Named {
    const char *option;
    Text SolveTexts::*text;
  };
  /// All but --tolerance and --band, in one order.
  static const std::array<Named, 16> all;

  bool is_tolerant() const { return !tolerances.empty() || band; }
  AskedQuestion question(const ReadBand &read_band) const;
  /// The same for a command that looks for exact matches and for those within a tolerance: limits of either
  /// serve.
  AskedQuestion question_of_both(const ReadBand &read_band) const;
  /// The deadline counts from this call.
  SolveOptions options(bool keep_proof = false) const;
};

/// A number of particles that chooses the tolerance, likewise.
struct BudgetTexts {
  GradationTexts::Text particles, grid;

  /// The budget; its kind is the one tolerance of the other options, or retained. \pre particles
  Budget budget(const SolveTexts &others) const;
  /// The question of the other options, without tolerance. \pre particles
  AskedQuestion question(const SolveTexts &others, const ReadBand &read_band) const;
};

} // namespace mdm::cli
