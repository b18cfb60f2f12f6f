#pragma once
/// \file
/// Memory for the numbers of a batch run.

namespace mdm {

/// Gives GMP free lists of small blocks, one set a thread, in place of malloc: a batch line makes and drops
/// some hundred numbers of a few words, and a quarter of its time went into malloc. Memory of short numbers
/// is reused, never given back. Call before the first number is made. Without effect under AddressSanitizer,
/// which is to see every block.
void use_number_pool();

} // namespace mdm
