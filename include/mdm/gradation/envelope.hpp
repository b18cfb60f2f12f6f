#pragma once
/// \file
/// Specification envelopes.

#include <mdm/gradation/size_unit.hpp>

#include <optional>
#include <string>
#include <vector>

namespace mdm {

/// Bounds on the percent that passes each of some sieves: a curve is within the envelope if min_j <= passing
/// of sizes_j <= max_j for all j. At least one sieve; sizes ascend; bounds are in [0, 100], min_j = 0 at size
/// 0. An envelope may contradict itself.
struct Envelope {
  std::string id;
  SizeUnit unit = SizeUnit::mm;
  std::vector<Rational> sizes;
  std::vector<Rational> passing_min, passing_max; ///< percent
  std::vector<std::string> notes;                 ///< what the reader assumed
};

/// Why no curve is within the envelope, for example `at least 60 percent must pass 1.18 mm, but at most 50
/// may pass 2.36 mm`; nothing if one is.
std::optional<std::string> contradiction(const Envelope &envelope);

/// True of the content of a CSV file whose header names passing_min_percent or passing_max_percent: what
/// read_envelope reads of it, mdm-check reads too.
bool is_canonical_envelope(std::string_view content);

/// Reads an envelope from the content of a CSV file with a column of sizes as in a gradation file and the
/// columns passing_min_percent and passing_max_percent, or of a table with lower and upper limits of the
/// percent that passes. `file` names it in messages.
/// \throws InputError `file:line: what is wrong and what to do`
Envelope read_envelope(std::string_view content, const std::string &file);

} // namespace mdm
