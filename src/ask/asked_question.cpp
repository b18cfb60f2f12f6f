#include "ask/asked_question.hpp"

#include "ask/option_values.hpp"

namespace mdm {

Question AskedQuestion::in(SizeUnit unit) const {
  Question q = rest;
  q.law = rest.law.scaled(Rational(1 / in_mm(unit)));
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

} // namespace mdm
