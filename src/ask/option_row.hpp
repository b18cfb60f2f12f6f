#pragma once
/// \file
/// The rows of the tables of options.

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace mdm {

/// The value of an option as the user wrote it: numbers are read exactly, never through double.
using OptionText = std::optional<std::string>;

/// What the value of an option is. The types of the modules' keywords follow from it.
enum class OptionKind {
  text,
  number,     ///< exact: text, or what is no float
  seconds,    ///< a number that may be a float
  file,       ///< the path of a file, or in JavaScript what is in it
  tolerances, ///< one or several, each a text or a number; the program takes one a time
  texts,      ///< one or several
  flag        ///< without a value
};

/// An option of a table. The program, its manual pages and completions, and the keywords of the modules come
/// from these rows.
template <class Texts>
struct OptionRow {
  const char *name;   ///< without hyphens before it
  const char *values; ///< what stands for its value in a help: `SIZE`; empty for a flag
  OptionKind kind;
  const char *help;
  std::variant<OptionText Texts::*, std::vector<std::string> Texts::*, bool Texts::*> place;
  std::array<const char *, 4> words = {}; ///< all that it takes, as far as they are not null

  /// Where its text is. \pre it has one, neither none nor several
  OptionText Texts::*text() const { return std::get<OptionText Texts::*>(place); }

  /// All that it takes; empty: what its reader says.
  std::vector<std::string> choices() const {
    return {words.begin(), std::find(words.begin(), words.end(), nullptr)};
  }
};

} // namespace mdm
