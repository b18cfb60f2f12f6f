#pragma once
/// \file
/// The certificate of a match by number (section 13 of proofs/certificate-format.md).

#include "match/number_match.hpp"

#include <string>

namespace mdm {

std::string number_certificate(const NumberMatch &m, const std::vector<AskedTolerance> &asked);

} // namespace mdm
