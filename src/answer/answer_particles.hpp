#pragma once
/// \file
/// The particles of an answer.

#include "answer/answer_sample.hpp"
#include "particles/particle_set.hpp"

namespace mdm {

/// The particles of an answer; sizes are f^-1(scale * mass / quantity), exactly.
/// \throws InputError if that is not what the answer says, with this law and without factors, if it has a spread,
/// or if a class has no double close enough to its size
ParticleSet particle_set(const AnswerSample &answer, const MassLaw &law,
                         const ParticleSetOptions &options = {});

} // namespace mdm
