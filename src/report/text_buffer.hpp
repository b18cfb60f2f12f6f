#pragma once
/// \file
/// Text that reports are made in.

#include <mdm/number/enclosure.hpp>

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>

namespace mdm {

using Buffer = fmt::memory_buffer;

template <class... Args>
void add(Buffer &out, fmt::format_string<Args...> format, Args &&...args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

/// `["lo","hi"]`.
inline std::string json_enclosure(const Enclosure &e) {
  return fmt::format(R"(["{}","{}"])", e.lower_text(), e.upper_text());
}

} // namespace mdm
