#pragma once
/// \file
/// Files of shards, joined to those of the whole.

#include "files/file_totals.hpp"
#include "files/proof_stream.hpp"
#include "text/sink.hpp"

#include <functional>
#include <vector>

namespace mdm {

/// A stream of certificates and its index.
struct ProofFiles {
  PartFile stream, index;
};

/// Hands on the lines of files, which take turns. \param wrote  called after each
/// \throws InputError if a file is not what its totals say
void join_lines(const std::vector<PartFile> &parts, std::uint64_t lines, const Sink &to,
                const std::function<void()> &wrote);

/// Adds the certificates of streams, in the order of the lines that they are of. \throws InputError likewise
void join_proofs(const std::vector<ProofFiles> &parts, ProofStream &to);

} // namespace mdm
