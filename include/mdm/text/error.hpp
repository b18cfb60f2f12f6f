#pragma once
/// \file
/// The one exception of the library for what its user can mend.

#include <stdexcept>
#include <string>
#include <string_view>

namespace mdm {

/// Bad input: a file, a number or an option. The message says where, what, and what to do; it is valid UTF-8.
class InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// `text` with control and misleading characters (those of writing direction among them) and non-UTF-8 bytes
/// escaped.
std::string printable(std::string_view text);

/// `text` as a message may show it: in single quotes, escaped as printable does, cut to 80 characters.
std::string in_quotes(std::string_view text);

/// True if `text` is well-formed UTF-8 (no surrogates, no overlong forms).
bool is_utf8(std::string_view text);

} // namespace mdm
