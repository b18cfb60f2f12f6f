#pragma once
/// \file
/// Filters: whether a gradation holds back the grains of a base soil, and lets its water pass.

#include "judge/requirement.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <string_view>

namespace mdm {

/// terzaghi: D15 of the filter at most 4 x d85 and at least 4 x d15 of the base (Terzaghi and Peck, 1948).
/// The others: retention by the category of the base, regraded to what passes 4.75 mm; at least 5 x d15 of
/// the base (nrcs_1994: 4 x) and 0.1 mm; at most 5 % fines; a largest size; and D90 against D10, so that it
/// does not segregate.
enum class FilterRule { terzaghi, usbr, nrcs, nrcs_1994, fema };

/// `terzaghi`, `usbr`, `nrcs`, `nrcs-1994`, `fema`; nothing for another name.
std::optional<FilterRule> filter_rule(std::string_view name);
std::string_view name(FilterRule rule);
/// The rule in words, with its source.
std::string_view about(FilterRule rule);
/// All names, separated by commas.
std::string filter_rule_names();

/// What is said of the base beside its gradation.
struct FilterOptions {
  FilterRule rule = FilterRule::fema;
  bool dispersive = false; ///< dispersive clay: finer filters for the categories 1 and 2
  bool regrade = true;     ///< leave the base's grains above 4.75 mm out, where the rule does
};

/// Judges filters for one base.
/// \param rounding  as for judge()
/// \throws InputError as curves_of, and for options that the rule does not have
RuleReport judge_filters(const std::vector<UnderstoodGradation> &filters, const UnderstoodGradation &base,
                         const FilterOptions &options,
                         const std::optional<Rational> &rounding = std::nullopt);

} // namespace mdm
