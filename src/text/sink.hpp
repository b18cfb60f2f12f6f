#pragma once
/// \file
/// The receiver of a text that is too long for memory.

#include <functional>
#include <string_view>

namespace mdm {

/// Takes the next part of a long text.
using Sink = std::function<void(std::string_view)>;

} // namespace mdm
