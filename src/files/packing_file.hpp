#pragma once
/// \file
/// Files of packings and of the sizes of their discs.

#include "packing/disc_sizes.hpp"
#include "packing/packing.hpp"

#include <string>

namespace mdm {

/// A line has some sixty characters, and there are up to most_discs of them.
inline constexpr std::size_t most_packing_bytes = std::size_t{1} << 30;

/// True for a file that begins as packings do; standard input is not looked at.
bool is_packing_file(const std::string &path);
/// The same for files of sizes of discs.
bool is_disc_sizes_file(const std::string &path);

/// \throws InputError as read_file() and read_packing()
Packing read_packing_file(const std::string &path);
/// \throws InputError as read_file() and read_disc_sizes()
DiscSizes read_disc_sizes_file(const std::string &path);

} // namespace mdm
