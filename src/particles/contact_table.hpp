#pragma once
// The table of a model's contacts in its first lines: law, stiffness, damping, friction, cohesion, time step.

#include "particles/settle_script.hpp"

namespace mdm {

/// The words of an engine for its contacts.
struct ContactWords {
  std::string contact, damping;
  const char *rolling = nullptr;         ///< its model of rolling friction; null: it has none
  const CohesionLaw *cohesion = nullptr; ///< likewise
};

/// Of grains: `restitution 0.5`.
std::string restitution_of(const SettleScript &s);

/// As comments, a line for each property or more.
std::string contact_table(const SettleScript &s, const ContactWords &words);

} // namespace mdm
