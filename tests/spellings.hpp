#pragma once
/// \file
/// Messages that name options, as each front end spells them.

#include "catch.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <cctype>
#include <string>
#include <string_view>

namespace mdm_test {

/// Spells options so while it is there, and then as the program does.
class Spelled {
public:
  explicit Spelled(mdm::OptionSpelling spelling) { mdm::spell_options(spelling); }
  ~Spelled() { mdm::spell_options(mdm::OptionSpelling::program); }
  Spelled(const Spelled &) = delete;
  Spelled &operator=(const Spelled &) = delete;
};

/// Words of a message, in each spelling.
struct Spellings {
  std::string_view program;
  std::string_view keyword;
  std::string_view member;
};

/// True if an option stands there as on the command line, `--word`.
inline bool has_hyphens(std::string_view message) {
  for (std::size_t at = message.find("--"); at != message.npos; at = message.find("--", at + 1))
    if (at + 2 < message.size() && std::islower(static_cast<unsigned char>(message[at + 2])) != 0)
      return true;
  return false;
}

/// What `action` throws as InputError; a failure if it does not.
template <typename Action>
std::string refusal_of(const Action &action) {
  try {
    action();
  } catch (const mdm::InputError &e) {
    return e.what();
  }
  FAIL("no InputError");
  return "";
}

/// Checks that `message()`, which quotes no command, has these words in each spelling, and hyphens for the
/// program alone.
template <typename Message>
void check_spellings(const Message &message, const Spellings &words) {
  const auto check = [&message](mdm::OptionSpelling spelling, std::string_view expected) {
    const Spelled spelled(spelling);
    const std::string text = message();
    INFO(text << "\nexpected: " << expected);
    CHECK(text.find(expected) != text.npos);
    CHECK(has_hyphens(text) == (spelling == mdm::OptionSpelling::program));
  };
  check(mdm::OptionSpelling::program, words.program);
  check(mdm::OptionSpelling::keyword, words.keyword);
  check(mdm::OptionSpelling::member, words.member);
}

} // namespace mdm_test
