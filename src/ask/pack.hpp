#pragma once
/// \file
/// Packings of discs: what is asked, and the discs.

#include "ask/beta_options.hpp"
#include "ask/reading_options.hpp"
#include "packing/apollonian.hpp"
#include "packing/deposit.hpp"
#include "packing/disc_sizes.hpp"

#include <functional>
#include <string>
#include <vector>

namespace mdm {

/// The content of the file that the discs are in.
using ReadDiscs = std::function<std::string(const std::string &path)>;

/// What is asked of a packing, as texts: where its discs come from, a curve, a file of sizes or a gradation,
/// and how they are placed; or a gasket, which has its own. All members throw an InputError that names the
/// option where its value does not serve.
struct PackTexts : BetaTexts {
  OptionText file, sizes, classes, classing, min_per_class, at_least;
  bool spread = false;
  ReadingTexts reading;
  OptionText width, floor, rule, order, seed;
  bool periodic = false, walls = false, positions = false;
  OptionText gasket, smallest;
  bool count_only = false;

  static const std::vector<OptionRow<PackTexts>> disc_options, gasket_options, place_options, answer_options;

  /// True if any of the options that say where discs come from was given.
  bool are_discs_given() const;
  /// True if any of the options that say how discs are placed was given.
  bool are_places_given() const;
  /// The file that is read, or `-` where there is none.
  std::string source() const;
  /// The discs. \throws InputError naming the option or the file
  DiscSizes discs(const ReadDiscs &read) const;
  /// How they are placed, but for the width.
  DepositOptions deposit_options() const;
  /// The width in the unit of the discs, if one was given. \param unit  theirs; empty: any
  std::optional<Rational> width_in(const std::string &unit) const;

  /// The gasket, and the radius of its smallest circles.
  ApollonianGasket asked_gasket() const;
  Rational smallest_circle() const;

private:
  std::uint64_t draw_seed() const;
  DiscSizes of_curve() const;
  DiscSizes of_file(const ReadDiscs &read) const;
  DiscSizes of_gradation(const std::string &content, const std::string &name) const;
};

} // namespace mdm
