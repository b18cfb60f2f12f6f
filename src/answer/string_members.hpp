#pragma once
/// \file
/// Members of JSON objects whose values are strings, as our own formats have them.

#include "text/json_tree.hpp"

#include <cstdint>
#include <string>

namespace mdm {

/// True if the object has the member, and it is not null. \pre it is an object
bool has_member(const nlohmann::json &object, const char *key);
/// \throws InputError if the object is none, or has no such member
const nlohmann::json &member_of(const nlohmann::json &object, const std::string &key);
/// \throws InputError also if the member is no string
std::string text_member(const nlohmann::json &object, const std::string &key);
/// \throws InputError also if the string is no whole number below 2^64
std::uint64_t number_member(const nlohmann::json &object, const std::string &key);

} // namespace mdm
