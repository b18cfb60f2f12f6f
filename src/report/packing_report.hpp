#pragma once
/// \file
/// What is known of a packing, as text, JSON and CSV.

#include "packing/texture.hpp"
#include "text/sink.hpp"

namespace mdm {

/// What mdm verify says of a packing.
struct PackingJudgement {
  std::string sizes, packing;          ///< names of the files
  std::vector<std::string> objections; ///< packing_objections()
  std::vector<std::string> unverified; ///< mdm::unverified()

  bool is_accepted() const { return objections.empty(); }
};

/// A line that accepts, or one for each objection.
std::string packing_judgement_text(const PackingJudgement &judgement);

/// For people.
std::string packing_text(const Packing &packing, const PackingTexture &texture);

/// The parts of the JSON that are there on request.
struct PackingJsonParts {
  bool positions = false; ///< centre and radius of every disc
  const PackingJudgement *judgement = nullptr;
};

/// One line of JSON, schema `mdm-packing-1`, without a newline at its end. Lengths are exact decimals in the
/// packing's unit, or enclosed.
void packing_json(const Packing &packing, const PackingTexture &texture, const PackingJsonParts &parts,
                  const Sink &sink);

/// Two lines, names and values: discs, fraction, contacts, coordination, cells and gaps.
std::string packing_csv(const Packing &packing, const PackingTexture &texture);

} // namespace mdm
