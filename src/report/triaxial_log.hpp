#pragma once
/// \file
/// The log of a triaxial model of mdm export.

#include <mdm/number/rational.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// A state of the shear. Compression is positive.
struct TriaxialState {
  Rational axial_strain, volumetric_strain; ///< parts, since the shear began
  Rational p, q;                            ///< (sigma_1 + 2 sigma_3) / 3 and sigma_1 - sigma_3, in Pa
  Rational void_ratio, coordination, unbalanced_force;
};

/// A test: the states of its shear, two or more, of growing axial strain.
struct TriaxialLog {
  std::string constant; ///< the stress that was to be constant: sigma_3 or p
  std::vector<TriaxialState> states;
};

/// True for a text whose first line is that of such a log.
bool is_triaxial_log(std::string_view content);

/// `file` precedes messages. \throws InputError `file:line: what is wrong`
TriaxialLog read_triaxial_log(std::string_view content, const std::string &file);

} // namespace mdm
