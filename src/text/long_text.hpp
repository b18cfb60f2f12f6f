#pragma once
/// \file
/// Long files in pieces.

#include "text/sink.hpp"

#include <fmt/format.h>

#include <iterator>

namespace mdm {

/// Hands text on in pieces of some 64 KiB; finish() hands on the last.
class LongText {
public:
  explicit LongText(const Sink &out) : out_(out) {}

  template <class... Args>
  void add(fmt::format_string<Args...> format, Args &&...args) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Args>(args)...);
    if (buffer_.size() >= piece)
      finish();
  }

  void finish() {
    out_(std::string_view(buffer_.data(), buffer_.size()));
    buffer_.clear();
  }

private:
  static constexpr std::size_t piece = std::size_t{64} << 10;

  const Sink &out_;
  fmt::memory_buffer buffer_;
};

} // namespace mdm
