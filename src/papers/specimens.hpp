#pragma once
/// \file
/// Specimens of discrete element models, and the particles that they would need.

#include <mdm/gradation/gradation.hpp>

#include <vector>

namespace mdm {

/// A cylinder of sand whose sizes were multiplied by a factor, and the particles reported for it.
struct Specimen {
  Rational diameter_mm, scale_factor, height_mm, void_ratio;
  Integer reported;
};

/// Reads a CSV with the columns diameter_mm,scale_factor,height_mm,void_ratio,particles in any order; #
/// comments.
/// \throws InputError `file:line: what is wrong and what to do`
std::vector<Specimen> read_specimens(std::string_view content, const std::string &file);

/// N of the smallest match of the gradation with the solids of the specimen.
/// \throws InputError if they do not fit
Integer least_specimen(const Gradation &g, const Specimen &specimen);

/// A row a specimen: its columns as read, n_exact, and ratio, the reported over the exact number.
std::string specimens_csv(const Gradation &g, const std::vector<Specimen> &specimens);
/// The same as a table for people.
std::string specimens_text(const Gradation &g, const std::vector<Specimen> &specimens);

} // namespace mdm
