#include "plot/triaxial_figure.hpp"

#include "plot/figure_layout.hpp"
#include "plot/ranges.hpp"

namespace mdm {
namespace {

/// A curve over the axial strain in percent.
Panel triaxial_panel(std::string_view title, std::string_view unit, const std::vector<TriaxialState> &states,
                     Rational (*value)(const TriaxialState &), const FigureTexts &texts) {
  Panel panel;
  Series curve;
  Range x, y;
  x.cover(0);
  y.cover(0);
  for (const TriaxialState &s : states) {
    const Point p{to_double(Rational(100 * s.axial_strain)), to_double(value(s))};
    x.cover(p.x);
    y.cover(p.y);
    curve.points.push_back(p);
  }
  panel.title = title;
  panel.x = plain_axis(std::string(texts.axial_strain), x);
  panel.y = plain_axis(std::string(unit), y);
  panel.grid = true;
  panel.series.push_back(std::move(curve));
  return panel;
}

Rational deviator_in_kpa(const TriaxialState &s) {
  return s.q / 1000;
}

Rational volumetric_percent(const TriaxialState &s) {
  return 100 * s.volumetric_strain;
}

} // namespace

Figure triaxial_figure(const std::string &title, const TriaxialLog &log, const FigureForm &form) {
  const FigureTexts &texts = figure_texts(form.language);
  Figure figure;
  figure.title = title;
  figure.description = texts.triaxial_shown;
  figure.bare = form.bare;
  figure.panels = {
      triaxial_panel(texts.deviator, texts.deviator_unit, log.states, deviator_in_kpa, texts),
      triaxial_panel(texts.volume, texts.volumetric_strain, log.states, volumetric_percent, texts)};
  figure.notes = {std::string(texts.constant_stress) + log.constant};
  set_two_panels(figure, 320, form);
  return figure;
}

} // namespace mdm
