#pragma once
/// \file
/// The tables of options as options of a command.

#include "ask/option_row.hpp"
#include "files/paths.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <type_traits>
#include <vector>

namespace mdm::cli {

/// Adds the options of a table; `texts` keeps their values and must outlive the command.
template <class Row, class Texts>
void add_options(CLI::App &command, const std::vector<Row> &rows, Texts &texts) {
  for (const Row &row : rows) {
    const auto add = [&](auto place) {
      const std::string name = std::string("--") + row.name;
      if constexpr (std::is_same_v<std::remove_reference_t<decltype(texts.*place)>, bool>)
        return command.add_flag(name, texts.*place, row.help);
      else
        return command.add_option(name, texts.*place, row.help);
    };
    CLI::Option *const added = std::visit(add, row.place);
    if (row.kind == OptionKind::file)
      added->each(protect_input);
    if (row.kind == OptionKind::tolerances)
      added->allow_extra_args(false);
    if (*row.values != '\0')
      added->type_name(row.values);
    if (const std::vector<std::string> choices = row.choices(); !choices.empty())
      added->check(CLI::IsMember(choices));
  }
}

} // namespace mdm::cli
