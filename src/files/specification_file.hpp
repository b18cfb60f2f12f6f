#pragma once
/// \file
/// Specifications that commands take by name, or from a file.

#include <mdm/judge/specification.hpp>

#include <optional>
#include <string>

namespace mdm {

/// The one of that name that comes with the program, or that in the file; `-` for standard input.
/// \throws InputError naming the file, and the names where there is no such file
Specification specification_at(const std::string &name);

/// What the option that takes one says of it.
std::string specification_help();

/// One unit of the last digit of all percents, 0 for none; nothing: as the report has them.
/// \throws InputError naming the option
std::optional<Rational> rounding_of(const std::optional<std::string> &text);
/// What its option says of it.
std::string rounding_help();

} // namespace mdm
