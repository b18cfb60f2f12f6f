#pragma once
/// \file
/// The discs that mdm pack places, from its options.

#include "cli/beta_options.hpp"
#include "cli/reading_flags.hpp"
#include "packing/disc_sizes.hpp"

#include <CLI/CLI.hpp>

namespace mdm::cli {

/// Where sizes come from: a curve, a file of sizes, or a gradation.
struct PackSizes : BetaOptions {
  std::optional<std::string> file, sizes, classes, classing, min_per_class, at_least;
  bool spread = false;
  ReadingFlags reading;

  void add_to(CLI::App &command);
  /// True if any of the options was given.
  bool is_given() const;
  /// The file that is read, or `-` where there is none.
  std::string source() const;
  /// \throws InputError naming the option or the file
  DiscSizes read(std::uint64_t seed) const;

private:
  DiscSizes of_curve(std::uint64_t seed) const;
  DiscSizes of_file(const std::string &path, std::uint64_t seed) const;
  DiscSizes of_gradation(const std::string &content, const std::string &name, std::uint64_t seed) const;
};

} // namespace mdm::cli
