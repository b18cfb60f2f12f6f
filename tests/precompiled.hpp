#pragma once
/// \file
/// What src/precompiled.hpp has, and Catch2.

#include "../src/precompiled.hpp"
#include "catch.hpp"

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
