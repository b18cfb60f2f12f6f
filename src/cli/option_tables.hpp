#pragma once
/// \file
/// The tables of options as options of a command.

#include "ask/option_row.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace mdm::cli {

/// Adds the options of a table; `texts` keeps their values and must outlive the command.
template <class Row, class Texts>
void add_options(CLI::App &command, const std::vector<Row> &rows, Texts &texts) {
  for (const Row &row : rows)
    command.add_option(std::string("--") + row.name, texts.*row.text, row.help)->type_name(row.values);
}

} // namespace mdm::cli
