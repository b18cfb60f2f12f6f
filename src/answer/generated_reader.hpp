#pragma once
/// \file
/// The reader of sets that mdm generate wrote.

#include "gradation/size_range.hpp"

#include <mdm/gradation/gradation.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// A set of an mdm-generate-1, or of its classes as CSV.
struct StatedSet {
  /// A size class; bounds and fraction as they are printed: irrational ones rounded down.
  struct Class {
    Rational lower, upper, volume_fraction;
    bool is_rounded = false;         ///< one of them
    std::optional<Integer> quantity; ///< open: the match was not found
  };

  std::string id;
  std::optional<SizeUnit> unit; ///< open: none was said
  unsigned dimension = 3;       ///< 2: of discs
  std::vector<Class> classes;
  std::vector<SizeRange> sizes; ///< of the particles, class after class; empty where they were not asked for
};

/// True for a text that begins as such a set in JSON, or as its classes in CSV.
bool is_generated(std::string_view text);

/// Reads a set. `file` precedes messages.
/// \throws InputError if it is none
StatedSet read_generated(std::string_view text, const std::string &file);

/// The set's classes and volume fractions as a gradation, in mm where no unit was said; notes say what is
/// rounded.
/// \throws InputError as Gradation's constructor
Gradation set_gradation(const StatedSet &set);

} // namespace mdm
