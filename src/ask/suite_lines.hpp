#pragma once
/// \file
/// Which lines of a suite are made.

#include "answer/shard.hpp"
#include "ask/option_row.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace mdm {

/// Lines first, first + step, ..., up to last.
struct LineRange {
  std::uint64_t first, last, step;

  /// How many there are.
  std::uint64_t count() const { return last < first ? 0 : (last - first) / step + 1; }
};

/// What is asked of a suite, as texts.
struct SuiteTexts {
  OptionText seed, count, lines, shard;

  static const std::vector<OptionRow<SuiteTexts>> options;

  /// \throws InputError naming the option where its value does not serve
  std::uint64_t asked_seed() const;
  /// All lines that are asked for, of which a shard has a part. \throws InputError likewise
  LineRange all_lines() const;
  /// All of a suite without it. \throws InputError likewise
  Shard asked_shard() const;
};

/// Those of the lines, one after the other, that the shard has.
LineRange lines_of(const LineRange &all, const Shard &shard);
/// The line that says what those of a shard are of. \param sha256  of the description
std::string shard_line(const std::string &sha256, std::uint64_t seed, const LineRange &all,
                       const Shard &shard);

} // namespace mdm
