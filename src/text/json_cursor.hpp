#pragma once
/// \file
/// The place that a JSON parser has come to.

#include <cstddef>
#include <iterator>

namespace mdm {

/// Walks over the content and leaves behind how far the parser has come, for messages.
class JsonCursor {
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char *;
  using reference = const char &;

  JsonCursor(const char *at, const char **reached) : at_(at), reached_(reached) {}
  reference operator*() const { return *at_; }
  JsonCursor &operator++() {
    *reached_ = ++at_;
    return *this;
  }
  bool operator==(const JsonCursor &other) const { return at_ == other.at_; }
  bool operator!=(const JsonCursor &other) const { return at_ != other.at_; }

private:
  const char *at_;
  const char **reached_;
};

} // namespace mdm
