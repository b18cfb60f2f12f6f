#include "cli/finer_proof.hpp"

#include <mdm/proof/certificate.hpp>

namespace mdm::cli {

std::string finer_proof(const std::string &proof) {
  return proof + ".finer";
}

std::optional<std::string> finer_certificate(Found &found) {
  if (!found.finer || !has_certificate(*found.finer))
    return std::nullopt;
  Certified finer = certified(*found.finer);
  if (finer.bound && *finer.bound <= found.match.budget->particles)
    found.match.notes.push_back(
        "the proof for the next finer step would be too long: the one that is written is of " +
        to_string(*finer.bound) + " particles");
  return std::move(finer.text);
}

} // namespace mdm::cli
