#pragma once
/// \file
/// The second proof of a budget of particles: the next finer step needs more of them.

#include "ask/asked_search.hpp"

namespace mdm::cli {

/// Its name beside that of the answer's.
std::string finer_proof(const std::string &proof);

/// The proof, where there is one. A note of the match says where it proves less than that.
std::optional<std::string> finer_certificate(Found &found);

} // namespace mdm::cli
