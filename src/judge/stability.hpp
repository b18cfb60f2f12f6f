#pragma once
/// \file
/// Internal stability: whether the coarse grains of a soil hold back its fine ones.

#include "judge/requirement.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <string_view>

namespace mdm {

/// kenney_lau: H/F >= 1 at every size D with F <= 20 % (30 % where C_u <= 3), where F passes D and H lies
/// between D and 4 D (Kenney and Lau, 1985 and 1986).
/// kezdi: wherever the soil is split, D15 of the coarse part is at most 4 x d85 of the fine part (Kezdi,
/// 1979).
/// burenkova: 0.76 log10(d90/d15) + 1 < d90/d60 < 1.86 log10(d90/d15) + 1 (Burenkova, 1993).
enum class StabilityRule { kenney_lau, kezdi, burenkova };

/// `kenney-lau`, `kezdi`, `burenkova`; nothing for another name.
std::optional<StabilityRule> stability_rule(std::string_view name);
std::string_view name(StabilityRule rule);
/// The rule in words, with its source.
std::string_view about(StabilityRule rule);
/// All names, separated by commas.
std::string stability_rule_names();

/// Judges every curve that rounds to the report, from its finest sieve on: below that no curve is known, and
/// a note says so. Between sieves curves are linear in log size. Of a report that was rounded a verdict that
/// hangs may be one that no curve of it has: its percents are taken at their ends one by one.
/// \param rounding  as for judge()
/// \throws InputError as curves_of
RuleJudgement judge_stability(const UnderstoodGradation &report, StabilityRule rule,
                              const std::optional<Rational> &rounding = std::nullopt);

} // namespace mdm
