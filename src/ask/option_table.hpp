#pragma once
/// \file
/// The table of options as a whole, by what takes them.

#include "ask/option_row.hpp"

#include <string>
#include <vector>

namespace mdm {

/// A row, whatever texts it fills.
struct TableOption {
  const char *name, *values;
  OptionKind kind;
  const char *help;
};

/// The options that a command of the program and a function of the modules have in common.
struct OptionsOfCommand {
  const char *command; ///< `convert` of what says how a gradation is read, which all that read one take
  std::vector<TableOption> options;
};

/// \copydoc OptionsOfCommand
const std::vector<OptionsOfCommand> &option_table();

/// The table for who writes the modules' keywords: {"solve": [{"name": "law", "keyword": "law", "member":
/// "law", "kind": "text", "values": "LAW", "help": "..."}, ...], ...}.
std::string option_table_json();

} // namespace mdm
