#pragma once
/// \file
/// The rows of the tables of options.

#include <optional>
#include <string>

namespace mdm {

/// The value of an option as the user wrote it: numbers are read exactly, never through double.
using OptionText = std::optional<std::string>;

/// An option of a table. The program, its manual pages and completions, and the keywords of the modules come
/// from these rows.
template <class Texts>
struct OptionRow {
  const char *name;   ///< without hyphens before it
  const char *values; ///< what stands for its value in a help: `SIZE`
  const char *help;
  OptionText Texts::*text;
};

} // namespace mdm
