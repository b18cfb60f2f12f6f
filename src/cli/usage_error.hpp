#pragma once
/// \file
/// The mistake in a command line.

#include <CLI/CLI.hpp>

#include <string>

namespace mdm::cli {

/// CLI11's message with the user's words in quotes, escaped and cut. \param app  that was parsed
std::string usage_error(const CLI::ParseError &error, const CLI::App &app);

} // namespace mdm::cli
