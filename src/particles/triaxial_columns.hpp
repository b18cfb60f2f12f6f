#pragma once

namespace mdm {

/// The first line of the log of a triaxial model. Compression is positive; p and q are in Pa; what is
/// constant is sigma_3 or p.
inline constexpr const char *triaxial_columns =
    "axial_strain,volumetric_strain,p,q,void_ratio,coordination,unbalanced_force,constant";

} // namespace mdm
