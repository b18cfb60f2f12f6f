#pragma once
/// \file
/// What is known of a packing, as text, JSON and CSV.

#include <mdm/packing/texture.hpp>
#include <mdm/text/sink.hpp>

namespace mdm {

/// For people.
std::string packing_text(const Packing &packing, const PackingTexture &texture);

/// One line of JSON, schema `mdm-packing-1`, without a newline at its end. Lengths are exact decimals in the
/// packing's unit, or enclosed.
/// \param positions whether to list centre and radius of every disc
void packing_json(const Packing &packing, const PackingTexture &texture, bool positions, const Sink &sink);

/// Two lines, names and values: discs, fraction, contacts, coordination, cells and gaps.
std::string packing_csv(const Packing &packing, const PackingTexture &texture);

} // namespace mdm
