#pragma once
/// \file
/// The changes that make one gradation of several, or another of one, as texts.

#include "ask/option_row.hpp"
#include "gradation/regraded.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <string>
#include <vector>

namespace mdm {

/// Joining, splitting, scalping, replacement and parallel gradations.
struct RegradingTexts {
  std::vector<std::string> join, split; ///< the coarse file, the fine file; or empty
  OptionText at, fine_mass, scalp, parallel_ratio;
  std::vector<std::string> replace; ///< `above:SIZE`, `into`, `FROM..TO`; or empty

  bool is_given() const;
  /// The two files that are joined, coarse and fine; empty where one file is read.
  const std::vector<std::string> &files() const { return join.empty() ? split : join; }
  /// \throws InputError where options do not go together
  void check(const OptionText &file) const;

  /// The two joined. \param names  of the files, for messages \pre there are two
  Regraded joined_parts(const UnderstoodGradation &coarse, const UnderstoodGradation &fine,
                        const std::vector<std::string> &names) const;
  /// Scalps, replaces and scales, in this order, what is asked of them. \param file  for messages
  Regraded changed(Regraded g, const std::string &file) const;
};

} // namespace mdm
