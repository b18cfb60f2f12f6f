#pragma once
/// \file
/// Versions of the program and of the libraries that its results depend on.

#include <string>
#include <utility>
#include <vector>

namespace mdm {

/// Names and versions, mdm first.
const std::vector<std::pair<std::string, std::string>> &versions();

/// The same as the value of the key "versions": a JSON object.
const std::string &versions_json();

} // namespace mdm
