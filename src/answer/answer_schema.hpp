#pragma once
/// \file
/// The name of an answer's format.

#include <string_view>

namespace mdm {

/// The schema of the answers of mdm solve and mdm batch.
inline constexpr std::string_view answer_schema = "mdm-answer-1";

} // namespace mdm
