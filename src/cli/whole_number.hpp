#pragma once
/// \file
/// Small whole numbers as options of CLI11.

#include <CLI/CLI.hpp>

namespace mdm::cli {

/// Makes the digits of a whole number from `least` to `most` of what an option has, such as `1e3`; refuses
/// anything else.
CLI::Validator whole_number(unsigned least, unsigned most);

} // namespace mdm::cli
