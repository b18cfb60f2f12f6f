#pragma once
/// \file
/// Text that reports are made in.

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>

namespace mdm {

using TextBuffer = fmt::memory_buffer;

template <class... Args>
void add(TextBuffer &out, fmt::format_string<Args...> format, Args &&...args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

} // namespace mdm
