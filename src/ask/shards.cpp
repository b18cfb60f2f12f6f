#include "ask/shards.hpp"

#include "text/file_names.hpp"
#include "text/option_name.hpp"
#include "text/short_list.hpp"

#include <fmt/core.h>

namespace mdm {
namespace {

constexpr const char *solve_again = ": solve the shard again";

/// Refuses a set that is not all shards, each once. \param shards by their numbers
void check_complete(const std::vector<AnsweredShard> &shards) {
  const std::uint64_t count = shards[0].totals.shards;
  std::uint64_t done = 0;
  const auto refuse_gap = [&] {
    throw InputError(
        fmt::format("mdm: shard {}/{} is missing: give the files of all, or solve it", done + 1, count));
  };
  for (const AnsweredShard &shard : shards) {
    if (shard.totals.shard == done)
      throw file_error(shard.answers, fmt::format("shard {} is there already, as {}: give each once",
                                                  shard.name(), printable(shards[done - 1].answers)));
    if (shard.totals.shard != done + 1)
      refuse_gap();
    ++done;
  }
  if (done < count)
    refuse_gap();
}

/// Refuses shards with too few lines: a shard has as many as the one before it, or one less than all before.
void check_line_counts(const std::vector<AnsweredShard> &shards) {
  const auto refuse = [](const AnsweredShard &few, const AnsweredShard &many) {
    throw file_error(
        few.answers,
        fmt::format("shard {} has {} lines, and {} {}: of one suite that cannot be: solve shard {} "
                    "again, with all of its lines",
                    few.name(), few.totals.lines, many.name(), many.totals.lines, few.name()));
  };
  for (std::size_t i = 1; i < shards.size(); ++i) {
    const std::uint64_t first = shards[0].totals.lines, before = shards[i - 1].totals.lines,
                        lines = shards[i].totals.lines;
    if (lines > before)
      refuse(shards[i - 1], shards[i]);
    if (lines < before && before < first)
      refuse(shards[i], shards[0]);
    if (lines < before && before - lines > 1)
      refuse(shards[i], shards[i - 1]);
  }
}

/// The names of the shards that came alone.
std::string alone_names(const std::vector<AnsweredShard> &shards) {
  ShortList names;
  for (const AnsweredShard &shard : shards)
    if (!shard.totals.suite)
      names.add(shard.answers);
  return names.text();
}

} // namespace

std::string AnsweredShard::name() const {
  return fmt::format("{}/{}", totals.shard, totals.shards);
}

void check_same(const AnsweredShard &first, const AnsweredShard &other) {
  const auto refuse = [&](const std::string &what) {
    throw file_error(other.answers, what + " " + printable(first.answers) + solve_again);
  };
  if (other.totals.shards != first.totals.shards)
    refuse(fmt::format("shard {}, where {} is of", other.name(), first.name()));
  if (other.totals.question != first.totals.question)
    refuse(fmt::format("the question is {}, and {} that of", in_quotes(other.totals.question),
                       in_quotes(first.totals.question)));
  if (other.totals.versions != first.totals.versions)
    refuse("the versions of the program and its libraries are not those of");
  if (other.totals.proofs.has_value() != first.totals.proofs.has_value())
    refuse(other.totals.proofs ? "there are proofs, and none of" : "there are no proofs, and there are of");
}

void check_set(const std::vector<AnsweredShard> &shards) {
  check_complete(shards);
  check_line_counts(shards);
}

std::optional<SuiteTotals> suite_of(const std::vector<AnsweredShard> &shards,
                                    const std::optional<SuiteTotals> &named) {
  const AnsweredShard *whole = nullptr;
  LineSum sum;
  for (const AnsweredShard &shard : shards) {
    sum.add(shard.totals.sum);
    if (!shard.totals.suite)
      continue;
    whole = whole ? whole : &shard;
    if (shard.totals.suite != whole->totals.suite)
      throw file_error(shard.answers, "the suite is not that of " + printable(whole->answers) + solve_again);
    if (named && shard.totals.suite != named)
      throw file_error(shard.answers,
                       std::string("the suite is not that of " + option("suite")) + solve_again);
  }
  if (whole || named) {
    const SuiteTotals &suite = whole ? *whole->totals.suite : *named;
    if (sum != suite.sum)
      throw InputError("mdm: of the shards that were solved alone (" + alone_names(shards) +
                       ") one at least has lines that the suite of " +
                       (whole ? printable(whole->answers) : option("suite")) +
                       " does not have there: solve them again, with the lines of that suite");
    return suite;
  }
  for (const AnsweredShard &shard : shards) {
    if (!shard.totals.made)
      throw file_error(
          shard.answers,
          "its lines came alone and do not say which suite they are of: name the whole suite with " +
              option("suite"));
    if (shard.totals.made != shards[0].totals.made)
      throw file_error(shard.answers, "the suite is not that of " + printable(shards[0].answers) +
                                          " (description, seed and lines)" + solve_again);
  }
  return std::nullopt;
}

Totals sum(const std::vector<AnsweredShard> &shards, const std::optional<SuiteTotals> &suite) {
  Totals totals = shards[0].totals;
  totals.suite = suite;
  totals.alone.reset();
  if (suite)
    totals.made.reset();
  totals.shard = totals.shards = 1;
  totals.proofs.reset();
  totals.index.reset();
  for (std::size_t i = 1; i < shards.size(); ++i) {
    totals.sum.add(shards[i].totals.sum);
    totals.lines += shards[i].totals.lines;
    totals.errors += shards[i].totals.errors;
  }
  return totals;
}

} // namespace mdm
