#pragma once
/// \file
/// How many files may be open at once.

#include <cstddef>

namespace mdm {

/// Allows that of so many shards two files are open at once.
/// \throws InputError if the system lets no process have so many
void allow_open_files(std::size_t shards);

} // namespace mdm
