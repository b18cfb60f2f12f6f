#pragma once

#include "text.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace mdm::checker {

/// JSON that is read in one pass, with every number from its text. All throw Malformed.
class JsonText {
public:
  explicit JsonText(std::string_view text) : rest_(text) {}

  /// The next character that is no white space; 0 at the end.
  char peek();
  bool take(char c);
  void demand(char c);
  /// Calls element() at each element of an array, or of what else has commas between two brackets.
  void sequence(char open, char close, const std::function<void()> &element);
  /// Calls member(key) at each value of an object, which reads it.
  void object(const std::function<void(const std::string &)> &member);
  std::string string();
  /// The text of a number as JSON writes it.
  std::string_view number();
  /// A string that holds a decimal, or a number.
  mpq_class decimal();
  /// Passes over a value of any kind.
  void skip(unsigned depth = 0);

protected:
  std::string_view rest_;

private:
  char next();
  std::string escaped();
  std::uint32_t code_unit();
};

} // namespace mdm::checker
