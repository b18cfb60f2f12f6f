#include "ask/asked_question.hpp"

#include "ask/option_values.hpp"

namespace mdm {
namespace {

/// Refuses a length without a unit where the file has inches.
void check_unit(const char *name, const Length &length, const Gradation &g) {
  named(name, "", [&](const std::string &) { return length.in(g); });
}

} // namespace

MassLaw AskedQuestion::law_in(SizeUnit unit) const {
  return rest.law.scaled(Rational(1 / in_mm(unit)));
}

Question AskedQuestion::in(SizeUnit unit) const {
  Question q = rest;
  q.law = law_in(unit);
  if (pan_size)
    q.pan_size = pan_size->in(unit);
  if (cut_below)
    q.cut_below = cut_below->in(unit);
  if (specimen)
    q.solids = named("specimen", specimen->shape, [this, unit](const std::string &shape) {
      return parse_specimen(shape, specimen->void_ratio, unit);
    });
  return q;
}

Question AskedQuestion::of(const Gradation &g) const {
  Question q = in(g.unit());
  if (pan_size)
    check_unit("pan-size", *pan_size, g);
  if (cut_below)
    check_unit("cut-below", *cut_below, g);
  if (specimen)
    for (const Length &length :
         parse_lengths(std::string_view(specimen->shape).substr(specimen->shape.find(':') + 1)))
      check_unit("specimen", length, g);
  return q;
}

} // namespace mdm
