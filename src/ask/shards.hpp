#pragma once
/// \file
/// The shards of a batch, held beside each other.

#include "answer/totals.hpp"

#include <optional>
#include <string>
#include <vector>

namespace mdm {

/// A shard's answers, and what its totals say.
struct AnsweredShard {
  std::string answers; ///< the name of their file
  Totals totals;

  /// `I/N`.
  std::string name() const;
};

/// Refuses a shard that was not asked the same as the first. \throws InputError naming its file
void check_same(const AnsweredShard &first, const AnsweredShard &other);
/// Refuses what is not all shards, each once, with as many lines as they have of one suite.
/// \param shards  by their numbers \throws InputError naming the file, or the shard that is missing
void check_set(const std::vector<AnsweredShard> &shards);
/// The suite that all shards are of; nothing where it is known by its making alone.
/// \param named that of --suite, or nothing
/// \throws InputError if they are of several, or it is not known that they are of one
std::optional<SuiteTotals> suite_of(const std::vector<AnsweredShard> &shards,
                                    const std::optional<SuiteTotals> &named);
/// The totals of the set, without its files and its exit code. \param suite where it was read
Totals sum(const std::vector<AnsweredShard> &shards, const std::optional<SuiteTotals> &suite);

} // namespace mdm
