#include "text/json_writer.hpp"

#include "text/json_text.hpp"

#include <cassert>
#include <utility>

namespace mdm {
namespace {

constexpr std::size_t piece = std::size_t{64} << 10;

} // namespace

JsonWriter &JsonWriter::key(std::string_view name) {
  begin_value();
  text_.append("\"").append(name).append(spacing_ == Spacing::open ? "\": " : "\":");
  return *this;
}

JsonWriter &JsonWriter::string(std::string_view text) {
  return raw(json_string(text));
}

JsonWriter &JsonWriter::plain(std::string_view text) {
  begin_value();
  text_.append("\"").append(text).append("\"");
  return end_value();
}

JsonWriter &JsonWriter::strings(const std::vector<std::string> &texts) {
  begin_array();
  for (const std::string &text : texts)
    string(text);
  return end_array();
}

JsonWriter &JsonWriter::raw(std::string_view json) {
  begin_value();
  text_.append(json);
  return end_value();
}

JsonWriter &JsonWriter::new_line() {
  on_line_ = true;
  return *this;
}

void JsonWriter::hand_on() {
  assert(sink_ != nullptr);
  (*sink_)(text_);
  text_.clear();
}

std::string JsonWriter::take() {
  assert(sink_ == nullptr && depth_ == 0);
  return std::move(text_);
}

JsonWriter &JsonWriter::begin(char bracket) {
  begin_value();
  text_ += bracket;
  ++depth_;
  return *this;
}

JsonWriter &JsonWriter::end(char bracket) {
  assert(depth_ > 0);
  --depth_;
  text_ += bracket;
  return end_value();
}

/// The signs between the value before and the next one. A key is the beginning of a value.
void JsonWriter::begin_value() {
  if (std::exchange(comma_, false))
    text_ += spacing_ == Spacing::open && !on_line_ ? ", " : ",";
  if (std::exchange(on_line_, false))
    text_ += '\n';
}

JsonWriter &JsonWriter::end_value() {
  comma_ = true;
  if (sink_ != nullptr && text_.size() >= piece)
    hand_on();
  return *this;
}

} // namespace mdm
