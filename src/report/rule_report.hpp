#pragma once
/// \file
/// What a rule of practice says of samples, as text, JSON and CSV.

#include "judge/requirement.hpp"

namespace mdm {

// `digits` >= 1 are significant digits.

/// One line of JSON, schema `mdm-rule-1`, without a newline at its end. Numbers are enclosures ["lo","hi"].
std::string rule_json(const RuleReport &report, unsigned digits);

/// sample,requirement,of,unit,value_lo,value_hi,side,limit_lo,limit_hi,verdict: a row a requirement, and one
/// without a requirement for the sample.
std::string rule_csv(const RuleReport &report, unsigned digits);

/// For people: a table a sample.
std::string rule_text(const RuleReport &report, unsigned digits);

} // namespace mdm
