#pragma once

namespace mdm {

/// The first line of the log of a triaxial model. Compression is positive; p and q are in Pa.
inline constexpr const char *triaxial_columns =
    "axial_strain,volumetric_strain,p,q,void_ratio,coordination,unbalanced_force";

} // namespace mdm
