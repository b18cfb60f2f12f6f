#pragma once
/// \file
/// Packings judged by mdm verify.

#include <string>

namespace mdm::cli {

/// True for a file of sizes of discs, with which packings are judged.
bool is_file_of_disc_sizes(const std::string &path);

/// Writes the verdict on a packing of these sizes, and what is known of it; gives the exit code.
int verify_packing(const std::string &sizes, const std::string &packing, const std::string &out);

} // namespace mdm::cli
