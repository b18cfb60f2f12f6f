#pragma once
/// \file
/// The nearest correct name to a misspelt one.

#include <span>
#include <string_view>

namespace mdm {

/// The one of `names` that `word` may have been meant to be, capital letters aside: one of them begins with
/// the other, or it differs in at most half of its letters. Empty where none is so near.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names);

} // namespace mdm
