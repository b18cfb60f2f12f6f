#pragma once
/// \file
/// The gradation of a blend.

#include <mdm/gradation/gradation.hpp>

#include <string>
#include <vector>

namespace mdm {

/// The gradation of shares of the stockpiles' masses, in mm, its masses in percent or a multiple that makes
/// them decimals. Its sieves are those where all stockpiles with a share tell what passes without
/// interpolation, and `sieves` besides (mm), those of the specification.
/// \throws InputError if a stockpile with a share has density or shape factors: a class of the blend has no
/// single one; or where passing_at does
Gradation blended_gradation(const std::vector<Gradation> &stockpiles, const std::vector<Rational> &shares,
                            const std::vector<Rational> &sieves, const std::string &id);

/// The same of the stockpiles that have a share, each a material of its own (Theorem 28), with its classes as
/// they are and its density as their factor.
/// \param densities  one a stockpile, > 0
/// \throws InputError if a stockpile with a share has factors, or a name that no material has
Gradation blended_materials(const std::vector<Gradation> &stockpiles, const std::vector<Rational> &shares,
                            const std::vector<Rational> &densities, const std::string &id);

} // namespace mdm
