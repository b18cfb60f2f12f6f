#pragma once
/// \file
/// How a figure is to look, whatever it shows, and its own words in each language.

#include "text/language.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// What is asked of a figure's form.
struct FigureForm {
  Language language = Language::english;
  double width = 0;  ///< of the picture, in pt; 0: as wide as panels of their usual width make it
  bool bare = false; ///< as Figure::bare
};

/// A figure's own words. Names, notes and remarks are not theirs: they stay as they are.
struct FigureTexts {
  // of gradations
  std::string_view size, passing, retained, analysis, particles, target, allowed, counts, outside, finer,
      no_group, bands, passing_shown, counts_shown;
  // of several gradations
  std::string_view missed, curves_shown;
  // of trade-offs
  std::string_view count, proved, at_limit, by_tolerance, by_sieve, exact_by_sieve, of_retained, of_passing,
      of_total, smallest_sieve, pan, lost, lost_at_right, tradeoff_shown;
  // of triaxial tests
  std::string_view axial_strain, deviator, deviator_unit, volume, volumetric_strain, constant_stress,
      triaxial_shown;
  // of textures
  std::string_view no_texture, texture_shown;
};

const FigureTexts &figure_texts(Language language);

/// The name of a size band such as `coarse sand` in that language, and shorter ones, longest first.
std::vector<std::string> band_names(std::string_view band, Language language);

} // namespace mdm
