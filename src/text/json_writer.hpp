#pragma once
/// \file
/// JSON, written value by value.

#include "text/sink.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// Writes one JSON value; commas and colons are its business. Numbers are strings of their digits, so that
/// they can be read exactly.
class JsonWriter {
public:
  /// `open` has a space after each comma and colon.
  enum class Spacing { compact, open };

  explicit JsonWriter(Spacing spacing = Spacing::compact) : spacing_(spacing) {}
  /// Hands the text on in pieces of some 64 KiB; hand_on() hands on what is left. The sink must outlive it.
  explicit JsonWriter(const Sink &sink) : sink_(&sink) {}

  JsonWriter &begin_object() { return begin('{'); }
  JsonWriter &end_object() { return end('}'); }
  JsonWriter &begin_array() { return begin('['); }
  JsonWriter &end_array() { return end(']'); }
  /// The key of the value that comes next; plain ASCII without quotes.
  JsonWriter &key(std::string_view name);

  JsonWriter &string(std::string_view text);
  /// A string of characters that need no escapes: digits, or a name of the program's own.
  JsonWriter &plain(std::string_view text);
  JsonWriter &number(std::uint64_t n) { return plain(std::to_string(n)); }
  JsonWriter &boolean(bool value) { return raw(value ? "true" : "false"); }
  JsonWriter &null() { return raw("null"); }
  /// `["lo","hi"]`, two numbers.
  JsonWriter &bounds(std::string_view lo, std::string_view hi) {
    return begin_array().plain(lo).plain(hi).end_array();
  }
  /// An array of strings.
  JsonWriter &strings(const std::vector<std::string> &texts);
  /// A value that is JSON already.
  JsonWriter &raw(std::string_view json);

  /// Lets the value that comes next begin a line.
  JsonWriter &new_line();

  /// \pre there is a sink
  void hand_on();
  /// The text so far. \pre there is no sink, and every object and array has ended
  std::string take();

private:
  JsonWriter &begin(char bracket);
  JsonWriter &end(char bracket);
  void begin_value();
  JsonWriter &end_value();

  Spacing spacing_ = Spacing::compact;
  const Sink *sink_ = nullptr;
  std::string text_;
  unsigned depth_ = 0;   ///< objects and arrays that have not ended
  bool comma_ = false;   ///< a value stands before what comes next
  bool on_line_ = false; ///< what comes next begins a line
};

} // namespace mdm
