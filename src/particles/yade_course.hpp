#pragma once
// The course of a model of YADE.

#include "particles/settle_script.hpp"

namespace mdm {

/// Phases fill, compact, hold, with the marks that yade_model() fills in.
std::string yade_course(const SettleScript &s);

} // namespace mdm
