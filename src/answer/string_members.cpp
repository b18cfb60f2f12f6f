#include "answer/string_members.hpp"

#include <charconv>

namespace mdm {

bool has_member(const nlohmann::json &object, const char *key) {
  return object.contains(key) && !object[key].is_null();
}

const nlohmann::json &member_of(const nlohmann::json &object, const std::string &key) {
  if (!object.is_object() || !object.contains(key))
    throw InputError(key + " is missing");
  return object[key];
}

std::string text_member(const nlohmann::json &object, const std::string &key) {
  const nlohmann::json &value = member_of(object, key);
  if (!value.is_string())
    throw InputError(key + " is no string");
  return value.get<std::string>();
}

std::uint64_t number_member(const nlohmann::json &object, const std::string &key) {
  const std::string text = text_member(object, key);
  std::uint64_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc{} || end != text.data() + text.size())
    throw InputError(key + ": " + in_quotes(text) + " is no whole number from 0 on: write one, such as 3");
  return n;
}

} // namespace mdm
