#include "ask/suite_lines.hpp"

#include "answer/made_suite.hpp"
#include "ask/option_values.hpp"

namespace mdm {
namespace {

LineRange parse_lines(const std::string &text) {
  const std::size_t hyphen = text.find('-');
  if (hyphen != std::string::npos) {
    const LineRange range{seed64("lines", text.substr(0, hyphen)), seed64("lines", text.substr(hyphen + 1)),
                          1};
    if (range.first >= 1 && range.first <= range.last)
      return range;
  }
  throw InputError(option("lines") + ": " + in_quotes(text) +
                   " is not A-B with A from 1 to B, such as 1001-2000");
}

} // namespace

const std::vector<OptionRow<SuiteTexts>> SuiteTexts::options = {
    {"seed", "S", OptionKind::number, "0 to 2^64 - 1 (1); another seed, other gradations", &SuiteTexts::seed},
    {"count", "N", OptionKind::number, "lines 1 to N (1000)", &SuiteTexts::count},
    {"lines", "A-B", OptionKind::text, "lines A to B", &SuiteTexts::lines},
    {"shard", "I/N", OptionKind::text,
     "of these lines each N-th from the I-th on, for mdm batch --shard I/N --alone; a line before them "
     "says which suite they are of",
     &SuiteTexts::shard}};

std::uint64_t SuiteTexts::asked_seed() const {
  return seed64("seed", seed.value_or("1"));
}

LineRange SuiteTexts::all_lines() const {
  if (count && lines)
    throw InputError(option("count") + " and " + option("lines") + ": give one of them");
  return lines ? parse_lines(*lines) : LineRange{1, count ? seed64("count", *count) : 1000, 1};
}

Shard SuiteTexts::asked_shard() const {
  return shard ? named("shard", *shard, parse_shard) : Shard{1, 1};
}

LineRange lines_of(const LineRange &all, const Shard &shard) {
  if (all.count() < shard.number)
    return {1, 0, 1};
  return {all.first + (shard.number - 1), all.last, shard.count};
}

std::string shard_line(const std::string &sha256, std::uint64_t seed, const LineRange &all,
                       const Shard &shard) {
  return made_shard_json(
             {{sha256, seed, all.first, all.last}, shard.number, shard.count, lines_of(all, shard).count()}) +
         "\n";
}

} // namespace mdm
