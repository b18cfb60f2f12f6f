#pragma once
/// \file
/// The headers of src/precompiled.hpp, and the parser of the command line.

#include "../precompiled.hpp"

#include <CLI/CLI.hpp>
