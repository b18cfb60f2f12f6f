#pragma once
/// \file
/// What src/precompiled.hpp has, Catch2, and the JSON of answers.

#include "../src/precompiled.hpp"
#include "catch.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
