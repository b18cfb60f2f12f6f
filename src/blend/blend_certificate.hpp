#pragma once
/// \file
/// The proof of a blend.

#include <mdm/blend/blend.hpp>

namespace mdm {

/// The certificate of an answer whose status is optimal or none, in the format of
/// proofs/certificate-format.md, section 11: of the first blend, or that there is none. The checker takes the
/// specification and the stockpiles from their own files.
/// \pre the problem is that of the answer, and its aim is no widening
std::string blend_certificate(const BlendProblem &problem, const BlendAnswer &answer);

} // namespace mdm
