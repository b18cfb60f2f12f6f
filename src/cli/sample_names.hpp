#pragma once
/// \file
/// Names of several samples.

#include <string>
#include <vector>

namespace mdm::cli {

/// Where samples have the same name, those of their files take its place, as the user gave them; from the
/// second time on that a file is given, with a number. \pre as many names as files
void tell_apart(const std::vector<std::string *> &names, const std::vector<std::string> &files);

} // namespace mdm::cli
