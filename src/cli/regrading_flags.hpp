#pragma once
/// \file
/// The options that make one gradation of several, or change one.

#include "cli/reading_flags.hpp"
#include "gradation/regraded.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm::cli {

/// Joining, splitting, scalping, replacement and parallel gradations.
struct RegradingFlags {
  std::vector<std::string> join, split; ///< the coarse file, the fine file; or empty
  std::optional<std::string> at, fine_mass, scalp, parallel_ratio;
  std::vector<std::string> replace; ///< `above:SIZE`, `into`, `FROM..TO`; or empty

  void add_to(CLI::App &command);
  bool is_given() const;
  /// The two files that are joined, coarse and fine; empty where one file is read.
  const std::vector<std::string> &files() const { return join.empty() ? split : join; }
  /// \throws InputError where options do not go together
  void check(const std::optional<std::string> &file) const;

  /// The files joined. \pre there are two
  Regraded joined_files(const ReadingFlags &reading, bool quiet) const;
  /// Scalps, replaces and scales, in this order, what is asked of them. \param file  for messages
  Regraded changed(Regraded g, const std::string &file) const;
};

} // namespace mdm::cli
