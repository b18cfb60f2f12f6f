#pragma once
/// \file
/// Headers of other libraries that most files need: parsed once a target. Every file includes what it uses
/// all the same: a build with -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON shows where one does not.

#include <boost/multiprecision/gmp.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
