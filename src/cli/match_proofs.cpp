#include "cli/match_proofs.hpp"

#include <mdm/proof/certificate.hpp>

namespace mdm::cli {

std::string noted_certificate(Match &m) {
  Certified made = certified(m);
  if (made.bound)
    m.notes.push_back("the proof is of the bounds: N is at least " + to_string(*made.bound));
  return std::move(made.text);
}

std::optional<std::string> finer_certificate(Found &found) {
  if (!found.finer || !has_certificate(*found.finer))
    return std::nullopt;
  Certified finer = certified(*found.finer);
  if (finer.bound && *finer.bound <= found.match.budget->particles)
    found.match.notes.push_back("the proof for the next finer step would be too long: the one that is "
                                "written says that N is at least " +
                                to_string(*finer.bound));
  return std::move(finer.text);
}

std::string finer_proof(const std::string &proof) {
  return proof + ".finer";
}

} // namespace mdm::cli
