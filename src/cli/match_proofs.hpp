#pragma once
/// \file
/// The certificates of what was found: of the match, and of a budget that the next finer step needs more.

#include "ask/asked_search.hpp"

namespace mdm::cli {

/// The certificate of the match. Where it is of bounds, a note of the match says so.
/// \pre has_certificate(m)
std::string noted_certificate(Match &m);

/// That of the next finer step, where there is one. A note of the match says where it proves less.
std::optional<std::string> finer_certificate(Found &found);

/// The name of that beside the other's.
std::string finer_proof(const std::string &proof);

} // namespace mdm::cli
