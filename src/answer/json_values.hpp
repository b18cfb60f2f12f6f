#pragma once
/// \file
/// Exact values in JSON: write(json.key("particles"), n).

#include "text/json_writer.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/number/enclosure.hpp>

#include <optional>
#include <string>

namespace mdm {

/// A string of digits.
inline JsonWriter &write(JsonWriter &json, const Integer &n) {
  return json.plain(to_string(n));
}

/// `p/q`, or `p` where q = 1, in a string.
inline JsonWriter &write(JsonWriter &json, const Rational &r) {
  return json.plain(to_string(r));
}

/// `["lo","hi"]`.
inline JsonWriter &write(JsonWriter &json, const Enclosure &e) {
  return json.bounds(e.lower_text(), e.upper_text());
}

/// null for nothing.
template <class Value>
JsonWriter &write(JsonWriter &json, const std::optional<Value> &value) {
  return value ? write(json, *value) : json.null();
}

/// A decimal in plain notation, in a string; null for nothing.
inline JsonWriter &write_decimal(JsonWriter &json, const std::optional<Rational> &decimal) {
  return decimal ? json.plain(to_decimal(*decimal)) : json.null();
}

/// null for what is open.
inline JsonWriter &write_truth(JsonWriter &json, const std::optional<bool> &truth) {
  return truth ? json.boolean(*truth) : json.null();
}

/// null for an empty text.
inline JsonWriter &write_text(JsonWriter &json, const std::string &text) {
  return text.empty() ? json.null() : json.string(text);
}

} // namespace mdm
