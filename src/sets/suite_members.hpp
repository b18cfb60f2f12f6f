#pragma once
/// \file
/// Members of the JSON objects of a suite's description.

#include "sets/suite_description.hpp"

#include <mdm/text/error.hpp>

#include <nlohmann/json.hpp>

#include <set>
#include <string>

namespace mdm {

/// The members of an object of json_tree. What is wrong is an InputError that names the member.
class SuiteMembers {
public:
  /// \param where  its name in messages; empty for the whole
  SuiteMembers(const nlohmann::json &object, std::string where);

  bool has(const char *key);
  /// The member, which must be there.
  const nlohmann::json &value(const char *key);
  std::string text(const char *key);
  /// The text, which must be one of `words`. Returns its place among them.
  std::size_t word(const char *key, const std::vector<std::string> &words);
  bool boolean(const char *key);
  /// A decimal above 0, of at most 100 characters, as every number.
  Rational positive(const char *key) { return positive(key, value(key)); }
  Rational positive(const char *key, const nlohmann::json &number) const;
  /// A number, or [from, to] with from <= to, all from `least` to `most`.
  NumberRange numbers(const char *key, const Rational &least, const Rational &most);
  /// A whole number, or [from, to] of such with from <= to, all from `least` to `most`.
  CountRange counts(const char *key, std::uint32_t least, std::uint32_t most);
  std::uint32_t count(const char *key, std::uint32_t least, std::uint32_t most);

  /// Refuses members that were not asked for.
  void refuse_others() const;
  [[noreturn]] void refuse(const std::string &key, const std::string &what) const;

private:
  /// The value of a number's text. \param wrong  what is said of a value that is none
  Rational decimal(const char *key, const nlohmann::json &number, const std::string &wrong) const;

  const nlohmann::json &object_;
  std::string where_;
  std::set<std::string> known_;
};

} // namespace mdm
