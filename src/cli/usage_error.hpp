#pragma once
/// \file
/// The mistake in a command line.

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace mdm::cli {

/// ` (did you mean WORD?)` with the nearest of the names; empty where none is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string> &names);

/// CLI11's message with the user's words in quotes, escaped and cut. \param app  that was parsed
std::string usage_error(const CLI::ParseError &error, const CLI::App &app);

} // namespace mdm::cli
